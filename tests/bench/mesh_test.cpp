// The mesh peers stand on the true surface, and close.

#include "bench/mesh.h"
#include "reference/surface.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <map>

namespace dsphere::bench {
namespace {

struct Planet {
    DisplacedSphere sphere;
    Heightmap map;
    Relief relief;
    NodeGrid nodes;

    Planet(int width, int height, std::optional<Registration> registration, double origin = -180.0)
        : sphere(make(registration, origin)),
          map(makeHeightmap(test::fractalMap(width, height), sphere)),
          relief(makeRelief(sphere, map, {"mesh"})),
          nodes(map) {}

    static DisplacedSphere make(std::optional<Registration> registration, double origin) {
        DisplacedSphere sphere;
        sphere.max_displacement = 20.0;
        sphere.registration = registration;
        sphere.longitude_origin = origin;
        return sphere;
    }

    std::vector<glm::vec3> vertices(const MeshLattice& lattice) const {
        std::vector<glm::vec3> result(lattice.vertexCount());
        placeVertices(nodes, lattice, relief.base, relief.scale, result.data());
        return result;
    }
};

class MeshTest : public testing::TestWithParam<double> {
  protected:
    static void expectOnSurface(const Planet& planet) {
        reference::Surface surface(planet.map, planet.relief);
        MeshLattice lattice = meshLattice(planet.nodes, GetParam());
        for (const glm::vec3& p : planet.vertices(lattice))
            ASSERT_LE(std::abs(surface.f(dvec3(p))) / glm::length(surface.gradient(dvec3(p))), 3e-7)
                << p.x << ' ' << p.y << ' ' << p.z;
    }
};

TEST_P(MeshTest, VerticesLieOnTheTrueSurface) {
    expectOnSurface(Planet(512, 256, {}));
    expectOnSurface(Planet(512, 257, Registration::Gridline));
}
TEST_P(MeshTest, SmallAndTurnedMapsToo) {
    expectOnSurface(Planet(24, 12, {}));
    expectOnSurface(Planet(519, 263, Registration::Texel, 37.0));
}

// Every edge of a closed surface has two triangles, which run along it in opposite directions.
TEST_P(MeshTest, TrianglesCloseTheSeamAndThePoles) {
    Planet planet(512, 256, {});
    MeshLattice lattice = meshLattice(planet.nodes, GetParam());
    std::vector<glm::vec3> vertices = planet.vertices(lattice);
    auto key = [&](std::uint32_t k) { return std::array{vertices[k].x, vertices[k].y, vertices[k].z}; };
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> edges;
    std::vector<std::uint32_t> triangles = meshTriangles(lattice);
    ASSERT_EQ(triangles.size() % 3, 0u);
    for (std::size_t k = 0; k < triangles.size(); k += 3)
        for (std::size_t c = 0; c < 3; ++c) {
            Point a = key(triangles[k + c]), b = key(triangles[k + (c + 1) % 3]);
            ASSERT_NE(a, b) << "a triangle without area";
            ++edges[{std::min(a, b), std::max(a, b)}];
            ASSERT_LE((edges[{std::min(a, b), std::max(a, b)}]), 2);
        }
    for (const auto& [edge, count] : edges) ASSERT_EQ(count, 2);
}

TEST_P(MeshTest, TrianglesFaceOutward) {
    Planet planet(512, 256, {});
    MeshLattice lattice = meshLattice(planet.nodes, GetParam());
    std::vector<glm::vec3> vertices = planet.vertices(lattice);
    std::vector<std::uint32_t> triangles = meshTriangles(lattice);
    for (std::size_t k = 0; k < triangles.size(); k += 3) {
        dvec3 a(vertices[triangles[k]]), b(vertices[triangles[k + 1]]), c(vertices[triangles[k + 2]]);
        ASSERT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Spacing, MeshTest, testing::Values(0.5, 1.0, 2.0, 4.0));

TEST(MeshLattice, KeepsPolesAndCountsVertices) {
    Planet planet(512, 256, {});
    MeshLattice full = meshLattice(planet.nodes, 1), quarter = meshLattice(planet.nodes, 4);
    MeshLattice fine = meshLattice(planet.nodes, 0.25);
    EXPECT_EQ(full.columns(), 513);
    EXPECT_EQ(full.rows(), 258);
    EXPECT_EQ(quarter.columns(), 129);
    EXPECT_EQ(fine.columns(), 2049);
    EXPECT_EQ(fine.rows(), 4 * 257 + 1);
    EXPECT_EQ(quarter.node_rows.front(), 0);
    EXPECT_EQ(quarter.node_rows.back(), planet.nodes.rows());
}

}  // namespace
}  // namespace dsphere::bench
