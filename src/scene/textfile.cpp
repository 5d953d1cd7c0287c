#include "scene/textfile.h"

#include "base/descriptor.h"
#include "base/error.h"
#include "base/limits.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

namespace dsphere {

namespace {

template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
    throw std::runtime_error(fmt::format(format, std::forward<Args>(args)...));
}

std::string readAll(int descriptor, const std::string& name, std::size_t most) {
    std::string text;
    std::vector<char> block(65536);  // stacks may be as small as that
    for (;;) {
        // A read would go on after a signal, a poll does not.
        pollfd wait{descriptor, POLLIN, 0};
        if (poll(&wait, 1, -1) < 0 && errno == EINTR)
            throw Error(ExitCode::Interrupted, fmt::format("interrupted while {} was read", name));
        const ssize_t count = read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("cannot read {}: {}", name, lastSystemError());
        if (count == 0) return text;
        text.append(block.data(), std::size_t(count));
        if (text.size() > most)
            throw TextTooLong(
                fmt::format("{} is too long: a scene holds at most {} bytes of text, with all that it includes", name,
                            limits::kTextBytes));
    }
}

const char* kindOf(const std::filesystem::file_status& status) {
    if (std::filesystem::is_fifo(status)) return "a FIFO";
    return std::filesystem::is_socket(status) ? "a socket" : "a device";
}

}  // namespace

bool isOpenDescriptor(const std::filesystem::path& path) {
    const std::string folder = path.parent_path().string();
    return path == "/dev/stdin" || folder == "/dev/fd" || folder == "/proc/self/fd";
}

std::string readText(const std::filesystem::path& path, std::size_t most) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status)) fail("{} is a directory, not a scene file", path.string());
    const bool regular = std::filesystem::is_regular_file(status) || isOpenDescriptor(path);
    if (std::filesystem::exists(status) && !regular)
        fail("{} is {}; supported: regular files, and - for standard input", path.string(), kindOf(status));
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) fail("cannot open {}: {}", path.string(), lastSystemError());
    return readAll(file.number(), path.string(), most);
}

std::string readStandardInput(std::size_t most) {
    return readAll(STDIN_FILENO, "standard input", most);
}

}  // namespace dsphere
