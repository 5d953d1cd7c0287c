#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace dsphere::cli {

namespace {

volatile std::sig_atomic_t signal_caught = 0;

void onSignal(int number) {
    // A second Ctrl-C must end a program that does not get to its next poll.
    if (signal_caught) std::_Exit(128 + number);
    signal_caught = number;
}

bool onTerminal() {
    return isatty(STDERR_FILENO) != 0;
}

}  // namespace

ProgressLine::ProgressLine(ProgressMode mode, bool quiet, std::string label)
    : shown_(!quiet && (mode == ProgressMode::Always || (mode == ProgressMode::Auto && onTerminal()))),
      label_(std::move(label)),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

ProgressLine::~ProgressLine() {
    if (drawn_) fmt::print(stderr, "\n");
}

bool ProgressLine::update(double share) {
    auto now = std::chrono::steady_clock::now();
    bool due = now - last_ > std::chrono::milliseconds(100) || (drawn_ && share >= 1.0);
    if (shown_ && due) {
        double seconds = std::chrono::duration<double>(now - start_).count();
        double left = share > 0.0 ? seconds * (1.0 - share) / share : 0.0;
        fmt::print(stderr, "\r{}: {:3.0f} %  {:.1f} s, {:.1f} s left  ", label_, 100.0 * share, seconds, left);
        std::fflush(stderr);
        last_ = now;
        drawn_ = true;
    }
    return signal_caught == 0;
}

void catchSignals() {
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
}

int caughtSignal() {
    return signal_caught;
}

void printError(const std::string& message) {
    const char* no_colour = std::getenv("NO_COLOR");
    bool colour = onTerminal() && !(no_colour && *no_colour);
    fmt::print(stderr, "dsphere: {}error:{} {}\n", colour ? "\033[1;31m" : "", colour ? "\033[0m" : "", message);
}

}  // namespace dsphere::cli
