#pragma once

// A picture that is rendered, and what is said of it.

#include "cli/shards.h"
#include "cli/target.h"
#include "render/scenerenderer.h"
#include "surface/scenemaps.h"

namespace dsphere::cli {

/// What is rendered of a picture or a part of one: all of it, or fewer samples than were asked for.
struct Rendered {
    Image planes;
    SampleSums colour;

    Image picture() && {
        if (colour.samples() == 0) return std::move(planes);
        Image image = pictureOf(std::move(colour));
        image.channels.insert(image.channels.end(), std::make_move_iterator(planes.channels.begin()),
                              std::make_move_iterator(planes.channels.end()));
        return image;
    }
};

/// `update_planes` is told the share that is done of the AOVs; false ends all by an Error. `update` is told that of the
/// colour; false ends it after the sample in progress. Both may throw.
Rendered renderAll(SceneRenderer& renderer, const Scene& scene, const Shard& shard, const Target& target,
                   SampleSums start, const Progress& update_planes, const Progress& update);

/// What a user must know of a picture: counts of pixels, and of samples as in RenderStats.
Notices noticesOf(std::size_t non_finite_pixels, std::uint64_t given_up_pixels);

struct Result {
    const Target& target;
    const gpu::DeviceInfo& device;
    const SceneRenderer& renderer;
    const SceneMaps& maps;
    double seconds;
    std::size_t non_finite_pixels;

    double raysPerSecond() const {
        const RenderStats& stats = renderer.stats();
        return stats.device_seconds > 0.0 ? double(stats.camera_rays) / stats.device_seconds : 0.0;
    }
};

void printJson(const Result& result);
void printReport(const Result& result, bool verbose);

}  // namespace dsphere::cli
