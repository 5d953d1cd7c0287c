#include "cli/signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>

#include "base/temporaryfile.h"

namespace dsphere::cli {

namespace {

constexpr long kGraceNanoseconds = 300'000'000;

volatile std::sig_atomic_t signal_caught = 0;
std::atomic<int> completing = 0;
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers read it");
timer_t grace;
bool has_grace = false;

// Signal handlers call it: timers may be set there.
void startGrace() {
    itimerspec once = {};
    once.it_value.tv_nsec = kGraceNanoseconds;
    if (has_grace) timer_settime(grace, 0, &once, nullptr);
}

[[noreturn]] void endAtOnce() {
    constexpr char kMessage[] = "dsphere: error: interrupted\n";
    // Nobody is left who could be told of a failure.
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage, sizeof(kMessage) - 1);
    removeTemporaryFiles();  // all other files have no name until they are whole
    _exit(128 + signal_caught);
}

void onSignal(int number) {
    const bool again = signal_caught != 0;
    signal_caught = number;
    if (again) endAtOnce();
    startGrace();
}

void onGraceOver(int) {
    if (completing == 0) endAtOnce();
}

void handle(int number, void (*handler)(int)) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, nullptr);
}

}  // namespace

void catchSignals() {
    handle(SIGPIPE, SIG_IGN);
    handle(SIGXFSZ, SIG_IGN);
    handle(SIGALRM, onGraceOver);
    sigevent event = {};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    has_grace = timer_create(CLOCK_MONOTONIC, &event, &grace) == 0;
    handle(SIGINT, onSignal);
    handle(SIGTERM, onSignal);
}

int caughtSignal() {
    return signal_caught;
}

Completing::Completing() {
    ++completing;
}

Completing::~Completing() {
    if (--completing == 0 && signal_caught) startGrace();
}

}  // namespace dsphere::cli
