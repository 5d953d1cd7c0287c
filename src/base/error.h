#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace dsphere {

/// What the program returns to the shell; the numbers are part of the command line's contract.
enum class ExitCode : int {
    Ok = 0,
    Failure = 1,           ///< rendering or reading/writing a file failed
    Usage = 2,             ///< the command line is wrong
    InvalidInput = 3,      ///< the scene or a map is invalid
    NoDevice = 4,          ///< no usable Vulkan device
    ComparisonFailed = 5,  ///< verify found the device beyond its bounds
    Interrupted = 130,     ///< stopped by Ctrl-C
    Terminated = 143,      ///< stopped by SIGTERM
};

/// The one exception of the program. The message says where and what was expected; main prints it and exits with
/// `code()`.
class Error : public std::runtime_error {
  public:
    /// Zero bytes in the message, which what() would end at, become "\0".
    Error(ExitCode code, const std::string& message);
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// Throws an Error for a wrong command line: exit code 2.
template <typename... Args>
[[noreturn]] void throwUsage(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(ExitCode::Usage, fmt::format(format, std::forward<Args>(args)...));
}

/// Throws an Error for bad user input (scene or map): exit code 3.
template <typename... Args>
[[noreturn]] void throwInvalid(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(ExitCode::InvalidInput, fmt::format(format, std::forward<Args>(args)...));
}

/// Throws an Error for an operation that failed (I/O, device): exit code 1.
template <typename... Args>
[[noreturn]] void throwFailure(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(ExitCode::Failure, fmt::format(format, std::forward<Args>(args)...));
}

/// "No such file or directory" and its like for the current errno.
std::string lastSystemError();

}  // namespace dsphere
