#include "render/filmtracer.h"

#include "base/error.h"
#include "base/threadpriority.h"
#include "gpu/device.h"
#include "render/devicefilm.h"
#include "render/variants.h"
#include "shaders/render_baseline.variants.h"
#include "shaders/render_filter.variants.h"
#include "shaders/render_full.variants.h"
#include "shaders/render_planet_baseline.variants.h"
#include "shaders/render_planet_filter.variants.h"
#include "shaders/render_planet_full.variants.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <future>
#include <thread>

namespace dsphere {

namespace {

std::uint32_t groups(std::uint32_t pixels, std::uint32_t group) {
    return (pixels + group - 1) / group;
}

// Rule L13: rows of workgroups are dealt out to so many shares, a driver for CPUs having as many threads. Rows that the
// last round of dealing adds are computed for nothing, so there are few of them.
std::uint32_t sharesOf(std::uint32_t rows, std::uint32_t threads) {
    std::uint32_t shares = std::min(rows, threads);
    while ((groups(rows, shares) * shares - rows) * 16 > rows) --shares;
    return shares;
}

std::uint64_t pixelsAtOnce(const gpu::StorageImage& film) {
    return std::min(std::uint64_t(film.width()) * film.height(), FilmTracer::kMostPixels);
}

std::vector<gpu::Resource> bindAll(const DeviceScene& scene, const gpu::StorageImage& film,
                                   const Leftovers& leftovers) {
    std::vector<gpu::Resource> resources = scene.resources();
    resources.push_back(&film);
    resources.push_back(&leftovers.retryList());
    resources.push_back(&leftovers.absentList());
    return resources;
}

const Shaders kFilter = {kVariants_render_filter, kVariants_render_planet_filter};
const Shaders kFull = {kVariants_render_full, kVariants_render_planet_full};
const Shaders kBaseline = {kVariants_render_baseline, kVariants_render_planet_baseline};

}  // namespace

// Drivers take long over each, and can take both at once. Those of CPUs leave most of the work for the first dispatch,
// and share the cores with what reads the maps: the first pipeline's work is best begun as soon as possible.
FilmPipelines::FilmPipelines(gpu::Device& device, const SceneTraits& traits, float stride, const MarchMethod& method,
                             std::uint32_t mask) {
    const auto make = [&device, traits, stride, method, mask](const Shaders& shaders) {
        return makeMarchPipeline(device, traits, stride, shaders.of(traits), Shader::Render, method, mask);
    };
    if (traits.tiles && method.marcher != Marcher::Exact)
        throwInvalid("a map that stays in its file is marched exactly alone; expected the marcher to be exact");
    columns_ = GROUP_SIZE_X * turnsOf(device, traits, method);
    const bool exact = method.marcher == Marcher::Exact;
    const auto makeFull = [make, shares_cores = runsOnCpu(device)] {
        if (shares_cores) stepBack();
        return make(kFull);
    };
    if (exact && (traits.kinds & 1u << KIND_DISPLACED)) full_ = std::async(std::launch::async, makeFull).share();
    first_ = make(exact ? kFilter : kBaseline);
}

std::future<void> makeAhead(gpu::Device& device, const SceneTraits& traits, const MarchMethod& method,
                            std::uint32_t mask) {
    if (method.marcher != Marcher::Exact) return {};
    return std::async(std::launch::async,
                      [&device, traits, method, mask] { FilmPipelines(device, traits, 1.0f, method, mask).full(); });
}

// Of a scene of nothing: a driver compiles for the kinds of what is bound, not for what is in it. Images of several
// layers, which pictures may come to, are another kind.
std::future<void> warmAhead(gpu::Device& device, const SceneTraits& traits, const MarchMethod& method,
                            std::uint32_t mask) {
    if (method.marcher != Marcher::Exact || traits.images != 0) return makeAhead(device, traits, method, mask);
    return std::async(std::launch::async, [&device, traits, method, mask] {
        FilmPipelines pipelines(device, traits, 1.0f, method, mask);
        PackedScene packed;
        packed.traits = traits;
        const DeviceScene nothing(device, packed);
        const DeviceFilm film(device, 1, 1, mask);
        FilmTracer(device, pipelines, nothing, film.image());
    });
}

FilmTracer::FilmTracer(gpu::Device& device, FilmPipelines& pipelines, const DeviceScene& device_scene,
                       const gpu::StorageImage& film)
    : pipelines_(pipelines),
      leftovers_(device, device_scene.tiles(), pixelsAtOnce(film)),
      threads_(runsOnCpu(device) ? std::max(1u, std::thread::hardware_concurrency()) : 1u),
      set_(device, pipelines.first(), bindAll(device_scene, film, leftovers_), "render"),
      batch_(device, "render") {
    warmUp();
}

// Drivers compile at the first dispatch: one without pixels pays for it, outside of the timing.
void FilmTracer::warmUp() {
    const auto dispatchNothing = [&](const gpu::ComputePipeline& pipeline) {
        batch_.bind(pipeline, set_);
        batch_.push(layout::RenderParams{});
        batch_.dispatch(1, 1, 1);
    };
    leftovers_.reset(batch_);
    dispatchNothing(pipelines_.first());
    batch_.submit();
    if (const gpu::ComputePipeline* full = pipelines_.full()) {
        dispatchNothing(*full);
        batch_.submit();
    }
}

double FilmTracer::run(std::span<const layout::RenderParams> tiles) {
    if (tiles.empty()) return 0.0;
    leftovers_.reset(batch_);
    batch_.bind(pipelines_.first(), set_);
    for (const layout::RenderParams& tile : tiles) {
        batch_.push(tile);
        const std::uint32_t rows = groups(tile.tile_y1 - tile.tile_y, GROUP_SIZE_Y), shares = sharesOf(rows, threads_);
        batch_.dispatch(groups(tile.tile_x1 - tile.tile_x, pipelines_.columns()), groups(rows, shares), shares);
    }
    return leftovers_.run(batch_, set_, {pipelines_.first(), pipelines_.full()}, tiles.front());
}

}  // namespace dsphere
