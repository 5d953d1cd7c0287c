#include "verify/verify.h"

#include "base/error.h"
#include "base/parallel.h"
#include "reference/camera.h"
#include "render/raster.h"
#include "verify/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <random>

namespace dsphere::verify {

namespace {

constexpr std::size_t kChunk = 512;  // pixels a task

/// The channels that a comparison reads, looked up once.
struct Channels {
    using Floats = const std::vector<float>*;
    using Uints = const std::vector<std::uint32_t>*;
    Floats t, object[3], start[3], position[3], normal[3], smooth_normal[3], colour[3];
    Uints id, lit, flags;

    explicit Channels(const Image& image) {
        auto floats = [&](const char* name) { return &image.at(name).floats(); };
        auto triple = [&](Floats(&target)[3], const char* x, const char* y, const char* z) {
            target[0] = floats(x);
            target[1] = floats(y);
            target[2] = floats(z);
        };
        t = floats("t");
        triple(object, "object.X", "object.Y", "object.Z");
        triple(start, "start.X", "start.Y", "start.Z");
        triple(position, "P.X", "P.Y", "P.Z");
        triple(normal, "N.X", "N.Y", "N.Z");
        triple(smooth_normal, "Ns.X", "Ns.Y", "Ns.Z");
        triple(colour, "R", "G", "B");
        id = &image.at("id").uints();
        lit = &image.at("lit").uints();
        flags = &image.at("flags").uints();
    }

    static dvec3 at(const Floats (&triple)[3], std::size_t i) {
        return {(*triple[0])[i], (*triple[1])[i], (*triple[2])[i]};
    }
};

std::vector<std::size_t> chosenPixels(std::size_t count, std::uint64_t samples) {
    std::vector<std::size_t> pixels;
    if (samples == 0 || samples >= count) {
        pixels.resize(count);
        std::iota(pixels.begin(), pixels.end(), std::size_t(0));
        return pixels;
    }
    std::mt19937_64 random(1);
    for (std::uint64_t k = 0; k < samples; ++k) pixels.push_back(std::size_t(random() % count));
    return pixels;
}

// All float planes of all pixels; only a miss has a t that is not finite, and it is +infinity.
void countNotFinite(Report& report, const Image& image) {
    const auto& ids = image.at("id").uints();
    for (const Channel& channel : image.channels) {
        if (!channel.isFloat()) continue;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            float value = channel.floats()[i];
            bool far_miss = channel.name == "t" && ids[i] == 0 && std::isinf(value) && value > 0.0f;
            if (!std::isfinite(value) && !far_miss) {
                ++report.not_finite;
                report.addFault(i, fmt::format("{} is {}", channel.name, value));
            }
        }
    }
}

WorldRay pixelRay(const Scene& scene, const Box& data, std::size_t index) {
    std::size_t width = std::size_t(data.width());
    double x = data.x0 + double(index % width) + 0.5, y = data.y0 + double(index / width) + 0.5;
    reference::CameraRay ray = reference::cameraRay(scene.camera, scene.film, x, y);
    return {ray.origin, ray.direction};
}

/// The numbers of the pixel's planes (SceneRenderer::renderPlanes).
reference::SampleSource pixelSource(const Box& data, std::size_t index) {
    const std::size_t width = std::size_t(data.width());
    return {.x = std::uint32_t(data.x0) + std::uint32_t(index % width),
            .y = std::uint32_t(data.y0) + std::uint32_t(index / width),
            .seed = 0};
}

void comparePixel(Report& report, const Comparison& comparison, const Scene& scene, const Image& image,
                  const Channels& channels, std::size_t i) {
    Answer answer;
    answer.shape = int((*channels.id)[i]) - 1;
    answer.hit = answer.shape >= 0;
    answer.inside = ((*channels.flags)[i] & 1u) != 0;
    if ((*channels.flags)[i] & 2u) ++report.runaways;
    if (answer.hit) {
        answer.t = (*channels.t)[i];
        answer.object_position = comparison.objectPoint(answer.shape, Channels::at(channels.object, i));
        answer.normal = Channels::at(channels.normal, i);
        answer.smooth_normal = Channels::at(channels.smooth_normal, i);
    }
    const WorldRay ray = pixelRay(scene, image.data, i);
    comparison.checkHit(report, i, ray, answer);
    if (!answer.hit) comparison.checkMiss(report, i, ray, Channels::at(channels.colour, i));
    if (!answer.hit || answer.inside) return;
    LightAnswer light;
    light.start = comparison.objectPoint(answer.shape, Channels::at(channels.start, i));
    light.lit = (*channels.lit)[i];
    // Far from the origin the last place of P is more than lamps nearby allow; a P that is off by more is taken as it
    // is.
    const dvec3 written = Channels::at(channels.position, i);
    const dmat4& to_world = scene.shapes[std::size_t(answer.shape)].world_from_object;
    light.position = transformPoint(to_world, answer.object_position);
    const double reach = glm::length(written) + glm::length(transformVector(to_world, answer.object_position));
    if (!(glm::distance(written, light.position) <= 4e-7 * reach)) light.position = written;
    light.colour = Channels::at(channels.colour, i);
    light.source = pixelSource(image.data, i);
    comparison.checkLight(report, i, ray, answer, light);
}

// Runs body(i) over all of `pixels` in chunks, merging the reports.
template <typename Body>
Report inChunks(const std::vector<std::size_t>& pixels, const Progress& progress, Body body) {
    Report total;
    std::mutex mutex;
    std::size_t chunks = (pixels.size() + kChunk - 1) / kChunk, done = 0;
    parallelFor(chunks, [&](std::size_t chunk) {
        Report part;
        for (std::size_t k = chunk * kChunk; k < std::min((chunk + 1) * kChunk, pixels.size()); ++k)
            body(part, pixels[k]);
        std::lock_guard lock(mutex);
        total.merge(std::move(part));
        if (progress && !progress(double(++done) / double(chunks))) throw Error(ExitCode::Interrupted, "interrupted");
    });
    return total;
}

}  // namespace

Outcome verifyPlanes(Image planes, const Scene& scene, const SceneMaps& maps, std::uint64_t samples,
                     const Progress& progress) {
    Outcome outcome;
    outcome.device = std::move(planes);
    Comparison comparison(scene, maps);
    Channels channels(outcome.device);
    outcome.report = inChunks(
        chosenPixels(outcome.device.pixelCount(), samples), progress,
        [&](Report& part, std::size_t i) { comparePixel(part, comparison, scene, outcome.device, channels, i); });
    countNotFinite(outcome.report, outcome.device);
    return outcome;
}

Outcome verifyScene(SceneRenderer& renderer, const Scene& scene, const SceneMaps& maps, std::uint64_t samples,
                    const Progress& progress) {
    return verifyPlanes(renderer.renderPlanes(kVerifyPlanes, {}), scene, maps, samples, progress);
}

Image referenceImage(const Scene& scene, const SceneMaps& maps, const Progress& progress) {
    Comparison comparison(scene, maps);
    const reference::Tracer& tracer = comparison.tracer();
    Image image{cropBox(scene.film), {0, 0, scene.film.width, scene.film.height}, {}};
    for (const char* name : {"R", "G", "B", "t"}) image.addFloat(name);
    for (const char* name : {"id", "lit"}) image.addUint(name);
    inChunks(chosenPixels(image.pixelCount(), 0), progress, [&](Report&, std::size_t i) {
        WorldRay ray = pixelRay(scene, image.data, i);
        reference::WorldHit hit = tracer.firstHit(ray.origin, ray.direction);
        image.channels[3].floats()[i] = hit.hit ? float(hit.t()) : std::numeric_limits<float>::infinity();
        dvec3 colour = tracer.lights().environment(ray.direction);
        if (hit.hit) {
            const reference::ShadingPoint point = tracer.shadingPoint(hit, ray.direction);
            const reference::SampleSource source = pixelSource(image.data, i);
            const std::uint32_t lit = tracer.litLights(point, source);
            colour = tracer.directLight(point, source, lit);
            image.channels[5].uints()[i] = lit;
        }
        for (int c = 0; c < 3; ++c) image.channels[std::size_t(c)].floats()[i] = float(colour[c]);
        image.channels[4].uints()[i] = std::uint32_t(hit.shape + 1);
    });
    return image;
}

}  // namespace dsphere::verify
