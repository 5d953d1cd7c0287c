#include "cli/sceneondevice.h"

#include "cli/placecamera.h"
#include "cli/readmaps.h"

#include <functional>
#include <future>

namespace dsphere::cli {

SceneOnDevice::SceneOnDevice(Scene& scene, const SceneOptions& placement, const CommonOptions& common,
                             const MarchMethod& method, std::uint32_t planes) {
    const std::shared_future<bool> tiles =
        std::async(std::launch::async, anyMapStaysInFile, std::cref(scene), placement.memory_limit).share();
    auto reading = std::async(std::launch::async, [&] {
        tiles.wait();
        return readMaps(scene, placement, common);
    });
    std::future<void> compiling;
    try {
        device_.emplace(common);
        SceneTraits traits = traitsOf(scene);
        traits.tiles = tiles.get();
        compiling = device_->warmAhead(traits, method, planes);
    } catch (...) {
        reading.get();  // a bad map is what the user hears of first, whatever the device
        throw;
    }
    SceneMaps maps = reading.get();
    placeCamera(scene, maps, placement);
    if (!common.quiet) printNotices(maps.notices());
    PackedScene packed = packScene(scene, maps, levelsOf(method));
    if (compiling.valid()) compiling.get();
    const auto makeRenderer = [this, method](const PackedScene& of, const Scene& with) {
        return device_->makeRenderer(of, with, method);
    };
    moving_.emplace(makeRenderer, scene, std::move(maps), std::move(packed), levelsOf(method));
}

}  // namespace dsphere::cli
