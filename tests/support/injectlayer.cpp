// A Vulkan layer that loses the device: the wait for a fence of a given number, counted over the process from 1, ends
// at once in VK_ERROR_DEVICE_LOST, while the device still works; so do all waits and submissions that follow.
// DSPHERE_LOSE_AT_WAIT is the number.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace {

// One instance and one device a process are enough for the program.
PFN_vkGetInstanceProcAddr next_instance = nullptr;
PFN_vkGetDeviceProcAddr next_device = nullptr;
VkInstance instance_made = VK_NULL_HANDLE;
VkDevice device_made = VK_NULL_HANDLE;
std::atomic<int> waits = 0;

bool lost() {
    const char* at = std::getenv("DSPHERE_LOSE_AT_WAIT");
    return at && waits >= std::atoi(at);
}

template <typename Info>
Info* linkOf(const void* next, VkStructureType type) {
    auto* link = static_cast<Info*>(const_cast<void*>(next));
    while (link && (link->sType != type || link->function != VK_LAYER_LINK_INFO))
        link = static_cast<Info*>(const_cast<void*>(link->pNext));
    return link;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* memory,
                                              VkInstance* instance) {
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next_instance(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, memory, instance);
    instance_made = *instance;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* memory, VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(next_instance(instance_made, "vkCreateDevice"));
    const VkResult result = create(physical, info, memory, device);
    device_made = *device;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice device, std::uint32_t count, const VkFence* fences, VkBool32 all,
                                             std::uint64_t timeout) {
    const auto wait = reinterpret_cast<PFN_vkWaitForFences>(next_device(device, "vkWaitForFences"));
    ++waits;
    return lost() ? VK_ERROR_DEVICE_LOST : wait(device, count, fences, all, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits,
                                           VkFence fence) {
    const auto submit = reinterpret_cast<PFN_vkQueueSubmit>(next_device(device_made, "vkQueueSubmit"));
    return lost() ? VK_ERROR_DEVICE_LOST : submit(queue, count, submits, fence);
}

PFN_vkVoidFunction ownFunction(const char* name) {
    if (std::strcmp(name, "vkCreateInstance") == 0) return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (std::strcmp(name, "vkCreateDevice") == 0) return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
    if (std::strcmp(name, "vkWaitForFences") == 0) return reinterpret_cast<PFN_vkVoidFunction>(waitForFences);
    if (std::strcmp(name, "vkQueueSubmit") == 0) return reinterpret_cast<PFN_vkVoidFunction>(queueSubmit);
    return nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    const PFN_vkVoidFunction own = ownFunction(name);
    return own ? own : next_device(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(getInstanceProcAddr);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    const PFN_vkVoidFunction own = ownFunction(name);
    return own ? own : next_instance(instance, name);
}

}  // namespace

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* layer) {
    layer->pfnGetInstanceProcAddr = getInstanceProcAddr;
    layer->pfnGetDeviceProcAddr = getDeviceProcAddr;
    layer->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
