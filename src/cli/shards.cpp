#include "cli/shards.h"

#include "base/error.h"
#include "render/raster.h"
#include "render/shards.h"

#include <charconv>
#include <cstdint>

namespace dsphere::cli {

namespace {

/// Two numbers with a mark between them; unset for anything else.
std::optional<std::pair<int, int>> pairOf(const std::string& text, char mark) {
    std::pair<int, int> pair;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != mark) return {};
    const auto second = std::from_chars(first.ptr + 1, end, pair.second);
    if (second.ec != std::errc() || second.ptr != end) return {};
    return pair;
}

}  // namespace

void addShardOptions(CLI::App& command, ShardOptions& options) {
    command
        .add_option("--tile", options.tile,
                    "Render the I-th of N pieces of the picture, I from 1, into an .exr for dsphere merge")
        ->type_name("I/N");
    command
        .add_option("--samples", options.samples,
                    "Render samples A to B - 1 of the picture's, into an .exr for dsphere merge; multiples of 16 make "
                    "the smallest files")
        ->type_name("A:B");
}

Shard wholePicture(const Scene& scene) {
    return {cropBox(scene.film), 0, scene.sampler.pixel_samples, {}};
}

Shard shardOf(const ShardOptions& options, const Scene& scene) {
    Shard shard = wholePicture(scene);
    if (!options.wanted()) return shard;
    const Box picture = shard.box;
    const int samples = shard.last;
    if (!options.tile.empty()) {
        const auto tile = pairOf(options.tile, '/');
        const std::int64_t pixels = std::int64_t(picture.width()) * picture.height();
        if (!tile || tile->first < 1 || tile->second < tile->first)
            throwUsage("--tile: {:?} is not I/N with I from 1 to N", options.tile);
        if (tile->second > pixels) throwUsage("--tile: {} pixels are no {} tiles", pixels, tile->second);
        shard.box = tileBox(picture, tile->first, tile->second);
    }
    if (!options.samples.empty()) {
        const auto range = pairOf(options.samples, ':');
        if (!range || range->first < 0 || range->second <= range->first)
            throwUsage("--samples: {:?} is not A:B with A below B", options.samples);
        if (range->second > samples)
            throwUsage("--samples: {} is not within the picture's samples, 0:{}", options.samples, samples);
        shard.first = range->first;
        shard.last = range->second;
    }
    shard.part = PartOf{picture, samples, shard.first};
    return shard;
}

}  // namespace dsphere::cli
