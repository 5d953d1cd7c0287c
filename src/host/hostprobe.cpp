#include "host/hostprobe.h"

#include "base/parallel.h"

#include <algorithm>

namespace dsphere::host {

HostProbe::HostProbe(const PackedScene& packed, Precision precision)
    : scene_(packed),
      specialization_(specializationOf(packed.traits, 1.0f, Marcher::Exact, 0)),
      probe_(probeFor(packed.traits, precision)) {}

std::vector<layout::ProbeHit> HostProbe::trace(const std::vector<ProbeQuery>& queries) {
    constexpr std::size_t kChunk = 256;
    std::vector<layout::ProbeRay> rays(queries.size());
    std::vector<layout::ProbeHit> hits(queries.size());
    parallelFor((queries.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        const std::size_t first = chunk * kChunk, count = std::min(kChunk, queries.size() - first);
        for (std::size_t i = first; i < first + count; ++i) rays[i] = packProbe(queries[i]);
        probe_(scene_, specialization_, {&rays[first], count}, {&hits[first], count});
    });
    return hits;
}

}  // namespace dsphere::host
