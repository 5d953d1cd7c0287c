#include "geo/temporary.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "base/error.h"

namespace dsphere::geo {

namespace fs = std::filesystem;

namespace {

mode_t usersMask() {
    const mode_t mask = umask(0);
    umask(mask);
    return mask;
}

}  // namespace

Temporary::Temporary(const fs::path& target) : target_(target), name_(target.string() + ".XXXXXX") {
    const int descriptor = mkstemp(name_.data());
    if (descriptor < 0) throwFailure("{}: cannot be written: {}", target.string(), lastSystemError());
    close(descriptor);
}

Temporary::~Temporary() {
    std::error_code ignored;
    if (!done_) fs::remove(name_, ignored);
}

void Temporary::commit() {
    std::error_code error;
    fs::permissions(name_, fs::perms(0666 & ~usersMask()), error);
    fs::rename(name_, target_, error);
    if (error) throwFailure("{}: cannot be written: {}", target_.string(), error.message());
    done_ = true;
}

}  // namespace dsphere::geo
