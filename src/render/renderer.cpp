#include "render/renderer.h"

#include "base/error.h"
#include "gpu/device.h"
#include "render/pass.h"

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

Renderer::Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method)
    : device_(device),
      packed_(packed),
      device_scene_(device, packed),
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

// Rounds of tiles: as many a round as fit the time target and the pass.
void Renderer::runTiles(Pass& pass, int sample, std::uint32_t seed, const Progress& progress) {
    std::vector<layout::RenderParams> round;
    std::uint64_t pixels = 0;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        const Box& box = tiles_[tile];
        round.push_back({box.x0, box.y0, box.x1, box.y1, crop_.x0, crop_.y0, sample, seed});
        pixels += std::uint64_t(box.width()) * std::uint64_t(box.height());
        bool last = tile + 1 == tiles_.size();
        if (!last && round.size() < tiles_at_once_ && pixels + kTileRows * kTileColumns <= Pass::kMostPixels) continue;
        const auto started = std::chrono::steady_clock::now();
        double seconds = pass.run(round);
        stats_.device_seconds += seconds;
        stats_.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        if (seconds < 0.5 * kSubmitTarget) tiles_at_once_ = std::min(2 * tiles_at_once_, tiles_.size());
        if (seconds > 2.0 * kSubmitTarget) tiles_at_once_ = std::max<std::size_t>(1, tiles_at_once_ / 2);
        round.clear();
        pixels = 0;
        if (progress && !progress(double(tile + 1) / double(tiles_.size())))
            throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
    }
    stats_.camera_rays += crop_.width() * std::uint64_t(crop_.height());
}

PassPipelines& Renderer::pipelinesFor(std::uint32_t mask) {
    auto found = pipelines_.find({method_, mask});
    if (found == pipelines_.end())
        found = pipelines_.emplace(std::pair(method_, mask), PassPipelines(device_, packed_, method_, mask)).first;
    return found->second;
}

Image Renderer::render(std::uint32_t mask, int samples, std::uint32_t seed, const Progress& progress) {
    Film film(device_, crop_, mask);
    Pass pass(device_, pipelinesFor(mask), device_scene_, film.image);
    tiles_at_once_ = 1;
    // No samples: the pixels' centres, which are sample -1.
    int first = samples == 0 ? -1 : 0, count = std::max(samples, 1);
    for (int k = 0; k < count; ++k) {
        auto part = [&](double share) { return !progress || progress((k + share) / count); };
        runTiles(pass, first + k, seed, part);
    }
    stats_.retried_pixels += pass.retried();
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
