#include "gpu/select.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

#include "base/error.h"
#include "gpu/instance.h"
#include "gpu/result.h"

namespace dsphere::gpu {
namespace {

std::string typeName(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

/// Lower is better.
int typeRank(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

std::string versionText(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

/// VkPhysicalDeviceDriverProperties came with Vulkan 1.2; before it there is only a number of the vendor's own layout.
std::string driverText(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& properties) {
    if (properties.apiVersion < VK_API_VERSION_1_2) return fmt::format("{:#x}", properties.driverVersion);
    VkPhysicalDeviceDriverProperties driver = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 all = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    all.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physical, &all);
    return driver.driverInfo[0] ? fmt::format("{} ({})", driver.driverName, driver.driverInfo)
                                : std::string(driver.driverName);
}

bool findComputeFamily(Candidate& candidate) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(candidate.physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(candidate.physical, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) {
            candidate.queue_family = i;
            candidate.timestamp_bits = families[i].timestampValidBits;
            return true;
        }
    }
    return false;
}

bool hasSwapchains(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    constexpr char kCall[] = "vkEnumerateDeviceExtensionProperties";
    check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr), kCall);
    std::vector<VkExtensionProperties> all(count);
    check(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, all.data()), kCall);
    return std::ranges::any_of(
        all, [](const auto& one) { return std::strcmp(one.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0; });
}

std::optional<std::uint32_t> presentFamily(const Candidate& candidate, VkSurfaceKHR surface) {
    if (!hasSwapchains(candidate.physical)) return {};
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(candidate.physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(candidate.physical, &count, families.data());
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!(families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT)) continue;
        VkBool32 presents = VK_FALSE;
        check(vkGetPhysicalDeviceSurfaceSupportKHR(candidate.physical, i, surface, &presents),
              "vkGetPhysicalDeviceSurfaceSupportKHR");
        if (presents && (!found || i == candidate.queue_family)) found = i;
    }
    return found;
}

Candidate describe(VkPhysicalDevice physical, int index) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    Candidate candidate;
    candidate.physical = physical;
    candidate.type = properties.deviceType;
    DeviceInfo& info = candidate.info;
    info.index = index;
    info.name = properties.deviceName;
    info.type = typeName(properties.deviceType);
    info.driver = driverText(physical, properties);
    info.api_version = versionText(properties.apiVersion);
    if (properties.apiVersion < VK_API_VERSION_1_1) {
        info.unusable_reason = fmt::format("it has Vulkan {}, at least 1.1 is needed", info.api_version);
    } else if (!findComputeFamily(candidate)) {
        info.unusable_reason = "it has no queue for compute";
    }
    info.usable = info.unusable_reason.empty();
    return candidate;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

bool matches(const Candidate& candidate, const std::string& selector) {
    if (selector.empty()) return true;
    int index = 0;
    const char* end = selector.data() + selector.size();
    if (std::ranges::all_of(selector, [](unsigned char c) { return std::isdigit(c) != 0; })) {
        const auto [stop, error] = std::from_chars(selector.data(), end, index);
        return error == std::errc() && stop == end && candidate.info.index == index;
    }
    if (lower(selector) == "cpu") return candidate.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
    return lower(candidate.info.name).find(lower(selector)) != std::string::npos;
}

std::string listText(const std::vector<Candidate>& candidates) {
    std::string text;
    for (const Candidate& one : candidates) {
        text += fmt::format("\n  {}: {} ({}){}", one.info.index, one.info.name, one.info.type,
                            one.info.usable ? "" : ", unusable: " + one.info.unusable_reason);
    }
    return text;
}

}  // namespace

std::vector<Candidate> describeDevices(const Instance& instance) {
    std::vector<Candidate> candidates;
    for (VkPhysicalDevice physical : instance.physicalDevices()) {
        candidates.push_back(describe(physical, int(candidates.size())));
    }
    return candidates;
}

void findPresentFamilies(std::vector<Candidate>& candidates, VkSurfaceKHR surface, bool required) {
    for (Candidate& one : candidates) {
        if (!one.info.usable) continue;
        one.present_family = presentFamily(one, surface);
        if (one.present_family || !required) continue;
        one.info.usable = false;
        one.info.unusable_reason = "it cannot show pictures in a window";
    }
}

const Candidate& select(const std::vector<Candidate>& candidates, const std::string& selector) {
    const Candidate* best = nullptr;
    bool any_match = false;
    for (const Candidate& one : candidates) {
        if (!matches(one, selector)) continue;
        any_match = true;
        if (!one.info.usable) continue;
        // Only without a selector is one type better than another; else the first match is meant.
        if (!best || (selector.empty() && typeRank(one.type) < typeRank(best->type))) best = &one;
    }
    if (best) return *best;
    const std::string wanted = selector.empty() ? "" : fmt::format(" matching '{}'", selector);
    throw Error(ExitCode::NoDevice, fmt::format("no {}Vulkan device{}; this machine has:{}", any_match ? "usable " : "",
                                                wanted, listText(candidates)));
}

}  // namespace dsphere::gpu
