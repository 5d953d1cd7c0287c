#pragma once

#include "gpu/handle.h"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace dsphere::gpu {

/// What a compute pipeline is made of.
struct PipelineObjects {
    Handle<VkDescriptorSetLayout> set_layout;
    Handle<VkPipelineLayout> layout;
    Handle<VkPipeline> pipeline;
};

/// The pipelines that a device used last. Drivers take from a tenth of a second to seconds to translate one, and not
/// all of them (lavapipe) keep anything in a VkPipelineCache (rule L11); here a shader that comes back specialised as
/// before is found as it was, for the life of the device. For any thread.
class PipelineStore {
  public:
    static constexpr std::size_t kMost = 24;

    /// Null if there is none. `key` tells all that the pipeline was made from.
    std::shared_ptr<const PipelineObjects> find(std::string_view key);
    /// Forgets the one that was used least recently, if there are more than kMost.
    void keep(std::string key, std::shared_ptr<const PipelineObjects> objects);
    /// For those who measure what making them takes.
    void clear();

  private:
    struct Entry {
        std::string key;
        std::shared_ptr<const PipelineObjects> objects;
    };

    std::mutex mutex_;
    std::list<Entry> entries_;  ///< the last used first
};

}  // namespace dsphere::gpu
