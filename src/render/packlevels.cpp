#include "render/packlevels.h"

#include "surface/levels.h"
#include "surface/tiledheights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

constexpr int kNotHalved = -2;

/// The index in PackedScene::nodes of the half of another; -1 without one.
int halfOf(PackedScene& packed, int nodes) {
    packed.half_of_nodes.resize(packed.nodes.size(), kNotHalved);
    int known = packed.half_of_nodes[std::size_t(nodes)];
    if (known != kNotHalved) return known;
    const Heightmap& map = packed.nodes[std::size_t(nodes)]->map();
    std::optional<Heightmap> half = map.tiled ? reducedMap(map) : halved(map);
    int index = -1;
    if (half) {
        packed.halves.push_back(std::make_unique<Heightmap>(std::move(*half)));
        index = int(packed.nodes.size());
        packed.nodes.push_back(std::make_unique<NodeGrid>(*packed.halves.back()));
        packed.half_of_nodes.push_back(kNotHalved);
    }
    packed.half_of_nodes[std::size_t(nodes)] = index;
    return index;
}

float roundUp(double value) {
    return std::nextafter(float(value), std::numeric_limits<float>::infinity());
}

}  // namespace

// A level serves where a pixel is no smaller than the surface is off, and where one of its texels is shorter than two
// pixels: those of the level before are then shorter than a pixel, and would alias.
void packLevels(PackedScene& packed, int finest, const Relief& relief) {
    const NodeGrid& whole = *packed.nodes[std::size_t(packed.reliefs[std::size_t(finest)].map)];
    if (relief.filter != Filter::Bilinear || whole.map().ripples) return;  // the error of no other is known
    double least_pixel = 0.0;
    int last = finest;
    // Differences from a map that stays in its file are those from its first level, which is held, and that one's.
    const NodeGrid* compared = &whole;
    double beyond = 0.0;
    for (int level = 1; level < MAX_LEVELS; ++level) {
        const int half = halfOf(packed, packed.reliefs[std::size_t(last)].map);
        if (half < 0) return;
        const NodeGrid& nodes = *packed.nodes[std::size_t(half)];
        double difference = 0.0;
        if (compared->map().tiled) {
            compared = &nodes;
            difference = beyond = whole.map().tiled->survey().reduced_error;
        } else {
            difference = beyond + greatestDifference(*compared, nodes);
        }
        const double error = difference * std::abs(relief.scale) / relief.greatest_radius;
        least_pixel = std::max({least_pixel, error, 0.5 * nodes.cellWidth()});
        const PackedRelief& whole_relief = packed.reliefs[std::size_t(finest)];
        PackedRelief added{half,
                           whole_relief.base,
                           whole_relief.scale,
                           whole_relief.filter,
                           whole_relief.smooth_normals,
                           buildBounds(nodes, relief),
                           {},
                           -1};
        added.shader = packMap(nodes, added.bounds, relief);
        added.shader.data.least_pixel = roundUp(least_pixel);
        packed.reliefs[std::size_t(last)].coarser = int(packed.reliefs.size());
        last = int(packed.reliefs.size());
        packed.reliefs.push_back(std::move(added));
    }
}

}  // namespace dsphere
