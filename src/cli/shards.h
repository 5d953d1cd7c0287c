#pragma once

// Which part of a picture a run renders.

#include "cli/commands.h"
#include "cli/parts.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace dsphere::cli {

struct ShardOptions {
    std::string tile, samples;  ///< --tile and --samples as they were given

    bool wanted() const { return !tile.empty() || !samples.empty(); }
};

void addShardOptions(CLI::App& command, ShardOptions& options);

/// Pixels and samples of a picture: all of it, or a part.
struct Shard {
    Box box;
    int first = 0, last = 0;     ///< samples first to last - 1
    std::optional<PartOf> part;  ///< all but its turns, which the device decides; unset: it is all of the picture

    int samples() const { return last - first; }
};

Shard wholePicture(const Scene& scene);
/// Error (Usage) when they are not of the scene's picture.
Shard shardOf(const ShardOptions& options, const Scene& scene);

}  // namespace dsphere::cli
