#include "viewer/document.h"

#include <algorithm>

#include "base/error.h"
#include "viewer/standin.h"

namespace dsphere::viewer {

namespace {

// What is wrong with coarse maps is said, if it is so, of the whole ones.
SceneMaps readMaps(const Scene& scene, bool quick, const MapProgress& progress) {
    if (quick) try {
            return loadCoarseMaps(scene);
        } catch (const Error&) {
        }
    return loadSceneMaps(scene, 0, progress);
}

}  // namespace

void Document::locate() {
    std::vector<Globe> globes;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const int relief = packed.state.objects[i].relief;
        const NodeGrid* nodes =
            relief < 0 ? nullptr : packed.nodes[std::size_t(packed.reliefs[std::size_t(relief)].map)].get();
        globes.emplace_back(scene.shapes[i], nodes, maps.reliefs[i]);
    }
    bodies = std::make_shared<const Bodies>(std::move(globes));
}

bool Document::hasMapsInFiles() const {
    return std::ranges::any_of(maps.maps, [](const auto& map) { return map->tiled != nullptr; });
}

std::vector<std::filesystem::path> Document::files() const {
    std::vector<std::filesystem::path> result = {path};
    for (const auto& map : maps.maps)
        if (!map->path.empty()) result.emplace_back(map->path);
    for (const auto& image : maps.images) result.emplace_back(image->path());
    return result;
}

std::unique_ptr<Document> makeDocument(const std::string& path, const Scene& original, const Scene& scene,
                                       Levels levels, bool quick, const MapProgress& progress) {
    auto made = std::make_unique<Document>();
    made->path = path;
    made->original = original;
    made->scene = scene;
    if (quick && traitsOf(scene).needsPaths()) made->stand_in = standIn(scene);
    made->maps = readMaps(made->drawn(), quick, progress);
    made->levels = made->hasMapsInFiles() ? Levels::All : levels;
    made->packed = packScene(made->drawn(), made->maps, made->levels);
    made->locate();
    return made;
}

PackedScene retune(Document& document, const Scene& scene) {
    std::vector<Relief> reliefs = document.maps.reliefs;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const auto* sphere = std::get_if<DisplacedSphere>(&scene.shapes[i].geometry);
        if (!sphere) continue;
        const Heightmap& map = *document.maps.maps[std::size_t(document.maps.map_of_shape[i])];
        reliefs[i] = makeRelief(*sphere, map, scene.shapes[i].where);
    }
    document.maps.reliefs.swap(reliefs);
    return packScene(scene, document.maps, document.levels);
}

}  // namespace dsphere::viewer
