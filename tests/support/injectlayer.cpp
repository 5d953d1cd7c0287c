// A Vulkan layer that makes one call fail: DSPHERE_INJECT=vkQueueSubmit:3:-4 has the third call of vkQueueSubmit,
// counted over the process from 1, return -4, VK_ERROR_DEVICE_LOST, without reaching the driver. Calls that succeed but
// for a remark (VK_INCOMPLETE, VK_SUBOPTIMAL_KHR) do reach it. Once the device is lost, all that waits for it or gives
// it work says so too. DSPHERE_INJECT_LOG names a file that gets a line "injected NAME NUMBER" then, and lines "calls
// NAME NUMBER" at calls 1, 2, 4 and so on of a function, and at the end of the process. DSPHERE_INJECT_MOST=1000000 has
// every call of vkAllocateMemory that asks for more bytes return VK_ERROR_OUT_OF_DEVICE_MEMORY.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

// Its header, that of XCB, is needed for nothing else.
using PFN_vkCreateXcbSurfaceKHR = VkResult(VKAPI_PTR*)(VkInstance, const void*, const VkAllocationCallbacks*,
                                                       VkSurfaceKHR*);

// All functions of the program, and of GLFW in it, that return a VkResult, but those that the loader answers itself.
// clang-format off
#define INJECT_FUNCTIONS(use) \
    use(vkCreateInstance) use(vkCreateDevice) use(vkEnumeratePhysicalDevices) \
    use(vkEnumerateDeviceExtensionProperties) use(vkGetPhysicalDeviceImageFormatProperties) \
    use(vkCreateDebugUtilsMessengerEXT) use(vkCreateXcbSurfaceKHR) use(vkGetPhysicalDeviceSurfaceSupportKHR) \
    use(vkGetPhysicalDeviceSurfaceCapabilitiesKHR) use(vkGetPhysicalDeviceSurfaceFormatsKHR) \
    use(vkGetPhysicalDeviceSurfacePresentModesKHR) use(vkAllocateMemory) use(vkMapMemory) use(vkBindBufferMemory) \
    use(vkBindImageMemory) use(vkFlushMappedMemoryRanges) use(vkInvalidateMappedMemoryRanges) use(vkCreateBuffer) \
    use(vkCreateImage) use(vkCreateImageView) use(vkCreateSampler) use(vkCreateShaderModule) \
    use(vkCreateDescriptorSetLayout) use(vkCreateDescriptorPool) use(vkAllocateDescriptorSets) \
    use(vkCreatePipelineLayout) use(vkCreatePipelineCache) use(vkGetPipelineCacheData) use(vkCreateComputePipelines) \
    use(vkCreateGraphicsPipelines) use(vkCreateRenderPass) use(vkCreateFramebuffer) use(vkCreateCommandPool) \
    use(vkAllocateCommandBuffers) use(vkBeginCommandBuffer) use(vkEndCommandBuffer) use(vkResetCommandPool) \
    use(vkResetCommandBuffer) use(vkCreateQueryPool) use(vkGetQueryPoolResults) use(vkCreateFence) \
    use(vkCreateSemaphore) use(vkResetFences) use(vkGetFenceStatus) use(vkWaitForFences) use(vkQueueSubmit) \
    use(vkQueueWaitIdle) use(vkDeviceWaitIdle) use(vkCreateSwapchainKHR) use(vkGetSwapchainImagesKHR) \
    use(vkAcquireNextImageKHR) use(vkQueuePresentKHR)
// clang-format on

#define INJECT_NUMBER(name) k_##name,
enum Function : int { INJECT_FUNCTIONS(INJECT_NUMBER) kFunctions };
#define INJECT_NAME(name) #name,
constexpr const char* kNames[] = {INJECT_FUNCTIONS(INJECT_NAME)};

// One instance and one device a process are enough for the program.
PFN_vkGetInstanceProcAddr next_instance = nullptr;
PFN_vkGetDeviceProcAddr next_device = nullptr;
VkInstance instance_made = VK_NULL_HANDLE;
PFN_vkVoidFunction real[kFunctions] = {};
std::atomic<int> calls[kFunctions] = {};
std::atomic<bool> lost = false;

void log(const char* what, const char* name, int number) {
    const char* path = std::getenv("DSPHERE_INJECT_LOG");
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    std::fprintf(file, "%s %s %d\n", what, name, number);
    std::fclose(file);
}

struct CountsAtTheEnd {
    ~CountsAtTheEnd() {
        for (int f = 0; f < kFunctions; ++f)
            if (calls[f] > 0) log("calls", kNames[f], calls[f]);
    }
} counts_at_the_end;

/// The call that shall fail.
struct Wanted {
    std::string name;
    int call = 0, result = 0;

    Wanted() {
        const char* text = std::getenv("DSPHERE_INJECT");
        char function[64];
        if (text && std::sscanf(text, "%63[^:]:%d:%d", function, &call, &result) == 3) name = function;
    }
};

bool saysLost(Function f) {
    return f == k_vkWaitForFences || f == k_vkQueueSubmit || f == k_vkDeviceWaitIdle || f == k_vkQueueWaitIdle;
}

template <typename Call>
VkResult answer(Function f, const Call& call) {
    static const Wanted wanted;
    const int number = ++calls[f];
    if ((number & (number - 1)) == 0) log("calls", kNames[f], number);  // a process may end without an end
    if (lost && saysLost(f)) {
        // A lost device does no work any more: the driver below, which knows of nothing, has to end its own first.
        if (f != k_vkQueueSubmit) call();
        return VK_ERROR_DEVICE_LOST;
    }
    if (number != wanted.call || wanted.name != kNames[f]) return call();
    log("injected", kNames[f], number);
    if (wanted.result == VK_ERROR_DEVICE_LOST) lost = true;
    const auto result = VkResult(wanted.result);
    if (result != VK_INCOMPLETE && result != VK_SUBOPTIMAL_KHR) return result;
    const VkResult real_result = call();
    return real_result == VK_SUCCESS ? result : real_result;
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
    const VkResult result = answer(k_vkCreateInstance, [&] { return create(info, memory, instance); });
    if (result == VK_SUCCESS) instance_made = *instance;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* memory, VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(next_instance(instance_made, "vkCreateDevice"));
    return answer(k_vkCreateDevice, [&] { return create(physical, info, memory, device); });
}

template <typename... Arguments>
bool asksTooMuch(const Arguments&...) {
    return false;
}

bool asksTooMuch(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*, VkDeviceMemory*) {
    const char* most = std::getenv("DSPHERE_INJECT_MOST");
    return most && info->allocationSize > std::strtoull(most, nullptr, 10);
}

template <Function f, typename Pointer>
struct Hook;
template <Function f, typename... Arguments>
struct Hook<f, VkResult(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
        if (asksTooMuch(arguments...)) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        return answer(f, [&] { return reinterpret_cast<VkResult(VKAPI_PTR*)(Arguments...)>(real[f])(arguments...); });
    }
};

#define INJECT_HOOK(name) reinterpret_cast<PFN_vkVoidFunction>(Hook<k_##name, PFN_##name>::call),
const PFN_vkVoidFunction kHooks[] = {INJECT_FUNCTIONS(INJECT_HOOK)};

/// The layer's own function of that name in place of `next`, or `next`.
PFN_vkVoidFunction hooked(const char* name, PFN_vkVoidFunction next) {
    if (std::strcmp(name, "vkCreateInstance") == 0) return reinterpret_cast<PFN_vkVoidFunction>(createInstance);
    if (std::strcmp(name, "vkCreateDevice") == 0) return reinterpret_cast<PFN_vkVoidFunction>(createDevice);
    for (int f = 0; next && f < kFunctions; ++f)
        if (std::strcmp(name, kNames[f]) == 0) {
            real[f] = next;
            return kHooks[f];
        }
    return next;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    return hooked(name, next_device(device, name));
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(getInstanceProcAddr);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
    return hooked(name, next_instance ? next_instance(instance, name) : nullptr);
}

}  // namespace

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* layer) {
    layer->pfnGetInstanceProcAddr = getInstanceProcAddr;
    layer->pfnGetDeviceProcAddr = getDeviceProcAddr;
    layer->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
