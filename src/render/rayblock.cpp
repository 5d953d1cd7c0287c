#include "render/rayblock.h"

#include "render/marchpipeline.h"
#include "render/variants.h"
#include "shaders/query_filter.variants.h"
#include "shaders/query_full.variants.h"
#include "shaders/query_planet_filter.variants.h"
#include "shaders/query_planet_full.variants.h"

namespace dsphere {

namespace {

const Shaders kFilter = {kVariants_query_filter, kVariants_query_planet_filter};
const Shaders kFull = {kVariants_query_full, kVariants_query_planet_full};

constexpr std::uint32_t kGroup = GROUP_SIZE_X * GROUP_SIZE_Y;

std::uint32_t planesOf(const RayWishes& wishes) {
    return (wishes.normal ? 1u << PLANE_NX : 0u) | (wishes.lit ? 1u << PLANE_LIT : 0u) |
           (wishes.colour ? 7u << PLANE_R : 0u) | (wishes.place ? 1u << PLANE_U : 0u);
}

// In the host's memory: rays and answers are written and read once each.
gpu::Buffer hostBuffer(gpu::Device& device, std::uint64_t bytes, const char* name) {
    return gpu::Buffer(device, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Host, bytes, name);
}

std::vector<gpu::Resource> bindAll(const DeviceScene& scene, std::initializer_list<const gpu::Buffer*> buffers) {
    std::vector<gpu::Resource> resources = scene.resources();
    resources.insert(resources.end(), buffers.begin(), buffers.end());
    return resources;
}

template <typename T>
std::span<T> itemsOf(const gpu::Buffer& buffer) {
    return {reinterpret_cast<T*>(buffer.mapped().data()), buffer.size() / sizeof(T)};
}

}  // namespace

RayPipelines::RayPipelines(gpu::Device& device, const SceneTraits& traits, const RayWishes& wishes) {
    const auto make = [&device, traits, mask = planesOf(wishes)](const Shaders& shaders) {
        return makeMarchPipeline(device, traits, 1.0f, shaders.of(traits), Shader::Query, Marcher::Exact, mask);
    };
    if (traits.kinds & 1u << KIND_DISPLACED)
        full_ = std::async(std::launch::async, [make] { return make(kFull); }).share();
    first_ = make(kFilter);
}

RayBlock::RayBlock(gpu::Device& device, const RayPipelines& pipelines, const DeviceScene& scene,
                   const RayWishes& wishes, std::uint32_t objects, std::uint32_t capacity)
    : pipelines_(pipelines),
      leftovers_(device, scene.tiles(), capacity),
      rays_(hostBuffer(device, std::uint64_t(capacity) * objects * sizeof(layout::QueryRay), "rays")),
      hits_(hostBuffer(device, capacity * sizeof(layout::QueryHit), "answers")),
      looks_(hostBuffer(device, (wishes.looks() ? capacity : 1u) * sizeof(layout::QueryLook), "looks")),
      set_(device, pipelines.first(),
           bindAll(scene, {&rays_, &leftovers_.retryList(), &leftovers_.absentList(), &hits_, &looks_}), "query"),
      batch_(device, "query") {}

std::span<layout::QueryRay> RayBlock::rays() {
    return itemsOf<layout::QueryRay>(rays_);
}

std::span<const layout::QueryHit> RayBlock::hits() const {
    return itemsOf<const layout::QueryHit>(hits_);
}

std::span<const layout::QueryLook> RayBlock::looks() const {
    return itemsOf<const layout::QueryLook>(looks_);
}

void RayBlock::trace(std::uint32_t count, std::uint32_t first, std::uint32_t seed) {
    if (count == 0) return;
    rays_.flush();
    const layout::QueryParams params = {.count = count, .first = first, .seed = seed, .pad0 = 0};
    leftovers_.reset(batch_);
    batch_.bind(pipelines_.first(), set_);
    batch_.push(params);
    batch_.dispatch((count + kGroup - 1) / kGroup, 1, 1);
    leftovers_.run(batch_, set_, {pipelines_.first(), pipelines_.full()}, params);
    hits_.invalidate();
    looks_.invalidate();
}

}  // namespace dsphere
