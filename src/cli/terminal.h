#pragma once

#include <chrono>
#include <string>

namespace dsphere::cli {

enum class ProgressMode { Auto, Always, Never };

/// A progress line on standard error with the time that remains; shown on a terminal (Auto), always or never.
class ProgressLine {
  public:
    ProgressLine(ProgressMode mode, bool quiet, std::string label);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows the share that is done, 0 to 1. Returns false once Ctrl-C or SIGTERM has come: stop.
    bool update(double share);

  private:
    bool shown_;
    bool drawn_ = false;
    std::string label_;
    std::chrono::steady_clock::time_point start_, last_;
};

/// Turns SIGINT and SIGTERM into a flag that work in progress polls.
void catchSignals();
/// The signal that came, or 0.
int caughtSignal();

/// One line "dsphere: error: message" on standard error, coloured on a terminal unless NO_COLOR is set and not empty
/// (no-color.org).
void printError(const std::string& message);

}  // namespace dsphere::cli
