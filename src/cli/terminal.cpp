#include "cli/terminal.h"

#include "cli/print.h"
#include "cli/signals.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace dsphere::cli {

namespace {

bool onTerminal() {
    return isatty(STDERR_FILENO) != 0;
}

}  // namespace

std::string durationText(double seconds) {
    if (seconds < 60.0) return fmt::format("{:.1f} s", seconds);
    const auto whole = std::int64_t(std::min(seconds, 1e9));
    const auto hours = whole / 3600, minutes = whole / 60 % 60;
    if (hours == 0) return fmt::format("{}:{:02}", minutes, whole % 60);
    return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
}

ProgressLine::ProgressLine(ProgressMode mode, bool quiet, std::string label)
    : shown_(!quiet && (mode == ProgressMode::Always || (mode == ProgressMode::Auto && onTerminal()))),
      percents_(!quiet && mode == ProgressMode::Lines),
      label_(std::move(label)),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

ProgressLine::~ProgressLine() {
    if (drawn_ && onTerminal()) printErr("\n");
}

void ProgressLine::draw(double share, double seconds) {
    constexpr int kBar = 24;
    const std::string times = fmt::format("{:3.0f} %  {}, {} left", 100.0 * share, durationText(seconds),
                                          durationText(share > 0.0 ? seconds * (1.0 - share) / share : 0.0));
    if (onTerminal()) {
        const int full = int(share * kBar);
        printErr("\r{}: [{:#>{}}{:.>{}}] {}  ", label_, "", full, "", kBar - full, times);
    } else {
        printErr("{}: {}\n", label_, times);
    }
    std::fflush(stderr);
}

void ProgressLine::say(const std::string& line) {
    if (shown_) printErr("{}{}\n", drawn_ && onTerminal() ? "\n" : "", line);
    drawn_ = false;
}

bool ProgressLine::update(double share) {
    const auto now = std::chrono::steady_clock::now();
    const auto since = now - last_;
    if (share < share_) start_ = now;
    share_ = share;
    bool due = since > std::chrono::milliseconds(100) || (drawn_ && share >= 1.0);
    if (!onTerminal()) due = due && (int(10.0 * share) != tenths_ || since > std::chrono::seconds(10));
    if (shown_ && due) {
        draw(share, std::chrono::duration<double>(now - start_).count());
        tenths_ = int(10.0 * share);
        last_ = now;
        drawn_ = true;
    }
    if (percents_ && int(100.0 * share) != percent_) {
        percent_ = int(100.0 * share);
        printErr("Progress: {}%\n", percent_);
    }
    return caughtSignal() == 0;
}

namespace {

// `colour` is an SGR code of ECMA-48: "1;31" bold red.
void printMessage(const char* kind, const char* colour, const std::string& message) {
    const char* no_colour = std::getenv("NO_COLOR");
    if (onTerminal() && !(no_colour && *no_colour))
        printErr("dsphere: \033[{}m{}:\033[0m {}\n", colour, kind, printable(message));
    else
        printErr("dsphere: {}: {}\n", kind, printable(message));
}

}  // namespace

void printError(const std::string& message) {
    std::istringstream lines(message);
    for (std::string line; std::getline(lines, line);) printMessage("error", "1;31", line);
}

void printNotices(const Notices& notices) {
    for (const Notice& notice : notices) {
        const bool warning = notice.kind == Notice::Kind::Warning;
        printMessage(warning ? "warning" : "note", warning ? "1;33" : "1;36", notice.text);
    }
}

}  // namespace dsphere::cli
