#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace dsphere::gpu {

/// A physical device as the choice sees it.
struct Candidate {
    DeviceInfo info;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    std::uint32_t queue_family = 0;               ///< the first one with compute
    std::uint32_t timestamp_bits = 0;             ///< of that family
    std::optional<std::uint32_t> present_family;  ///< see findPresentFamilies
};

/// All devices in the loader's order.
std::vector<Candidate> describeDevices(const Instance& instance);

/// Gives each candidate the family that presents to the surface and has graphics, the one for compute where it can;
/// none without the swapchain extension. If `required`, candidates without one become unusable.
void findPresentFamilies(std::vector<Candidate>& candidates, VkSurfaceKHR surface, bool required);

/// The candidate that DeviceOptions::selector means; Error(NoDevice) if there is none or it is unusable.
const Candidate& select(const std::vector<Candidate>& candidates, const std::string& selector);

}  // namespace dsphere::gpu
