#pragma once

#include "query/certify.h"
#include "query/hitwriter.h"
#include "query/rayreader.h"
#include "render/renderer.h"

namespace dsphere::query {

struct StreamCounts {
    std::uint64_t rays = 0, hits = 0, inside = 0, invalid = 0;
    double seconds = 0.0;  ///< from the first read to the last write
};

/// Reads all rays, traces them and writes their answers, block by block: reading and writing go on beside tracing, and
/// memory does not grow with the count. `certifier` may be null. Error (Interrupted) when `progress` says to stop.
StreamCounts streamRays(RayReader& reader, Engine& engine, const Record& record, HitWriter& writer,
                        Certifier* certifier, const Progress& progress);

}  // namespace dsphere::query
