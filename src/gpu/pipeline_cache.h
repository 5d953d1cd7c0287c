#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "gpu/handle.h"

namespace dsphere::gpu {

/// The device's VkPipelineCache and its file: read at the start, written at the end if it changed. The file is named by
/// the UUIDs of device, driver and cache format. Whatever is wrong with it (unreadable, corrupt, unwritable) is silent:
/// the cache is then empty or not kept.
class PipelineCache {
  public:
    PipelineCache(VkPhysicalDevice physical, VkDevice device, const VolkDeviceTable& table);
    ~PipelineCache();
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_.get(); }

    /// $XDG_CACHE_HOME/dsphere, else $HOME/.cache/dsphere; empty if neither variable holds an absolute path.
    static std::filesystem::path folder();

  private:
    VkDevice device_;
    const VolkDeviceTable* table_;
    std::filesystem::path file_;  ///< empty: not kept
    std::vector<std::byte> loaded_;
    Handle<VkPipelineCache> cache_;
};

}  // namespace dsphere::gpu
