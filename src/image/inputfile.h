#pragma once

// A map file read forwards, and the numbers in its bytes.

#include "base/error.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace dsphere {

/// A regular file of known length. Every complaint about it is an Error (InvalidInput) that begins with its name.
class InputFile {
  public:
    /// Opens the file; throws with the system's reason when it is missing, unreadable or not a regular file.
    explicit InputFile(const std::filesystem::path& path);

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    std::uint64_t remaining() const { return size_ - position_; }
    /// Reads exactly `count` bytes; throws when fewer are left.
    void read(void* to, std::size_t count);
    /// The next byte, or -1 at the end.
    int get();
    /// Reads on from that byte; throws when the file has not so many. No cost when it is the next one anyway.
    void seek(std::uint64_t position);
    /// Returns to the first byte.
    void rewind() { seek(0); }

    template <typename... Args>
    [[noreturn]] void invalid(fmt::format_string<Args...> format, Args&&... args) const {
        throwInvalid("{}: {}", name_, fmt::format(format, std::forward<Args>(args)...));
    }

  private:
    std::string name_;
    std::filebuf buffer_;
    std::uint64_t size_ = 0, position_ = 0;
};

inline std::uint16_t load16(const std::uint8_t* b) {
    return std::uint16_t(b[0] << 8 | b[1]);
}

/// Four bytes, the most significant first or (`order` little) last.
inline std::uint32_t load32(const std::uint8_t* b, std::endian order = std::endian::big) {
    if (order == std::endian::big)
        return std::uint32_t(b[0]) << 24 | std::uint32_t(b[1]) << 16 | std::uint32_t(b[2]) << 8 | b[3];
    return std::uint32_t(b[3]) << 24 | std::uint32_t(b[2]) << 16 | std::uint32_t(b[1]) << 8 | b[0];
}

inline float loadFloat(const std::uint8_t* b, std::endian order = std::endian::big) {
    return std::bit_cast<float>(load32(b, order));
}

inline double loadDouble(const std::uint8_t* b) {
    return std::bit_cast<double>(std::uint64_t(load32(b)) << 32 | load32(b + 4));
}

}  // namespace dsphere
