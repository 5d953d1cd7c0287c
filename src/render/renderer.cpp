#include "render/renderer.h"

#include "base/error.h"
#include "gpu/device.h"
#include "render/marchpipeline.h"
#include "shaders/render.spv.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cstring>
#include <limits>

namespace dsphere {

namespace {

// Tiles follow the objects' silhouettes; a dispatch costs 14 us on lavapipe. Multiples of the group size.
constexpr int kTileRows = 16, kTileColumns = 2048;
// Work handed over at once stays well below every driver's watchdog (2 s the shortest).
constexpr double kSubmitTarget = 0.05;

int groups(int pixels, int group) {
    return (pixels + group - 1) / group;
}

std::vector<Box> makeTiles(const std::vector<Span>& spans) {
    std::vector<Box> tiles;
    int height = int(spans.size());
    for (int y = 0; y < height; y += kTileRows) {
        int y1 = std::min(y + kTileRows, height);
        Span all;
        for (int row = y; row < y1; ++row) {
            const Span& span = spans[std::size_t(row)];
            if (span.empty()) continue;
            all = all.empty() ? span : Span{std::min(all.x0, span.x0), std::max(all.x1, span.x1)};
        }
        for (int x = all.x0; x < all.x1; x += kTileColumns)
            tiles.push_back({x, y, std::min(x + kTileColumns, all.x1), y1});
    }
    return tiles;
}

}  // namespace

struct Renderer::Film {
    gpu::StorageImage image;
    std::uint32_t mask;

    Film(gpu::Device& device, const Box& box, std::uint32_t planes)
        : image(device, gpu::Format::R32Uint, std::uint32_t(box.width()), std::uint32_t(box.height()),
                std::uint32_t(std::popcount(planes)), "film"),
          mask(planes) {
        image.clear();
    }

    Image read(const Box& data, const Box& display) const {
        Image result{data, display, {}};
        std::uint32_t layer = 0;
        for (const PlaneInfo& info : planeInfos()) {
            if (!(mask & planeBit(info.plane))) continue;
            Channel& channel = info.is_uint ? result.addUint(info.channel) : result.addFloat(info.channel);
            void* target = info.is_uint ? static_cast<void*>(channel.uints().data()) : channel.floats().data();
            image.download(layer++, 0, 0, image.width(), image.height(), target);
        }
        return result;
    }
};

struct Renderer::Pass {
    const gpu::ComputePipeline& pipeline;
    const gpu::BindingSet& set;
    std::uint32_t seed;
    std::size_t tiles_at_once = 1;
};

Renderer::Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method)
    : device_(device),
      packed_(packed),
      device_scene_(device, packed),
      batch_(device, "render"),
      method_(method),
      crop_(cropBox(scene.film)),
      display_{0, 0, scene.film.width, scene.film.height},
      spans_(objectSpans(packed.objects, crop_)),
      tiles_(makeTiles(spans_)) {}

void Renderer::setCamera(const Scene& scene) {
    device_scene_.updateObjects(packed_);
    crop_ = cropBox(scene.film);
    display_ = {0, 0, scene.film.width, scene.film.height};
    spans_ = objectSpans(packed_.objects, crop_);
    tiles_ = makeTiles(spans_);
}

// One tile after another, as many a submission as fit the time target.
void Renderer::runTiles(Pass& pass, int sample, double done_before, double share, const Progress& progress) {
    std::size_t count = tiles_.size();
    for (std::size_t tile = 0; tile < count;) {
        std::size_t end = std::min(tile + pass.tiles_at_once, count);
        batch_.bind(pass.pipeline, pass.set);
        for (std::size_t k = tile; k < end; ++k) {
            const Box& box = tiles_[k];
            batch_.push(layout::RenderParams{box.x0, box.y0, box.x1, box.y1, crop_.x0, crop_.y0, sample, pass.seed});
            batch_.dispatch(std::uint32_t(groups(box.width(), GROUP_SIZE_X)),
                            std::uint32_t(groups(box.height(), GROUP_SIZE_Y)), 1);
        }
        const auto submitted = std::chrono::steady_clock::now();
        double seconds = batch_.submit();
        stats_.device_seconds += seconds;
        stats_.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - submitted).count();
        if (seconds < 0.5 * kSubmitTarget) pass.tiles_at_once = std::min(2 * pass.tiles_at_once, count);
        if (seconds > 2.0 * kSubmitTarget) pass.tiles_at_once = std::max<std::size_t>(1, pass.tiles_at_once / 2);
        tile = end;
        if (progress && !progress(done_before + share * double(tile) / double(count)))
            throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
    }
    stats_.camera_rays += crop_.width() * std::uint64_t(crop_.height());
}

const gpu::ComputePipeline& Renderer::pipelineFor(std::uint32_t mask) {
    auto found = pipelines_.find({method_, mask});
    if (found == pipelines_.end())
        found = pipelines_
                    .emplace(std::pair(method_, mask),
                             makeMarchPipeline(device_, packed_, kSpirv_render, Shader::Render, method_, mask))
                    .first;
    return found->second;
}

Image Renderer::render(std::uint32_t mask, int samples, std::uint32_t seed, const Progress& progress) {
    const gpu::ComputePipeline& pipeline = pipelineFor(mask);
    Film film(device_, crop_, mask);
    std::vector<gpu::Resource> resources = device_scene_.resources();
    resources.push_back(&film.image);
    gpu::BindingSet set(device_, pipeline, resources, "render");
    // Drivers compile at the first dispatch: let one without pixels pay for it, outside of the timing.
    batch_.bind(pipeline, set);
    batch_.push(layout::RenderParams{});
    batch_.dispatch(1, 1, 1);
    batch_.submit();

    Pass pass{pipeline, set, seed};
    if (samples == 0) runTiles(pass, -1, 0.0, 1.0, progress);
    for (int sample = 0; sample < samples; ++sample)
        runTiles(pass, sample, double(sample) / samples, 1.0 / samples, progress);
    Image image = film.read(crop_, display_);
    fillMisses(image);
    return image;
}

// Pixels that no dispatch reached are zero; a miss has an infinite t.
void Renderer::fillMisses(Image& image) const {
    for (Channel& channel : image.channels) {
        if (channel.name != "t") continue;
        std::size_t width = std::size_t(crop_.width());
        std::vector<bool> reached(width * spans_.size());
        for (const Box& box : tiles_)
            for (int y = box.y0; y < box.y1; ++y)
                std::fill_n(reached.begin() + std::ptrdiff_t(std::size_t(y) * width) + box.x0, box.width(), true);
        for (std::size_t i = 0; i < reached.size(); ++i)
            if (!reached[i]) channel.floats()[i] = std::numeric_limits<float>::infinity();
    }
}

Image Renderer::renderColour(int samples, std::uint32_t seed, const Progress& progress) {
    assert(samples >= 1);
    Image image = render(kColourPlanes, samples, seed, progress);
    for (Channel& channel : image.channels)
        for (float& value : channel.floats()) value /= float(samples);
    return image;
}

Image Renderer::renderPlanes(std::uint32_t mask, const Progress& progress) {
    return render(mask, 0, 0, progress);
}

}  // namespace dsphere
