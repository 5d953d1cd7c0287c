#pragma once

#include "base/error.h"

#include <volk.h>

#include <cstdint>
#include <string>

namespace dsphere::gpu {

/// "VK_ERROR_DEVICE_LOST" and its like; "VkResult -42" for one that is not in the table.
std::string resultName(VkResult result);

/// The device's or the host's memory is out: whoever can do with less may try that.
class OutOfMemory : public Error {
  public:
    explicit OutOfMemory(const std::string& message) : Error(ExitCode::Failure, message) {}
};

bool isOutOfMemory(VkResult result);

/// Throws Error(Failure) that names the call and the result unless `result` is VK_SUCCESS; OutOfMemory if that it is.
void check(VkResult result, const char* call);

/// Throws Error(Failure) that names the limit and both numbers if `asked` is over it. `what` is the object's name.
void checkLimit(std::uint64_t asked, std::uint64_t limit, const char* limit_name, const std::string& what);

}  // namespace dsphere::gpu
