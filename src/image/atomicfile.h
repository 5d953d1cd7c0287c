#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace dsphere {

/// A file that comes into being whole or not at all: written under a temporary name beside its target, renamed by
/// commit(). Without commit() the temporary is removed and an existing target left as it was.
class AtomicFile {
  public:
    /// Creates the temporary. Throws Error (Failure) with the system's reason, also when the target exists and is not
    /// a regular file.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// These never throw: encoders differ in what they let through. The first failure is kept for commit() to tell.
    void write(const void* data, std::size_t count) noexcept;
    void seek(std::uint64_t position) noexcept;
    std::uint64_t tell() const { return position_; }

    /// Renames the temporary to the target. Throws Error (Failure) when that or any write before it failed.
    void commit();

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    [[noreturn]] void fail() const;

    std::filesystem::path target_, temporary_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t position_ = 0;
    int error_ = 0;  ///< errno of the first failure, or 0
};

}  // namespace dsphere
