#include "cli/header.h"

#include "base/hash.h"
#include "render/raster.h"
#include "surface/fingerprint.h"

#include <fmt/format.h>

#include <bit>

namespace dsphere::cli {

namespace {

// As pbrt stores them: row vectors, so the matrix is transposed against ours.
std::array<float, 16> headerMatrix(const dmat4& m) {
    std::array<float, 16> values;
    for (int i = 0; i < 16; ++i) values[std::size_t(i)] = float(m[i / 4][i % 4]);
    return values;
}

dmat4 ndcFromWorld(const Raster& raster) {
    dvec2 size = raster.screen_max - raster.screen_min;
    dmat4 ndc(1.0);  // from the screen window (over z in perspective) to [0, 1], y upward
    ndc[0][0] = 1.0 / size.x;
    ndc[1][1] = 1.0 / size.y;
    dvec2 shift = -raster.screen_min / size;
    if (raster.projection == Projection::Perspective)
        ndc[2] = dvec4(shift, 1.0, 1.0), ndc[3] = dvec4(0.0);
    else
        ndc[3] = dvec4(shift, 0.0, 1.0);
    return ndc * raster.camera_from_world;
}

}  // namespace

Metadata makeMetadata(const Scene& scene, const Origin& origin, int samples, std::optional<double> seconds) {
    Metadata metadata = {{"scene", scene.name},
                         {"samplesPerPixel", samples},
                         {"worldToCamera", headerMatrix(scene.camera.camera_from_world)},
                         {"worldToNDC", headerMatrix(ndcFromWorld(makeRaster(scene.camera, scene.film)))}};
    metadata["seed"] = origin.seed;
    metadata["fingerprint"] = origin.fingerprint;
    metadata["software"] = origin.software;
    if (!seconds) return metadata;
    metadata["renderTimeSeconds"] = float(*seconds);
    metadata["device"] = origin.device;
    metadata["driver"] = origin.driver;
    return metadata;
}

Origin originOf(const Scene& scene, const SceneMaps& maps, const MarchMethod& method, const gpu::DeviceInfo& device) {
    Hash hash;
    hash.word(fingerprint(scene, maps));
    hash.word(std::uint64_t(method.marcher));
    hash.word(std::bit_cast<std::uint32_t>(method.threshold));
    hash.word(std::bit_cast<std::uint32_t>(method.detail));
    const Film& film = scene.film;
    return {.seed = scene.sampler.seed,
            .fingerprint = fmt::format("{:016x}", hash.value()),
            .device = device.name,
            .driver = device.driver,
            .software = std::string("dsphere ") + DSPHERE_VERSION,
            .data = cropBox(film),
            .display = {0, 0, film.width, film.height}};
}

}  // namespace dsphere::cli
