#include "gpu/device.h"

#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "base/error.h"
#include "gpu/instance.h"
#include "gpu/pipeline_cache.h"
#include "gpu/pipelinestore.h"
#include "gpu/result.h"
#include "gpu/select.h"

namespace dsphere::gpu {

std::vector<DeviceInfo> listDevices() {
    const Instance instance(false);
    std::vector<DeviceInfo> infos;
    for (const Candidate& one : describeDevices(instance)) infos.push_back(one.info);
    return infos;
}

namespace {

// Mesa's CPU driver does not look whether memory for a shader was to be had, and ends the process. One shader of this
// program takes it up to 0.9 GiB of address space in all (Mesa 22.3).
constexpr rlim_t kCpuDriverBytes = rlim_t(1) << 30;

/// Whether the process may use less address space than that, in MiB.
std::optional<rlim_t> shortAddressSpace() {
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) != 0) return {};
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= kCpuDriverBytes) return {};
    return limit.rlim_cur >> 20;
}

void checkAddressSpace(const DeviceInfo& device) {
    const std::optional<rlim_t> mebibytes = shortAddressSpace();
    if (device.type != "CPU" || !mebibytes) return;
    throwFailure("{}: out of memory: the process may use {} MiB of address space (ulimit -v), and this driver needs {}",
                 device.name, *mebibytes, kCpuDriverBytes >> 20);
}

/// Returns what `find` does. Drivers that cannot be loaded for want of memory look as if there were none.
template <typename Find>
auto namingAddressSpace(Find find) {
    try {
        return find();
    } catch (const Error& error) {
        const std::optional<rlim_t> mebibytes = shortAddressSpace();
        if (error.code() != ExitCode::NoDevice || !mebibytes) throw;
        throw Error(error.code(),
                    fmt::format("{}; the process may use {} MiB of address space (ulimit -v), and a driver needs more",
                                error.what(), *mebibytes));
    }
}

// Drivers read the environment when they are loaded.
std::unique_ptr<Instance> makeInstance(const DeviceOptions& options) {
    if (!options.caches) {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
        setenv("__GL_SHADER_DISK_CACHE", "0", 0);
    }
    const std::vector<const char*> none;
    return namingAddressSpace([&] {
        return std::make_unique<Instance>(options.validation,
                                          options.presentation ? options.presentation->instance_extensions : none);
    });
}

}  // namespace

Device::Device(const DeviceOptions& options) : instance_(makeInstance(options)) {
    std::vector<Candidate> candidates = namingAddressSpace([&] { return describeDevices(*instance_); });
    if (const Presentation* presentation = options.presentation) {
        surface_.instance = instance_->handle();
        surface_.surface = presentation->make_surface(instance_->handle());
        findPresentFamilies(candidates, surface_.surface, presentation->required);
    }
    const Candidate& chosen = select(candidates, options.selector);
    info_ = chosen.info;
    checkAddressSpace(info_);
    physical_ = chosen.physical;
    queue_family_ = chosen.queue_family;
    timestamp_bits_ = chosen.timestamp_bits;
    if (chosen.present_family) present_ = {surface_.surface, *chosen.present_family, VK_NULL_HANDLE};
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    readLimits();
    createDevice();
    if (options.caches) cache_ = std::make_unique<PipelineCache>(physical_, handle(), table_);
    store_ = std::make_unique<PipelineStore>();
}

Device::~Device() {
    instance_->forgetMessages();
}

Device::Logical::~Logical() {
    if (device != VK_NULL_HANDLE) destroy(device, nullptr);
}

Device::Surface::~Surface() {
    if (surface != VK_NULL_HANDLE) vkDestroySurfaceKHR(instance, surface, nullptr);
}

void Device::readLimits() {
    VkPhysicalDeviceMaintenance3Properties maintenance = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    properties.pNext = &maintenance;
    vkGetPhysicalDeviceProperties2(physical_, &properties);
    const VkPhysicalDeviceLimits& limits = properties.properties.limits;
    limits_.max_image_dimension_2d = limits.maxImageDimension2D;
    limits_.max_image_array_layers = limits.maxImageArrayLayers;
    limits_.max_storage_buffer_range = limits.maxStorageBufferRange;
    limits_.max_uniform_buffer_range = limits.maxUniformBufferRange;
    limits_.max_allocation_size = maintenance.maxMemoryAllocationSize;
    limits_.max_push_constants_size = limits.maxPushConstantsSize;
    limits_.max_storage_buffers = limits.maxPerStageDescriptorStorageBuffers;
    limits_.max_uniform_buffers = limits.maxPerStageDescriptorUniformBuffers;
    limits_.max_storage_images = limits.maxPerStageDescriptorStorageImages;
    std::copy_n(limits.maxComputeWorkGroupCount, 3, limits_.max_workgroup_count.begin());
    for (std::uint32_t i = 0; i < memory_.memoryHeapCount; ++i) {
        if (memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
            limits_.memory_heap_size = std::max<std::uint64_t>(limits_.memory_heap_size, memory_.memoryHeaps[i].size);
        }
    }
    timestamp_period_ = double(limits.timestampPeriod);
}

void Device::createDevice() {
    const float priority = 1.0f;
    std::vector<std::uint32_t> families = {queue_family_};
    if (present_ && present_->family != queue_family_) families.push_back(present_->family);
    std::vector<VkDeviceQueueCreateInfo> queues;
    for (std::uint32_t family : families)
        queues.push_back({VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, family, 1, &priority});
    const char* const swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    VkDeviceCreateInfo create = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    create.queueCreateInfoCount = std::uint32_t(queues.size());
    create.pQueueCreateInfos = queues.data();
    create.enabledExtensionCount = present_ ? 1 : 0;
    create.ppEnabledExtensionNames = &swapchain;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical_, &create, nullptr, &device), "vkCreateDevice");
    volkLoadDeviceTable(&table_, device);
    logical_.device = device;
    logical_.destroy = table_.vkDestroyDevice;
    table_.vkGetDeviceQueue(device, queue_family_, 0, &queue_);
    setName(VK_OBJECT_TYPE_DEVICE, device, "device");
    setName(VK_OBJECT_TYPE_QUEUE, queue_, "compute queue");
    if (present_) table_.vkGetDeviceQueue(device, present_->family, 0, &present_->queue);
    createCommandPool();
}

void Device::createCommandPool() {
    VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool.queueFamilyIndex = queue_family_;
    VkCommandPool made = VK_NULL_HANDLE;
    check(table_.vkCreateCommandPool(handle(), &pool, nullptr, &made), "vkCreateCommandPool");
    command_pool_ = Handle<VkCommandPool>(handle(), made, table_.vkDestroyCommandPool);
    setName(VK_OBJECT_TYPE_COMMAND_POOL, made, "command pool");
}

const std::vector<std::string>& Device::validationMessages() const {
    return instance_->messages();
}

double Device::timestampSeconds(std::uint64_t begin, std::uint64_t end) const {
    const std::uint64_t mask = timestamp_bits_ >= 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << timestamp_bits_) - 1;
    return double((end - begin) & mask) * timestamp_period_ * 1e-9;
}

VkPipelineCache Device::pipelineCache() const {
    return cache_ ? cache_->handle() : VK_NULL_HANDLE;
}

Handle<VkDeviceMemory> Device::allocate(const VkMemoryRequirements& need, VkMemoryPropertyFlags required,
                                        VkMemoryPropertyFlags preferred, const std::string& what,
                                        VkMemoryPropertyFlags* chosen) const {
    int best = -1, best_score = -1;
    for (int i = 0; i < int(memory_.memoryTypeCount); ++i) {
        const VkMemoryPropertyFlags flags = memory_.memoryTypes[i].propertyFlags;
        if (!(need.memoryTypeBits >> i & 1u) || (flags & required) != required) continue;
        // The specification orders types by speed within equal flags, so the first of the best is taken.
        const int score = std::popcount(flags & preferred);
        if (score > best_score) best = i, best_score = score;
    }
    if (best < 0) throwFailure("{}: the device has no memory type for it", what);
    const VkMemoryType& type = memory_.memoryTypes[best];
    checkLimit(need.size, limits_.max_allocation_size, "maxMemoryAllocationSize", what);
    if (const std::uint64_t heap = memory_.memoryHeaps[type.heapIndex].size; need.size > heap)
        throw OutOfMemory(
            fmt::format("{}: out of memory, {} bytes asked, the memory heap has {}", what, need.size, heap));
    if (chosen) *chosen = type.propertyFlags;

    VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = need.size;
    info.memoryTypeIndex = std::uint32_t(best);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const VkResult result = table_.vkAllocateMemory(handle(), &info, nullptr, &memory);
    if (isOutOfMemory(result))
        throw OutOfMemory(fmt::format("{}: out of memory, {} bytes asked (vkAllocateMemory: {})", what, need.size,
                                      resultName(result)));
    check(result, "vkAllocateMemory");
    setName(VK_OBJECT_TYPE_DEVICE_MEMORY, memory, what + " memory");
    return Handle<VkDeviceMemory>(handle(), memory, table_.vkFreeMemory);
}

void Device::setNameOf(VkObjectType type, std::uint64_t object, const std::string& name) const {
    if (!instance_->hasDebugUtils()) return;
    VkDebugUtilsObjectNameInfoEXT info = {VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = name.c_str();
    vkSetDebugUtilsObjectNameEXT(handle(), &info);
}

}  // namespace dsphere::gpu
