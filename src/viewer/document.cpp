#include "viewer/document.h"

namespace dsphere::viewer {

namespace {

std::unique_ptr<Document> makeDocument(std::string path, Scene original, Scene scene) {
    auto made = std::make_unique<Document>();
    made->path = std::move(path);
    made->original = std::move(original);
    made->scene = std::move(scene);
    made->maps = loadSceneMaps(made->scene);
    made->packed = packScene(made->scene, made->maps);
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

double Document::midlevel() const {
    const auto* sphere = std::get_if<DisplacedSphere>(&original.shapes[Globe::shapeOf(original)].geometry);
    return sphere ? sphere->midlevel : 0.0;
}

std::unique_ptr<Document> openDocument(const OpenScene& open, const std::string& path) {
    Scene scene = open(path);
    std::unique_ptr<Document> made = makeDocument(path, scene, scene);
    made->tuning.midlevel = made->midlevel();
    return made;
}

std::unique_ptr<Document> remakeDocument(const Document& old, const Scene& scene) {
    std::unique_ptr<Document> made = makeDocument(old.path, old.original, scene);
    made->tuning = old.tuning;
    return made;
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
        sphere->midlevel = tuning.midlevel;
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
    return packScene(scene, document.maps);
}

}  // namespace dsphere::viewer
