#pragma once

#include <filesystem>

namespace dsphere {

/// The folder of a path, "." if it names none.
std::filesystem::path folderOf(const std::filesystem::path& target);
/// A name beside the target that no file has yet, which removeLeftovers() knows.
std::filesystem::path temporaryName(const std::filesystem::path& target);
/// Removes the temporary files in the target's folder whose process is gone: a living one holds a lock on its own.
void removeLeftovers(const std::filesystem::path& target);
/// Makes a file of such a name, empty, open and locked; -1 and errno where that fails.
int openTemporary(const std::filesystem::path& target, std::filesystem::path& name);

/// A file with a temporary name beside its target, for libraries that open files by their names. It takes the target's
/// place by commit(), or is removed. As with AtomicFile, which has no name until it is whole, a target that is a
/// symbolic link stays one, and what a killed process has left in that folder is removed.
class TemporaryFile {
  public:
    /// Error (Failure) when the file cannot be made, or where checkReplaceable() objects.
    explicit TemporaryFile(const std::filesystem::path& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& name() const { return name_; }
    /// Error (Failure) when the target cannot be replaced.
    void commit();

  private:
    std::filesystem::path target_, name_;
    int descriptor_ = -1;  ///< keeps the lock
};

/// Removes all that there are, for who ends the process at once; may be called from a signal's handler.
void removeTemporaryFiles() noexcept;

}  // namespace dsphere
