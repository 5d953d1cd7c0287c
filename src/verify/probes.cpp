#include "base/parallel.h"
#include "verify/compare.h"
#include "verify/verify.h"

#include <cassert>
#include <cmath>
#include <mutex>

namespace dsphere::verify {

namespace {

bool finite(const layout::ProbeHit& hit) {
    for (int c = 0; c < 4; ++c)
        if (!std::isfinite(hit.position[c]) || !std::isfinite(hit.normal[c])) return false;
    return true;
}

}  // namespace

Report verifyRays(RayProbe& probe, const Scene& scene, const SceneMaps& maps, const std::vector<ProbeQuery>& queries) {
    assert(scene.shapes[0].world_from_object == dmat4(1.0));
    std::vector<layout::ProbeHit> hits = probe.trace(queries);
    Comparison comparison(scene, maps);
    double unit = comparison.unit(0);
    Report total;
    std::mutex mutex;
    constexpr std::size_t kChunk = 256;
    parallelFor((queries.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        Report part;
        for (std::size_t i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, queries.size()); ++i) {
            const layout::ProbeHit& hit = hits[i];
            WorldRay ray{queries[i].origin * unit, glm::normalize(queries[i].direction)};
            Answer answer;
            answer.hit = (hit.flags & 1u) != 0;
            answer.inside = (hit.flags & 2u) != 0;
            answer.shape = answer.hit ? 0 : -1;
            answer.object_position = dvec3(hit.position) * unit;
            answer.normal = dvec3(hit.normal);
            answer.t = double(hit.position.w) * unit - glm::dot(ray.origin, ray.direction);  // from the nearest point
            if (answer.inside) answer.t = 0.0;
            if (hit.flags & 4u) ++part.runaways;
            if (!finite(hit)) {
                ++part.not_finite;
                part.addFault(i, "an answer that is not finite");
            }
            comparison.checkHit(part, i, ray, answer);
        }
        std::lock_guard lock(mutex);
        total.merge(std::move(part));
    });
    return total;
}

}  // namespace dsphere::verify
