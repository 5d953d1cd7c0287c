#include "render/renderer.h"

#include "base/error.h"
#include "gpu/result.h"
#include "render/shards.h"
#include "render/specialization.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <limits>

namespace dsphere {

namespace {

// Work handed over at once stays well below every driver's watchdog (2 s the shortest).
constexpr double kSubmitTarget = 0.05;

[[noreturn]] void throwInterrupted() {
    throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
}

}  // namespace

Renderer::Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method)
    : device_(device),
      packed_(&packed),
      traits_(packed.traits),
      state_(packed.state),
      device_scene_(device, packed),
      method_(method) {
    setCamera(scene);
}

void Renderer::setCamera(const Scene& scene) {
    packCamera(state_, scene);
    device_scene_.updateObjects(state_);
    display_ = {0, 0, scene.film.width, scene.film.height};
    setCrop(cropBox(scene.film));
}

void Renderer::setCrop(const Box& crop) {
    crop_ = crop;
    spans_ = shownSpans(packed_->traits, state_.objects, crop_);
}

// Where the device's memory is short, half as many rows of the film at a time, and half of these, and so on.
CropFilm Renderer::makeFilm(std::uint32_t mask) {
    FilmPipelines& made = pipelines(method_, mask);
    for (;;) {
        const int rows = std::min(film_rows_, crop_.height());
        try {
            return CropFilm(device_, made, device_scene_, crop_, spans_, mask, rows);
        } catch (const gpu::OutOfMemory& error) {
            if (rows <= kTileRowStep)
                throwFailure(
                    "{}; {} rows of the picture are too many already: other programs have the device's "
                    "memory, or the scene's maps, whose heights --mem-limit SIZE keeps in their files",
                    error.what(), rows);
            film_rows_ = (rows / 2 + kTileRowStep - 1) / kTileRowStep * kTileRowStep;
        }
    }
}

void Renderer::addSample(CropFilm& film, int sample, std::uint32_t seed, const Progress& progress) {
    for (int band = 0; band < film.bands(); ++band) {
        TileRun& run = film.beginBand(band);
        while (!run.done()) {
            const auto started = std::chrono::steady_clock::now();
            stats_.device_seconds += run.step(film.tracer(), sample, seed, kSubmitTarget);
            stats_.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
            if (progress && !progress((band + run.share()) / film.bands())) throwInterrupted();
        }
        film.endBand(band);
    }
    stats_.camera_rays += crop_.width() * std::uint64_t(crop_.height());
}

void Renderer::setLook(const Scene& scene, const SceneMaps& maps) {
    packLook(state_, packed_->tables, scene, maps);
    device_scene_.updateObjects(state_);
    device_scene_.updateLook(state_);
}

void Renderer::setPacking(const PackedScene& packed) {
    packed_ = &packed;
    state_ = packed.state;
    device_scene_.updateReliefs(packed);
    device_scene_.updateObjects(state_);
    device_scene_.updateLook(state_);
    // Pipelines are made for the traits, and for a stride that is safe for the slopes.
    const bool others = packed.traits != traits_;
    std::erase_if(pipelines_, [=](const auto& one) { return others || one.first.first.marcher == Marcher::Lipschitz; });
    traits_ = packed.traits;
}

FilmPipelines& Renderer::pipelines(const MarchMethod& method, std::uint32_t mask) {
    auto found = pipelines_.find({method, mask});
    if (found == pipelines_.end())
        found = pipelines_
                    .emplace(std::pair(method, mask),
                             FilmPipelines(device_, packed_->traits, safeStride(*packed_, method), method, mask))
                    .first;
    return found->second;
}

void Renderer::countWork(const FilmTracer& tracer) {
    stats_.retried_pixels += tracer.retried();
    stats_.given_up_pixels += tracer.givenUp();
    stats_.tiles_read = device_scene_.tiles().loads();
    stats_.tile_bytes = stats_.tiles_read * device_scene_.tiles().tileBytes();
}

SampleSums Renderer::renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                                std::uint32_t planes) {
    CropFilm film = makeFilm(planes);
    const SampleFilm adder = {.begin = [&](const Image* sums) { film.begin(sums); },
                              .add = [&](int sample, const Progress& share) { addSample(film, sample, seed, share); },
                              .read = [&] { return film.read(display_); }};
    SampleSums sums = addSamples(adder, std::move(start), from, to, progress);
    countWork(film.tracer());
    return sums;
}

// Pixels that no dispatch reached are zero; a miss has an infinite t.
void Renderer::fillMisses(Image& image, const std::vector<Box>& tiles) const {
    for (Channel& channel : image.channels) {
        if (channel.name != "t") continue;
        std::size_t width = std::size_t(crop_.width());
        std::vector<bool> reached(width * spans_.size());
        for (const Box& box : tiles)
            for (int y = box.y0; y < box.y1; ++y)
                std::fill_n(reached.begin() + std::ptrdiff_t(std::size_t(y) * width) + box.x0, box.width(), true);
        for (std::size_t i = 0; i < reached.size(); ++i)
            if (!reached[i]) channel.floats()[i] = std::numeric_limits<float>::infinity();
    }
}

Image Renderer::renderColour(int samples, std::uint32_t seed, const Progress& progress) {
    const auto go = [&](double share) {
        if (progress && !progress(share)) throwInterrupted();
        return true;
    };
    Image picture = renderSums({}, 0, samples, seed, go).total();
    takeMean(picture, samples);
    return picture;
}

Image Renderer::renderPlanes(std::uint32_t mask, const Progress& progress) {
    CropFilm film = makeFilm(mask);
    addSample(film, -1, 0, progress);  // the pixels' centres
    countWork(film.tracer());
    Image image = film.read(display_);
    fillMisses(image, film.tiles());
    return image;
}

}  // namespace dsphere
