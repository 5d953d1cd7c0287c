#include "host/hostrenderer.h"

#include "base/error.h"
#include "base/parallel.h"
#include "render/planes.h"
#include "render/raster.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cstring>
#include <limits>
#include <mutex>

namespace dsphere::host {

namespace {

// Whole workgroups; small, for the cores to come out even.
constexpr int kTileColumns = 8 * GROUP_SIZE_X, kTileRows = GROUP_SIZE_Y;

std::vector<Box> tilesOf(const std::vector<Span>& spans) {
    std::vector<Box> tiles;
    const int height = int(spans.size());
    for (int y = 0; y < height; y += kTileRows) {
        const int y1 = std::min(y + kTileRows, height);
        int x0 = std::numeric_limits<int>::max(), x1 = 0;
        for (int row = y; row < y1; ++row) {
            const Span& span = spans[std::size_t(row)];
            if (span.empty()) continue;
            x0 = std::min(x0, span.x0);
            x1 = std::max(x1, span.x1);
        }
        for (int x = x0; x < x1; x += kTileColumns) tiles.push_back({x, y, std::min(x + kTileColumns, x1), y1});
    }
    return tiles;
}

/// Calls use(layer, info) for the planes of a mask, in the order of their layers.
template <typename Use>
void forPlanes(std::uint32_t mask, Use use) {
    int layer = 0;
    for (const PlaneInfo& info : planeInfos())
        if (mask & planeBit(info.plane)) use(layer++, info);
}

}  // namespace

HostRenderer::HostRenderer(const PackedScene& packed, const Scene& scene, const MarchMethod& method,
                           Precision precision)
    : scene_(packed),
      state_(packed.state),
      method_(method),
      stride_(safeStride(packed, method)),
      kernels_(kernelsFor(packed.traits, method, precision)) {
    setCamera(scene);
}

void HostRenderer::setCamera(const Scene& scene) {
    packCamera(state_, scene);
    scene_.setState(state_);
    display_ = {0, 0, scene.film.width, scene.film.height};
    setCrop(cropBox(scene.film));
}

void HostRenderer::setCrop(const Box& crop) {
    crop_ = crop;
    tiles_ = tilesOf(shownSpans(scene_.packed().traits, state_.objects, crop_));
}

void HostRenderer::setLook(const Scene& scene, const SceneMaps& maps) {
    packLook(state_, scene_.packed().tables, scene, maps);
    scene_.setState(state_);
}

void HostRenderer::setPacking(const PackedScene& packed) {
    state_ = packed.state;
    scene_.setPacking(packed);
    stride_ = safeStride(packed, method_);
}

// Zeroed; pixels that no tile holds are misses, with an infinite t.
HostFilm HostRenderer::makeFilm(std::uint32_t mask) const {
    const std::size_t pixels = std::size_t(crop_.width()) * std::size_t(crop_.height());
    HostFilm film{crop_.width(), crop_.height(), std::vector<std::uint32_t>(pixels * std::size_t(std::popcount(mask)))};
    forPlanes(mask, [&](int layer, const PlaneInfo& info) {
        if (info.plane == PLANE_T)
            std::fill_n(film.words.begin() + std::ptrdiff_t(pixels) * layer, pixels,
                        std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity()));
    });
    return film;
}

void HostRenderer::runTiles(HostFilm& film, std::uint32_t mask, int sample, std::uint32_t seed,
                            const Progress& progress) {
    const auto started = std::chrono::steady_clock::now();
    const Specialization specialization = specializationOf(scene_.packed().traits, stride_, method_, mask);
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(tiles_.size(), [&](std::size_t i) {
        const Box& box = tiles_[i];
        const layout::RenderParams tile = {box.x0, box.y0, box.x1, box.y1, crop_.x0, crop_.y0, sample, seed};
        std::vector<layout::RetryPixel> retry;
        std::uint32_t given_up = kernels_.first(scene_, specialization, tile, film, retry);
        if (!retry.empty()) given_up += kernels_.full(scene_, specialization, tile, film, retry);
        std::lock_guard lock(mutex);
        stats_.given_up_pixels += given_up;
        stats_.retried_pixels += retry.size();
        if (progress && !progress(double(++done) / double(tiles_.size())))
            throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    stats_.device_seconds += seconds;
    stats_.wall_seconds += seconds;
    stats_.camera_rays += film.width * std::uint64_t(film.height);
}

Image HostRenderer::read(const HostFilm& film, std::uint32_t mask) const {
    Image image{crop_, display_, {}};
    const std::size_t pixels = image.pixelCount();
    forPlanes(mask, [&](int layer, const PlaneInfo& info) {
        Channel& channel = info.is_uint ? image.addUint(info.channel) : image.addFloat(info.channel);
        void* target = info.is_uint ? static_cast<void*>(channel.uints().data()) : channel.floats().data();
        std::memcpy(target, &film.words[pixels * std::size_t(layer)], pixels * sizeof(std::uint32_t));
    });
    return image;
}

SampleSums HostRenderer::renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                                    std::uint32_t planes) {
    HostFilm film;
    const auto begin = [&](const Image* sums) {
        film = makeFilm(planes);
        if (!sums) return;
        forPlanes(planes, [&](int layer, const PlaneInfo& info) {
            const std::vector<float>& values = sums->at(info.channel).floats();
            std::memcpy(&film.words[values.size() * std::size_t(layer)], values.data(), values.size() * sizeof(float));
        });
    };
    const SampleFilm adder = {
        .begin = begin,
        .add = [&](int sample, const Progress& share) { runTiles(film, planes, sample, seed, share); },
        .read = [&] { return read(film, planes); }};
    return addSamples(adder, std::move(start), from, to, progress);
}

Image HostRenderer::renderPlanes(std::uint32_t mask, const Progress& progress) {
    HostFilm film = makeFilm(mask);
    runTiles(film, mask, -1, 0, progress);  // the pixels' centres
    return read(film, mask);
}

}  // namespace dsphere::host
