#pragma once

#include "base/notice.h"

#include <chrono>
#include <string>

namespace dsphere::cli {

enum class ProgressMode { Auto, Always, Never, Lines };

/// "4.2 s", "3:07", "1:02:03".
std::string durationText(double seconds);

/// Progress on standard error: the share that is done, the time that it took and the time that remains. On a terminal a
/// line with a bar that is drawn anew; elsewhere lines, one at every tenth and every ten seconds. Shown on a terminal
/// (Auto), always or never; or (Lines) as "Progress: 42%" at each percent.
class ProgressLine {
  public:
    ProgressLine(ProgressMode mode, bool quiet, std::string label);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows the share that is done, 0 to 1; one that is smaller than the last is of another piece of work, which is
    /// timed anew. Returns false once Ctrl-C or SIGTERM has come: stop.
    bool update(double share);
    /// A line of its own, if progress is shown.
    void say(const std::string& line);

  private:
    void draw(double share, double seconds);

    bool shown_;
    bool percents_;  ///< ProgressMode::Lines
    bool drawn_ = false;
    double share_ = 0.0;
    int tenths_ = -1;  ///< of the last line that was not drawn over
    int percent_ = -1;
    std::string label_;
    std::chrono::steady_clock::time_point start_, last_;
};

/// One line "dsphere: error: message" on standard error, coloured on a terminal unless NO_COLOR is set and not empty
/// (no-color.org).
void printError(const std::string& message);
/// One line "dsphere: note: text" or "dsphere: warning: text" for each, as printError writes them.
void printNotices(const Notices& notices);

}  // namespace dsphere::cli
