#include "gpu/pipelinestore.h"

#include <algorithm>
#include <utility>

namespace dsphere::gpu {

std::shared_ptr<const PipelineObjects> PipelineStore::find(std::string_view key) {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->objects;
}

void PipelineStore::keep(std::string key, std::shared_ptr<const PipelineObjects> objects) {
    const std::lock_guard lock(mutex_);
    entries_.push_front({std::move(key), std::move(objects)});
    if (entries_.size() > kMost) entries_.pop_back();
}

void PipelineStore::clear() {
    const std::lock_guard lock(mutex_);
    entries_.clear();
}

}  // namespace dsphere::gpu
