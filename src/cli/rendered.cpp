#include "cli/rendered.h"

#include "cli/print.h"

#include <filesystem>
#include <iterator>

namespace dsphere::cli {

Rendered renderAll(SceneRenderer& renderer, const Scene& scene, const Shard& shard, const Target& target,
                   SampleSums start, const Progress& update_planes, const Progress& update) {
    Rendered result;
    if (target.aovs) result.planes = renderer.renderPlanes(target.aovs, update_planes);
    if (shard.samples() > 0)
        result.colour = renderer.renderSums(std::move(start), shard.first, shard.last,
                                            std::uint32_t(scene.sampler.seed), update, target.colours);
    return result;
}

Notices noticesOf(std::size_t non_finite_pixels, std::uint64_t given_up_pixels) {
    Notices notices;
    if (non_finite_pixels > 0)
        notices.push_back(
            {Notice::Kind::Warning, fmt::format("{} pixels hold light that is not finite", non_finite_pixels)});
    if (given_up_pixels > 0)
        notices.push_back({Notice::Kind::Warning,
                           fmt::format("{} samples of pixels may be wrong: their rays skim the ground across a pole of "
                                       "the map, through more columns than the device's loops can go",
                                       given_up_pixels)});
    return notices;
}

void printJson(const Result& result) {
    const RenderStats& stats = result.renderer.stats();
    nlohmann::ordered_json json = {{"picture", result.target.path.string()},
                                   {"device", result.device.name},
                                   {"driver", result.device.driver},
                                   {"seconds", result.seconds},
                                   {"device_seconds", stats.device_seconds},
                                   {"camera_rays", stats.camera_rays},
                                   {"camera_rays_per_second", result.raysPerSecond()},
                                   {"retried_pixels", stats.retried_pixels},
                                   {"given_up_pixels", stats.given_up_pixels},
                                   {"tiles_read", stats.tiles_read},
                                   {"non_finite_pixels", result.non_finite_pixels},
                                   {"map_bytes", result.renderer.mapBytes()},
                                   {"image_bytes", result.renderer.imageBytes()},
                                   {"maps", nlohmann::ordered_json::array()}};
    for (const auto& map : result.maps.maps)
        json["maps"].push_back({{"path", map->path}, {"nodata_texels", map->nodata_count}});
    printText(jsonText(json));
}

void printReport(const Result& result, bool verbose) {
    double mib = 1.0 / 1048576.0;
    std::error_code ignored;
    const bool output = result.target.isOutput();
    printErr("picture  {}\ndevice   {} ({})\n",
             output ? result.target.name() : std::filesystem::absolute(result.target.path, ignored).string(),
             result.device.name, result.device.driver);
    printErr("time     {:.2f} s in all, {:.3f} s on the device\n", result.seconds,
             result.renderer.stats().device_seconds);
    printErr("speed    {:.1f} million camera rays a second, with their shadow rays\n", result.raysPerSecond() * 1e-6);
    for (const auto& map : result.maps.maps)
        if (map->nodata_count > 0)
            printErr("nodata   {} of {} texels of {}, filled from their neighbours\n", map->nodata_count,
                     map->samples.size(), map->path);
    if (!verbose) return;
    printErr("maps     {:.1f} MiB on the device\n", double(result.renderer.mapBytes()) * mib);
    printErr("images   {:.1f} MiB on the device\n", double(result.renderer.imageBytes()) * mib);
    printErr("retried  {} pixels in full precision\n", result.renderer.stats().retried_pixels);
    if (result.renderer.stats().tiles_read > 0)
        printErr("tiles    {} of heights read, {:.1f} MiB\n", result.renderer.stats().tiles_read,
                 double(result.renderer.stats().tile_bytes) * mib);
}

}  // namespace dsphere::cli
