#pragma once

namespace dsphere::cli {

/// From here on SIGINT and SIGTERM set a flag that work in progress polls. A program that is still there 0.3 seconds
/// later is ended, and so is one that gets a second signal: files are written whole or not at all, so that nothing is
/// lost. SIGPIPE and SIGXFSZ become errors of the writes that they are about.
void catchSignals();
/// The signal that came, or 0.
int caughtSignal();

/// While one lives, work that the first signal must not cut short goes on: what would be lost is completed.
class Completing {
  public:
    Completing();
    ~Completing();
    Completing(const Completing&) = delete;
    Completing& operator=(const Completing&) = delete;
};

}  // namespace dsphere::cli
