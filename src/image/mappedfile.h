#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <memory>

namespace dsphere {

/// A file in memory, for reading by the thread that opened it; of several the last one is closed first. Where another
/// program cuts the file short meanwhile, the system would end this one (SIGBUS); instead what is missing reads as
/// zeros, and `isCut` says so.
class MappedFile {
  public:
    /// nullptr when the system refuses. `size` is the file's, greater than 0.
    static std::unique_ptr<MappedFile> open(const std::filesystem::path& path, std::size_t size);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    void* data() const { return data_; }
    bool isCut() const { return cut_ != 0; }
    /// Gives the memory of what has been read back; it is read again where it is needed again.
    void forget() const;
    /// For the signal's handler: puts zeros in place of the page of that address; false when it is none of this file's.
    bool replacePage(const void* address);

  private:
    MappedFile(void* data, std::size_t size);

    void* data_;
    std::size_t size_;
    volatile std::sig_atomic_t cut_ = 0;
    MappedFile* previous_;  ///< the one that this thread opened before and still has
};

}  // namespace dsphere
