#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace dsphere {

/// Where a file of that name is written: a symbolic link, or a chain of them, stands for what it points to, whether
/// that exists or not. Error (Failure) for links in a circle.
std::filesystem::path resolveLinks(const std::filesystem::path& path);

/// Error (Failure) when something of that name exists that is not to be replaced: no regular file, or one that may not
/// be written. A file without any write permission counts as such for root, too.
void checkReplaceable(const std::filesystem::path& path);

/// A file that comes into being whole or not at all. It is written without a name, on the file system of its target,
/// and named by commit(); a process that is killed leaves nothing. Where the file system knows no unnamed files it has
/// a temporary name beside its target, which the next AtomicFile in that folder removes if its process is gone.
///
/// A target that is a symbolic link stays one: what it points to is replaced. A file that is replaced passes its
/// permissions on. The target "-" is standard output, which commit() copies the whole file to.
class AtomicFile {
  public:
    /// Error (Failure) with the system's reason; also where checkReplaceable() objects.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// These never throw: encoders differ in what they let through. The first failure is kept for commit() to tell.
    void write(const void* data, std::size_t count) noexcept;
    void seek(std::uint64_t position) noexcept;
    std::uint64_t tell() const { return position_; }

    /// Puts the file in the target's place. Error (Failure) when that or any write before it failed: an older target is
    /// then left as it was.
    void commit();

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    [[noreturn]] void fail() const;
    bool openUnnamed();
    bool openNamed();
    int place(int descriptor);

    std::filesystem::path target_;     ///< empty: standard output
    std::filesystem::path temporary_;  ///< empty while the file has no name
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t position_ = 0;
    int error_ = 0;  ///< errno of the first failure, or 0
};

}  // namespace dsphere
