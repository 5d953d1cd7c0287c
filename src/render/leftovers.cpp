#include "render/leftovers.h"

#include <algorithm>
#include <cstring>

namespace dsphere {

namespace {

constexpr layout::RetryHead kEmptyRetryList = {.groups = {0, 1, 1}, .count = 0, .given_up = 0};

}  // namespace

Leftovers::Leftovers(gpu::Device& device, TilePool& pool, std::uint64_t capacity)
    : retry_list_(device, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Device,
                  sizeof(layout::RetryHead) + capacity * sizeof(layout::RetryPixel), "retry list"),
      head_(device, gpu::Buffer::Usage::Staging, gpu::Buffer::Place::Host, sizeof(layout::RetryHead), "retry head"),
      absent_(device, pool, capacity) {}

void Leftovers::reset(gpu::Batch& batch) const {
    batch.write(retry_list_, &kEmptyRetryList, sizeof(kEmptyRetryList));
    absent_.reset(batch);
}

double Leftovers::run(gpu::Batch& batch, const gpu::BindingSet& set, const Pipelines& pipelines, const void* params,
                      std::uint32_t bytes) {
    const auto submit = [&] {
        if (pipelines.full) {
            batch.bind(*pipelines.full, set);
            batch.push(params, bytes);
            batch.dispatchIndirect(retry_list_);
        }
        batch.copy(retry_list_, head_, sizeof(layout::RetryHead));
        const double seconds = batch.submit();
        head_.invalidate();
        layout::RetryHead head;
        std::memcpy(&head, head_.mapped().data(), sizeof(head));
        retried_ += head.count;
        given_up_ += head.given_up;
        return seconds;
    };
    double seconds = submit();
    absent_.settle([&](std::uint32_t count) {
        batch.write(retry_list_, &kEmptyRetryList, sizeof(kEmptyRetryList));
        batch.bind(pipelines.first, set);
        batch.push(params, bytes);
        constexpr std::uint32_t kGroup = GROUP_SIZE_X * GROUP_SIZE_Y, kRow = RETRY_ROW;
        const std::uint32_t groups = (count + kGroup - 1) / kGroup;
        batch.dispatch(std::min(groups, kRow), (groups + kRow - 1) / kRow, 1);
        seconds += submit();
    });
    return seconds;
}

}  // namespace dsphere
