#include "base/temporaryfile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "base/atomicfile.h"
#include "base/descriptor.h"
#include "base/error.h"

namespace dsphere {

namespace fs = std::filesystem;

namespace {

// The names of those that there are, for a signal's handler; null: a free place. Commands write one at a time.
std::array<std::atomic<const char*>, 8> names = {};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal's handler reads them");

void replaceOnce(const char* old_name, const char* new_name) {
    for (std::atomic<const char*>& place : names) {
        const char* expected = old_name;
        if (place.compare_exchange_strong(expected, new_name)) return;
    }
}

bool isTemporaryName(const std::string& name) {
    constexpr std::string_view kStart = ".dsphere-", kEnd = ".tmp";
    return name.size() == kStart.size() + 16 + kEnd.size() && name.starts_with(kStart) && name.ends_with(kEnd);
}

}  // namespace

fs::path folderOf(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

fs::path temporaryName(const fs::path& target) {
    std::random_device random;
    return folderOf(target) / fmt::format(".dsphere-{:08x}{:08x}.tmp", random(), random());
}

void removeLeftovers(const fs::path& target) {
    std::error_code error;
    for (fs::directory_iterator entry(folderOf(target), error), end; !error && entry != end; entry.increment(error)) {
        if (!isTemporaryName(entry->path().filename().string())) continue;
        const Descriptor file(::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        if (file.number() >= 0 && flock(file.number(), LOCK_EX | LOCK_NB) == 0) unlink(entry->path().c_str());
    }
}

int openTemporary(const fs::path& target, fs::path& name) {
    for (;;) {
        name = temporaryName(target);
        const int descriptor = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
        if (descriptor < 0) return -1;
        flock(descriptor, LOCK_EX | LOCK_NB);
        // Another process may have taken it for a leftover before it was locked.
        struct stat made = {};
        if (fstat(descriptor, &made) != 0 || made.st_nlink > 0) return descriptor;
        close(descriptor);
    }
}

TemporaryFile::TemporaryFile(const fs::path& target) {
    checkReplaceable(target);
    target_ = resolveLinks(target);
    removeLeftovers(target_);
    descriptor_ = openTemporary(target_, name_);
    if (descriptor_ < 0) throwFailure("{}: cannot be written: {}", target.string(), lastSystemError());
    replaceOnce(nullptr, name_.c_str());
    struct stat replaced = {};
    if (stat(target_.c_str(), &replaced) == 0) fchmod(descriptor_, replaced.st_mode & 0777);
}

TemporaryFile::~TemporaryFile() {
    replaceOnce(name_.c_str(), nullptr);
    std::error_code ignored;
    fs::remove(name_, ignored);
    close(descriptor_);
}

void TemporaryFile::commit() {
    std::error_code error;
    fs::rename(name_, target_, error);
    if (error) throwFailure("{}: cannot be written: {}", target_.string(), error.message());
}

void removeTemporaryFiles() noexcept {
    for (const std::atomic<const char*>& place : names)
        if (const char* name = place) unlink(name);
}

}  // namespace dsphere
