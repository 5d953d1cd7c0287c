#pragma once

// What the fuzz targets share: a folder in memory for their files, and what a reader may throw.

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace dsphere::fuzz {

/// A folder of this process under /dev/shm, gone at its end.
class Scratch {
  public:
    Scratch() : path_("/dev/shm/dsphere-fuzz-" FUZZ_NAME "-" + std::to_string(getpid())) {
        std::filesystem::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (descriptor < 0 || ::write(descriptor, bytes.data(), bytes.size()) != ssize_t(bytes.size())) std::abort();
        close(descriptor);
        return file;
    }

  private:
    std::filesystem::path path_;
};

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Calls `read`, which may throw an Error (InvalidInput) with a message. Everything else ends the process.
template <typename Read>
void expectHandled(const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        if (error.code() == ExitCode::InvalidInput && *error.what()) return;
        std::fprintf(stderr, "exit code %d: %s\n", int(error.code()), error.what());
        std::abort();
    }
}

}  // namespace dsphere::fuzz
