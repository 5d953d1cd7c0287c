#include "gpu/result.h"

namespace dsphere::gpu {

std::string resultName(VkResult result) {
#define RESULT_NAME(name) \
    case name:            \
        return #name
    switch (result) {
        RESULT_NAME(VK_SUCCESS);
        RESULT_NAME(VK_NOT_READY);
        RESULT_NAME(VK_TIMEOUT);
        RESULT_NAME(VK_INCOMPLETE);
        RESULT_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
        RESULT_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
        RESULT_NAME(VK_ERROR_INITIALIZATION_FAILED);
        RESULT_NAME(VK_ERROR_DEVICE_LOST);
        RESULT_NAME(VK_ERROR_MEMORY_MAP_FAILED);
        RESULT_NAME(VK_ERROR_LAYER_NOT_PRESENT);
        RESULT_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
        RESULT_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
        RESULT_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
        RESULT_NAME(VK_ERROR_TOO_MANY_OBJECTS);
        RESULT_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
        RESULT_NAME(VK_ERROR_FRAGMENTED_POOL);
        RESULT_NAME(VK_ERROR_UNKNOWN);
        RESULT_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
        RESULT_NAME(VK_ERROR_INVALID_SHADER_NV);
        RESULT_NAME(VK_ERROR_SURFACE_LOST_KHR);
        RESULT_NAME(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR);
        RESULT_NAME(VK_ERROR_OUT_OF_DATE_KHR);
        RESULT_NAME(VK_SUBOPTIMAL_KHR);
        default:
            return fmt::format("VkResult {}", int(result));
    }
#undef RESULT_NAME
}

bool isOutOfMemory(VkResult result) {
    return result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY;
}

void check(VkResult result, const char* call) {
    if (result == VK_SUCCESS) return;
    if (result == VK_ERROR_DEVICE_LOST) {
        throwFailure(
            "{}: the device was lost (VK_ERROR_DEVICE_LOST): its driver stopped or reset it, as drivers do when one "
            "dispatch runs too long",
            call);
    }
    const std::string message = fmt::format("{} failed: {}", call, resultName(result));
    if (isOutOfMemory(result)) throw OutOfMemory(message);
    throw Error(ExitCode::Failure, message);
}

void checkLimit(std::uint64_t asked, std::uint64_t limit, const char* limit_name, const std::string& what) {
    if (asked > limit) throwFailure("{}: {} asked, but {} of this device is {}", what, asked, limit_name, limit);
}

}  // namespace dsphere::gpu
