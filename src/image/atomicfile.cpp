#include "image/atomicfile.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace dsphere {
namespace {

/// errno of a call that failed, never 0.
int systemError() {
    return errno != 0 ? errno : EIO;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(target_, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throwFailure("{}: cannot be written: it exists and is not a regular file", target_.string());
    std::random_device random;
    temporary_ = target_.parent_path() / fmt::format(".dsphere-{:08x}{:08x}.tmp", random(), random());
    file_.reset(std::fopen(temporary_.c_str(), "wbx"));  // x: never into another's file
    if (!file_) {
        error_ = systemError();
        fail();
    }
}

AtomicFile::~AtomicFile() {
    if (temporary_.empty()) return;
    file_.reset();
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::write(const void* data, std::size_t count) noexcept {
    if (error_ == 0 && std::fwrite(data, 1, count, file_.get()) != count) error_ = systemError();
    position_ += count;
}

void AtomicFile::seek(std::uint64_t position) noexcept {
    if (error_ == 0 && std::fseek(file_.get(), long(position), SEEK_SET) != 0) error_ = systemError();
    position_ = position;
}

void AtomicFile::commit() {
    if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = systemError();
    if (error_ == 0) {
        std::error_code error;
        std::filesystem::rename(temporary_, target_, error);
        error_ = error.value();
    }
    if (error_ != 0) fail();
    temporary_.clear();
}

void AtomicFile::fail() const {
    throwFailure("{}: cannot be written: {}", target_.string(), std::strerror(error_));
}

}  // namespace dsphere
