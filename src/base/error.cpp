#include "base/error.h"

#include <cerrno>
#include <cstring>

namespace dsphere {

std::string lastSystemError() {
    return std::strerror(errno);
}

}  // namespace dsphere
