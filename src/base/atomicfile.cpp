#include "base/atomicfile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/temporaryfile.h"

namespace dsphere {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardOutput = "-";
constexpr mode_t kPermissions = 0666;  // less the process's umask

/// errno of a call that failed, never 0.
int systemError() {
    return errno != 0 ? errno : EIO;
}

/// Copies all of a file to another, from its first byte; errno of a failure, or 0.
int copyAll(int from, int to) {
    std::vector<char> block(65536);  // stacks may be as small as that
    for (off_t at = 0;;) {
        const ssize_t got = pread(from, block.data(), block.size(), at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return got < 0 ? systemError() : 0;
        at += got;
        for (ssize_t done = 0; done < got;) {
            const ssize_t written = ::write(to, block.data() + done, std::size_t(got - done));
            if (written < 0 && errno != EINTR) return systemError();
            done += std::max<ssize_t>(written, 0);
        }
    }
}

std::string unnamedPath(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

}  // namespace

fs::path resolveLinks(const fs::path& path) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    fs::path target = path;
    for (int n = 0; n < kMostLinks; ++n) {
        std::error_code error;
        const fs::path next = fs::read_symlink(target, error);
        if (error) return target;
        target = target.parent_path() / next;  // `next` alone if it is absolute
    }
    throwFailure("{}: cannot be written: {}", path.string(), std::strerror(ELOOP));
}

void checkReplaceable(const fs::path& path) {
    struct stat there = {};
    if (stat(path.c_str(), &there) != 0) return;
    if (!S_ISREG(there.st_mode))
        throwFailure("{}: cannot be written: it exists and is not a regular file", path.string());
    const bool read_only = (there.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
    if (read_only || access(path.c_str(), W_OK) != 0)
        throwFailure("{}: cannot be written: it exists and is read-only", path.string());
}

AtomicFile::AtomicFile(fs::path target) {
    if (target == kStandardOutput) {
        file_.reset(std::tmpfile());
        if (!file_) throwFailure("standard output: no temporary file for it: {}", lastSystemError());
        return;
    }
    checkReplaceable(target);
    target_ = resolveLinks(target);
    removeLeftovers(target_);
    if (!openUnnamed() && !openNamed()) {
        error_ = systemError();
        fail();
    }
    struct stat replaced = {};
    if (stat(target_.c_str(), &replaced) == 0) fchmod(fileno(file_.get()), replaced.st_mode & 0777);
}

bool AtomicFile::openUnnamed() {
    if (access("/proc/self/fd", X_OK) != 0) return false;  // what gives it a name later
    const int descriptor = ::open(folderOf(target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kPermissions);
    if (descriptor < 0) return false;
    flock(descriptor, LOCK_EX | LOCK_NB);
    file_.reset(fdopen(descriptor, "w+b"));
    return file_ != nullptr;
}

bool AtomicFile::openNamed() {
    fs::path name;
    const int descriptor = openTemporary(target_, name);
    if (descriptor < 0) return false;
    temporary_ = name;
    file_.reset(fdopen(descriptor, "w+b"));
    return file_ != nullptr;
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t count) noexcept {
    if (count == 0) return;  // `data` may be null then, which fwrite must not be given
    if (error_ == 0 && std::fwrite(data, 1, count, file_.get()) != count) error_ = systemError();
    position_ += count;
}

void AtomicFile::seek(std::uint64_t position) noexcept {
    if (error_ == 0 && std::fseek(file_.get(), long(position), SEEK_SET) != 0) error_ = systemError();
    position_ = position;
}

// A rename replaces a file in one step, a new link cannot: an unnamed file that is to replace one is named twice.
int AtomicFile::place(int descriptor) {
    if (temporary_.empty()) {
        const std::string unnamed = unnamedPath(descriptor);
        const auto name = [&](const fs::path& path) {
            return linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
        };
        if (name(target_)) return 0;
        if (errno != EEXIST) return systemError();
        const fs::path temporary = temporaryName(target_);
        if (!name(temporary)) return systemError();
        temporary_ = temporary;
    }
    if (rename(temporary_.c_str(), target_.c_str()) != 0) return systemError();
    temporary_.clear();
    return 0;
}

void AtomicFile::commit() {
    // Some file systems tell of a failure only when the file is closed, and what has no name is gone then: the second
    // descriptor keeps it.
    const Descriptor kept(dup(fileno(file_.get())));
    if (kept.number() < 0 && error_ == 0) error_ = systemError();
    if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = systemError();
    if (error_ == 0) error_ = target_.empty() ? copyAll(kept.number(), STDOUT_FILENO) : place(kept.number());
    if (error_ != 0) fail();
}

void AtomicFile::fail() const {
    throwFailure("{}: cannot be written: {}", target_.empty() ? "standard output" : target_.string(),
                 std::strerror(error_));
}

}  // namespace dsphere
