#include "query/query.h"

#include "gpu/device.h"
#include "image/rawmap.h"
#include "query/certify.h"
#include "scene/heightmapscene.h"
#include "scene/parser.h"

#include <optional>
#include <utility>

namespace dsphere {

struct Query::Parts {
    Scene scene;
    SceneMaps maps;
    PackedScene packed;
    gpu::Device device;
    DeviceScene device_scene;
    QueryOptions options;
    query::Engine engine;
    std::optional<query::Engine> any;  ///< for statuses(); made when it is first needed, as is the next
    std::optional<query::Certifier> certifier;

    Parts(Scene read, const QueryOptions& given)
        : scene(std::move(read)),
          maps(loadSceneMaps(scene)),
          packed(packScene(scene, maps)),
          device({.selector = given.device}),
          device_scene(device, packed),
          options(given),
          engine(device, scene, maps, packed, device_scene,
                 {.frame = options.frame, .wishes = {.lit = options.lit, .place = true}}) {}

    template <typename Result, typename Convert>
    static std::vector<Result> trace(query::Engine& with, std::span<const QueryRay> rays, Convert convert) {
        std::vector<Result> results(rays.size());
        with.trace(
            rays.size(), [&](std::size_t i) { return rays[i]; },
            [&](std::size_t i, const query::Answer& answer) { results[i] = convert(i, answer); });
        return results;
    }
};

Query::Query(const std::string& scene_or_map, const QueryOptions& options)
    : parts_(std::make_unique<Parts>(
          looksLikeMap(scene_or_map) ? heightmapScene(scene_or_map) : parseSceneFile(scene_or_map), options)) {}

Query::~Query() = default;
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;

std::vector<QueryHit> Query::trace(std::span<const QueryRay> rays) {
    return Parts::trace<QueryHit>(parts_->engine, rays,
                                  [](std::size_t, const query::Answer& answer) { return answer.hit; });
}

QueryHit Query::trace(const QueryRay& ray) {
    return trace(std::span(&ray, 1))[0];
}

std::vector<QueryStatus> Query::statuses(std::span<const QueryRay> rays) {
    Parts& parts = *parts_;
    if (!parts.any)
        parts.any.emplace(
            parts.device, parts.scene, parts.maps, parts.packed, parts.device_scene,
            query::Engine::Options{
                .frame = parts.options.frame, .wishes = {.normal = false}, .parts = query::AnswerParts::none()});
    return Parts::trace<QueryStatus>(*parts.any, rays,
                                     [](std::size_t, const query::Answer& answer) { return answer.hit.status; });
}

std::vector<CertifiedHit> Query::traceCertified(std::span<const QueryRay> rays) {
    Parts& parts = *parts_;
    if (!parts.certifier) parts.certifier.emplace(parts.scene, parts.maps, parts.options.frame, false);
    return Parts::trace<CertifiedHit>(parts.engine, rays, [&](std::size_t i, const query::Answer& answer) {
        const query::Truth truth = parts.certifier->check(i, rays[i], answer);
        return CertifiedHit{answer.hit, truth.t_low, truth.t_high, truth.wrong};
    });
}

}  // namespace dsphere
