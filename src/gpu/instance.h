#pragma once

#include <volk.h>

#include <string>
#include <vector>

#include "gpu/device.h"

namespace dsphere::gpu {

/// The VkInstance with the debug messenger. Not movable: the messenger points at `messages_`.
class Instance {
  public:
    /// Error(NoDevice) without a loader or a driver, or without `more_extensions`; Error(Failure) if validation is
    /// asked for and not installed.
    explicit Instance(bool validation, const std::vector<const char*>& more_extensions = {});
    /// Messages that nobody can read any more (those since forgetMessages()) go to stderr.
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return instance_; }
    bool hasDebugUtils() const { return debug_utils_; }
    const std::vector<std::string>& messages() const { return messages_; }
    /// Marks the messages so far as read.
    void forgetMessages() { messages_.clear(); }

    /// In the loader's order; never empty, Error(NoDevice) instead.
    std::vector<VkPhysicalDevice> physicalDevices() const;

  private:
    void createMessenger(const VkDebugUtilsMessengerCreateInfoEXT& create);

    std::vector<std::string> messages_;
    bool debug_utils_ = false;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace dsphere::gpu
