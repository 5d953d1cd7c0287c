#include "query/query.h"

#include "gpu/device.h"
#include "image/rawmap.h"
#include "query/engine.h"
#include "scene/heightmapscene.h"
#include "scene/parser.h"

#include <utility>

namespace dsphere {

struct Query::Parts {
    Scene scene;
    SceneMaps maps;
    PackedScene packed;
    gpu::Device device;
    DeviceScene device_scene;
    query::Engine engine;

    Parts(Scene read, const QueryOptions& options)
        : scene(std::move(read)),
          maps(loadSceneMaps(scene)),
          packed(packScene(scene, maps)),
          device({.selector = options.device}),
          device_scene(device, packed),
          engine(device, scene, maps, packed, device_scene,
                 {.frame = options.frame, .wishes = {.lit = options.lit, .place = true}}) {}
};

Query::Query(const std::string& scene_or_map, const QueryOptions& options)
    : parts_(std::make_unique<Parts>(
          looksLikeMap(scene_or_map) ? heightmapScene(scene_or_map) : parseSceneFile(scene_or_map), options)) {}

Query::~Query() = default;
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;

std::vector<QueryHit> Query::trace(std::span<const QueryRay> rays) {
    std::vector<QueryHit> hits(rays.size());
    parts_->engine.trace(
        rays.size(), [&](std::size_t i) { return rays[i]; },
        [&](std::size_t i, const query::Answer& answer) { hits[i] = answer.hit; });
    return hits;
}

QueryHit Query::trace(const QueryRay& ray) {
    return trace(std::span(&ray, 1))[0];
}

}  // namespace dsphere
