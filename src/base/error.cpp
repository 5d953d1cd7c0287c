#include "base/error.h"

#include <cerrno>
#include <cstring>

namespace dsphere {

namespace {

std::string withoutZeros(std::string text) {
    for (std::size_t at; (at = text.find('\0')) != std::string::npos;) text.replace(at, 1, "\\0");
    return text;
}

}  // namespace

Error::Error(ExitCode code, const std::string& message) : std::runtime_error(withoutZeros(message)), code_(code) {}

std::string lastSystemError() {
    return std::strerror(errno);
}

}  // namespace dsphere
