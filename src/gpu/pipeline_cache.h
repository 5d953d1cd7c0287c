#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "gpu/handle.h"

namespace dsphere::gpu {

/// The device's VkPipelineCache and its file: read at the start, written at the end if it changed. The file lies in
/// cacheFolder() and is named by the UUIDs of device, driver and cache format. Whatever is wrong with it (unreadable,
/// corrupt, unwritable) is silent: the cache is then empty or not kept.
class PipelineCache {
  public:
    PipelineCache(VkPhysicalDevice physical, VkDevice device, const VolkDeviceTable& table);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_.get(); }

  private:
    VkDevice device_;
    const VolkDeviceTable* table_;
    std::filesystem::path file_;  ///< empty: not kept
    std::vector<std::byte> loaded_;
    Handle<VkPipelineCache> cache_;
};

}  // namespace dsphere::gpu
