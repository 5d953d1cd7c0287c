#pragma once

#include "surface/nodes.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace dsphere::bench {

/// Where the vertices of a mesh of a map lie: on every n-th node column and row, or on lines between those, where they
/// lie on the map's bilinear surface; the poles always. Row by row from the north pole to the south pole; the seam's
/// column comes twice, a pole once a column.
struct MeshLattice {
    std::vector<double> node_columns, node_rows;

    int columns() const { return int(node_columns.size()) + 1; }  ///< of vertices
    int rows() const { return int(node_rows.size()); }
    std::size_t vertexCount() const { return std::size_t(columns()) * std::size_t(rows()); }
};

/// `spacing`: nodes from vertex to vertex: a whole number, or one divided by a whole number.
MeshLattice meshLattice(const NodeGrid& nodes, double spacing);

/// Writes vertexCount() vertices, of radius base + scale * stored value. Uses all cores.
void placeVertices(const NodeGrid& nodes, const MeshLattice& lattice, double base, double scale, glm::vec3* target);

/// Two triangles a cell, one where it touches a pole: indices of three vertices each.
std::vector<std::uint32_t> meshTriangles(const MeshLattice& lattice);

}  // namespace dsphere::bench
