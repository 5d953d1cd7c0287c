#pragma once

// Choice of a Vulkan device, and the device itself with its queue for compute. Vulkan 1.1 is the minimum.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/handle.h"

namespace dsphere::gpu {

class Instance;
class PipelineCache;
class PipelineStore;

/// One physical device as `dsphere devices` prints it.
struct DeviceInfo {
    int index = 0;  ///< the loader's order; valid as a selector
    std::string name;
    std::string type;         ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;       ///< name and version as the driver tells them
    std::string api_version;  ///< "1.3.230"
    bool usable = false;
    std::string unusable_reason;  ///< empty if usable
};

/// Every device of this machine, unusable ones included; never empty. Error(NoDevice) without a loader or a driver.
std::vector<DeviceInfo> listDevices();

/// What a device needs to show pictures in a window.
struct Presentation {
    std::vector<const char*> instance_extensions;
    std::function<VkSurfaceKHR(VkInstance)> make_surface;  ///< throws Error; the device destroys what it made
    bool required = false;  ///< only devices that can present are usable; else Device::presentation() may be empty
};

struct DeviceOptions {
    /// "" (the best: discrete, integrated, virtual, CPU, other), a decimal index, "cpu" (the first CPU device), or a
    /// part of the name in any case.
    std::string selector;
    /// Loads VK_LAYER_KHRONOS_validation with core and synchronization checks; Error(Failure) if it is not installed.
    bool validation = false;
    /// Unset: no window. It is used by the constructor alone.
    const Presentation* presentation = nullptr;
    /// False: every pipeline is compiled anew, as on a machine that never ran it. Nothing is read or kept, and Mesa and
    /// NVIDIA's driver are told so by their environment variables, where those are not set: for the rest of the
    /// process, and for a driver that is not loaded yet.
    bool caches = true;
};

/// What resource creation is held to. Sizes are in bytes.
struct Limits {
    std::uint32_t max_image_dimension_2d = 0;
    std::uint32_t max_image_array_layers = 0;
    std::uint64_t max_storage_buffer_range = 0;
    std::uint64_t max_uniform_buffer_range = 0;
    std::uint64_t max_allocation_size = 0;  ///< of one buffer or image
    std::uint64_t memory_heap_size = 0;     ///< of the largest device-local heap
    std::uint32_t max_push_constants_size = 0;
    std::uint32_t max_storage_buffers = 0;  ///< in one shader, as the next two
    std::uint32_t max_uniform_buffers = 0;
    std::uint32_t max_storage_images = 0;
    std::array<std::uint32_t, 3> max_workgroup_count = {};
};

/// Where a device shows pictures. The family has graphics, transfers and presentation.
struct PresentQueue {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    VkQueue queue = VK_NULL_HANDLE;
};

/// An instance, a logical device and one queue with compute. Everything made from it must be gone before it goes.
/// For one thread at a time, but for the making of pipelines. All calls into Vulkan that fail throw Error(Failure) with
/// the call's and the result's name.
class Device {
  public:
    /// Error(NoDevice) when nothing matches, the match is unusable, or there is no loader; it lists what exists.
    explicit Device(const DeviceOptions& options = {});
    /// Writes the pipeline cache, if there is one. Validation messages that arrive from here on (leaks) go to stderr.
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const DeviceInfo& info() const { return info_; }
    const Limits& limits() const { return limits_; }
    /// Validation warnings and errors so far, oldest first; always empty without DeviceOptions::validation.
    const std::vector<std::string>& validationMessages() const;

    /// False: Batch::submit() measures on the host's clock.
    bool hasTimestamps() const { return timestamp_bits_ != 0; }
    /// Seconds from one timestamp to a later one; the counter may have wrapped once between.
    double timestampSeconds(std::uint64_t begin, std::uint64_t end) const;

    VkDevice handle() const { return logical_.device; }
    VkPhysicalDevice physical() const { return physical_; }
    /// The device's own entry points.
    const VolkDeviceTable& vk() const { return table_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queueFamily() const { return queue_family_; }
    VkCommandPool commandPool() const { return command_pool_.get(); }
    /// VK_NULL_HANDLE without DeviceOptions::caches.
    VkPipelineCache pipelineCache() const;
    PipelineStore& pipelineStore() { return *store_; }
    /// Empty without DeviceOptions::presentation, or where this device cannot present. The queue may be queue().
    const std::optional<PresentQueue>& presentation() const { return present_; }

    /// Memory for a buffer or image, of a type that has `required` flags and, where one exists, `preferred` ones too.
    /// Error(Failure) beyond the limits, OutOfMemory when memory is out; it says how many bytes were asked for `what`.
    /// `chosen` receives the flags of the memory type.
    Handle<VkDeviceMemory> allocate(const VkMemoryRequirements& need, VkMemoryPropertyFlags required,
                                    VkMemoryPropertyFlags preferred, const std::string& what,
                                    VkMemoryPropertyFlags* chosen = nullptr) const;

    /// Names an object for validation messages and debuggers; does nothing without VK_EXT_debug_utils.
    template <typename T>
    void setName(VkObjectType type, T object, const std::string& name) const {
        setNameOf(type, reinterpret_cast<std::uint64_t>(object), name);
    }

  private:
    /// vkDestroyDevice has another shape than the rest, hence its own owner.
    struct Logical {
        VkDevice device = VK_NULL_HANDLE;
        PFN_vkDestroyDevice destroy = nullptr;
        Logical() = default;
        Logical(const Logical&) = delete;
        Logical& operator=(const Logical&) = delete;
        ~Logical();
    };

    /// Goes after the device and before the instance.
    struct Surface {
        VkInstance instance = VK_NULL_HANDLE;
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        Surface() = default;
        Surface(const Surface&) = delete;
        Surface& operator=(const Surface&) = delete;
        ~Surface();
    };

    void readLimits();
    void createDevice();
    void createCommandPool();
    void setNameOf(VkObjectType type, std::uint64_t object, const std::string& name) const;

    std::unique_ptr<Instance> instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    DeviceInfo info_;
    Limits limits_;
    VkPhysicalDeviceMemoryProperties memory_ = {};
    std::uint32_t queue_family_ = 0;
    std::uint32_t timestamp_bits_ = 0;  ///< 0: no timestamps
    double timestamp_period_ = 0.0;     ///< nanoseconds a tick
    VolkDeviceTable table_ = {};
    Surface surface_;
    Logical logical_;
    std::optional<PresentQueue> present_;
    VkQueue queue_ = VK_NULL_HANDLE;
    Handle<VkCommandPool> command_pool_;
    std::unique_ptr<PipelineCache> cache_;
    std::unique_ptr<PipelineStore> store_;
};

}  // namespace dsphere::gpu
