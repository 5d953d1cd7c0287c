#pragma once

// Runs the real program.

#include <filesystem>
#include <string>
#include <vector>

namespace dsphere::test {

struct Launch {
    std::vector<std::string> arguments = {};
    std::filesystem::path folder = {};          ///< where it runs
    std::vector<std::string> environment = {};  ///< NAME=value, besides the tests' own
    std::string input = {};                     ///< what it reads from standard input
    bool terminal = false;                      ///< standard error is a terminal; its lines then end in \r\n
    int signal = 0;                             ///< sent as soon as standard error has a line's worth
};

struct Outcome {
    int code = -1;  ///< exit code, or minus the signal that ended it
    std::string out, err;
};

/// Error (Failure) when it cannot be started.
Outcome launch(const Launch& launch);

}  // namespace dsphere::test
