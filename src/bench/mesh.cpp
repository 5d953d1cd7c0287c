#include "bench/mesh.h"

#include "base/parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace dsphere::bench {

MeshLattice meshLattice(const NodeGrid& nodes, double spacing) {
    MeshLattice lattice;
    for (double i = 0.0; i < nodes.width(); i += spacing) lattice.node_columns.push_back(i);
    lattice.node_rows.push_back(0.0);
    // Half a step in from either pole, so that both caps look alike.
    const double first = spacing > 1.0 && nodes.halfCaps() ? 1.0 + std::floor((spacing - 1.0) / 2.0) : spacing;
    for (double j = first; j < nodes.rows(); j += spacing) lattice.node_rows.push_back(j);
    lattice.node_rows.push_back(nodes.rows());
    return lattice;
}

namespace {

/// Between the lines 0 to `last`: the one before, and the share of the way to the next.
struct Between {
    int before;
    double share;

    Between(double line, int last) : before(std::min(int(line), last - 1)), share(line - before) {}
};

}  // namespace

void placeVertices(const NodeGrid& nodes, const MeshLattice& lattice, double base, double scale, glm::vec3* target) {
    const std::size_t columns = lattice.node_columns.size();
    std::vector<dvec2> meridians;
    for (double column : lattice.node_columns) {
        const double longitude = nodes.longitude(0) + column * nodes.cellWidth();
        meridians.push_back({std::sin(longitude), std::cos(longitude)});
    }
    parallelFor(lattice.node_rows.size(), [&](std::size_t k) {
        const Between row(lattice.node_rows[k], nodes.rows());
        const float *north = nodes.row(row.before), *south = nodes.row(row.before + 1);
        const double colatitude = glm::mix(nodes.colatitude(row.before), nodes.colatitude(row.before + 1), row.share);
        const bool pole = k == 0 || k + 1 == lattice.node_rows.size();
        const double sine = pole ? 0.0 : std::sin(colatitude), cosine = std::cos(colatitude);
        glm::vec3* out = target + k * (columns + 1);
        for (std::size_t i = 0; i < columns; ++i) {
            const Between column(lattice.node_columns[i], nodes.width());
            const int west = column.before, east = west + 1 == nodes.width() ? 0 : west + 1;
            const double r =
                base + scale * glm::mix(glm::mix(double(north[west]), double(north[east]), column.share),
                                        glm::mix(double(south[west]), double(south[east]), column.share), row.share);
            out[i] = glm::vec3(r * dvec3(sine * meridians[i].x, cosine, sine * meridians[i].y));
        }
        out[columns] = out[0];
    });
}

std::vector<std::uint32_t> meshTriangles(const MeshLattice& lattice) {
    const int columns = lattice.columns(), rows = lattice.rows();
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * std::size_t(columns - 1) * std::size_t(rows - 2));
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const auto nw = std::uint32_t(j * columns + i), ne = nw + 1, sw = nw + std::uint32_t(columns), se = sw + 1;
            if (j > 0) indices.insert(indices.end(), {nw, sw, ne});
            if (j + 2 < rows) indices.insert(indices.end(), {ne, sw, se});
        }
    return indices;
}

}  // namespace dsphere::bench
