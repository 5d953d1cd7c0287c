#include "cli/print.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace dsphere::cli {

namespace {

int output_error = 0;  // errno of the first failure, or 0

void keepError() {
    if (output_error == 0) output_error = errno != 0 ? errno : EIO;
}

}  // namespace

// Descriptors are given out from the lowest that is free. Standard output is not opened for writing: what is printed
// there fails, as it does where it is closed.
void openClosedStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

std::string printable(std::string_view text) {
    constexpr std::size_t kMost = 4096;
    std::string result;
    for (const char c : text.substr(0, kMost)) {
        if ((c >= 0 && c < ' ' && c != '\t') || c == '\x7f')
            result += fmt::format("\\x{:02x}", int(c));
        else
            result += c;
    }
    return text.size() > kMost ? result + "..." : result;
}

void printText(std::string_view text) {
    if (output_error == 0 && std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) keepError();
}

void printErrorText(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void finishOutput() {
    if (std::fflush(stdout) != 0) keepError();
    if (output_error != 0) throwFailure("standard output: cannot be written: {}", std::strerror(output_error));
}

}  // namespace dsphere::cli
