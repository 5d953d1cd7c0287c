#pragma once

// Runs the real program.

#include <sys/resource.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dsphere::test {

inline constexpr const char* kClosed = "closed";

struct Launch {
    std::vector<std::string> arguments = {};
    std::filesystem::path folder = {};          ///< where it runs
    std::vector<std::string> environment = {};  ///< NAME=value, besides the tests' own
    std::string input = {};                     ///< what it reads from standard input
    bool terminal = false;                      ///< standard error is a terminal; its lines then end in \r\n
    int signal = 0;                             ///< sent as soon as standard error has a line's worth,
    int signal_after_ms = -1;                   ///< or that long after the start; 0 or more
    std::string out_to = {}, err_to = {};       ///< a file that takes the stream in place of the Outcome, or kClosed
    std::vector<std::pair<__rlimit_resource_t, rlim_t>> limits = {};
};

struct Outcome {
    int code = -1;  ///< exit code, or minus the signal that ended it
    std::string out, err;
    long peak_kib = 0;  ///< most memory that it held at a time
};

/// Error (Failure) when it cannot be started.
Outcome launch(const Launch& launch);

}  // namespace dsphere::test
