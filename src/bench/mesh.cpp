#include "bench/mesh.h"

#include "base/parallel.h"

#include <cmath>

namespace dsphere::bench {

MeshLattice meshLattice(const NodeGrid& nodes, int coarsening) {
    MeshLattice lattice;
    for (int i = 0; i < nodes.width(); i += coarsening) lattice.node_columns.push_back(i);
    lattice.node_rows.push_back(0);
    // Half a step in from either pole, so that both caps look alike.
    int first = nodes.halfCaps() ? 1 + (coarsening - 1) / 2 : coarsening;
    for (int j = first; j < nodes.rows(); j += coarsening) lattice.node_rows.push_back(j);
    lattice.node_rows.push_back(nodes.rows());
    return lattice;
}

void placeVertices(const NodeGrid& nodes, const MeshLattice& lattice, double base, double scale, glm::vec3* target) {
    const std::size_t columns = lattice.node_columns.size();
    std::vector<dvec2> meridians;
    for (int i : lattice.node_columns)
        meridians.push_back({std::sin(nodes.longitude(i)), std::cos(nodes.longitude(i))});
    parallelFor(lattice.node_rows.size(), [&](std::size_t k) {
        const int j = lattice.node_rows[k];
        const float* row = nodes.row(j);
        const bool pole = j == 0 || j == nodes.rows();
        const double sine = pole ? 0.0 : std::sin(nodes.colatitude(j)), cosine = std::cos(nodes.colatitude(j));
        glm::vec3* out = target + k * (columns + 1);
        for (std::size_t i = 0; i < columns; ++i) {
            const double r = base + scale * row[lattice.node_columns[i]];
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
