#include "viewer/document.h"

namespace dsphere::viewer {

namespace {

std::unique_ptr<Document> makeDocument(std::string path, Scene original, Scene scene, const Tuning& tuning) {
    auto made = std::make_unique<Document>();
    made->path = std::move(path);
    made->original = std::move(original);
    made->scene = std::move(scene);
    made->maps = loadSceneMaps(made->scene);
    made->packed = packScene(made->scene, made->maps, tuning.levels);
    made->tuning = tuning;
    made->locate();
    return made;
}

}  // namespace

void Document::locate() {
    std::size_t i = Globe::shapeOf(scene);
    int relief = packed.relief_of_object[i];
    const NodeGrid* nodes =
        relief < 0 ? nullptr : packed.nodes[std::size_t(packed.reliefs[std::size_t(relief)].map)].get();
    globe_of_packing.emplace(scene.shapes[i], nodes, maps.reliefs[i]);
}

std::vector<std::filesystem::path> Document::files() const {
    std::vector<std::filesystem::path> result = {path};
    for (const auto& map : maps.maps)
        if (!map->path.empty()) result.emplace_back(map->path);
    for (const auto& image : maps.images) result.emplace_back(image->path());
    return result;
}

const DisplacedSphere* Document::originalGlobe() const {
    return std::get_if<DisplacedSphere>(&original.shapes[Globe::shapeOf(original)].geometry);
}

std::unique_ptr<Document> openDocument(const OpenScene& open, const std::string& path) {
    Scene scene = open(path);
    std::unique_ptr<Document> made = makeDocument(path, scene, scene, {});
    if (const DisplacedSphere* globe = made->originalGlobe()) {
        made->tuning.midlevel = globe->midlevel;
        made->tuning.filter = globe->filter;
    }
    return made;
}

std::unique_ptr<Document> remakeDocument(const Document& old, const Scene& scene, const Tuning& tuning) {
    Scene changed = scene;
    const Scene shaped = tuned(old.original, tuning);
    for (std::size_t i = 0; i < changed.shapes.size(); ++i) changed.shapes[i].geometry = shaped.shapes[i].geometry;
    return makeDocument(old.path, old.original, std::move(changed), tuning);
}

Scene tuned(const Scene& original, const Tuning& tuning) {
    Scene scene = original;
    for (Shape& shape : scene.shapes) {
        auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) continue;
        sphere->max_displacement *= tuning.exaggeration;
        if (sphere->height_scale) *sphere->height_scale *= tuning.exaggeration;
    }
    if (auto* sphere = std::get_if<DisplacedSphere>(&scene.shapes[Globe::shapeOf(scene)].geometry))
        sphere->midlevel = tuning.midlevel, sphere->filter = tuning.filter;
    return scene;
}

PackedScene retune(Document& document, const Tuning& tuning) {
    Scene scene = tuned(document.original, tuning);
    std::vector<Relief> reliefs = document.maps.reliefs;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const auto* sphere = std::get_if<DisplacedSphere>(&scene.shapes[i].geometry);
        if (!sphere) continue;
        const Heightmap& map = *document.maps.maps[std::size_t(document.maps.map_of_shape[i])];
        reliefs[i] = makeRelief(*sphere, map, scene.shapes[i].where);
    }
    document.maps.reliefs.swap(reliefs);
    return packScene(scene, document.maps, tuning.levels);
}

}  // namespace dsphere::viewer
