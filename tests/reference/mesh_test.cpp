// Triangle meshes: hits by hand, no gaps between triangles, coordinates and the checkerboard on them.

#include "reference/mesh.h"

#include "reference/colour.h"
#include "reference/tracer.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference::test {
namespace {

/// The square [-1, 1]^2 at z = 1, normals +z, of two triangles.
TriangleMesh square() {
    return {.points = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .uvs = {}};
}

TEST(HitMesh, FromBothSides) {
    for (double side : {1.0, -1.0}) {
        Ray ray{.origin = {0.5, -0.5, 1.0 + 3.0 * side}, .direction = {0.0, 0.0, -2.0 * side}};
        const FirstHit hit = hitMesh(square(), ray);
        ASSERT_TRUE(hit.hit);
        EXPECT_FALSE(hit.inside);
        EXPECT_DOUBLE_EQ(hit.t(), 1.5);
        EXPECT_LT(glm::distance(hit.position, dvec3(0.5, -0.5, 1.0)), 1e-15);
        ray.t_max = 1.4;
        EXPECT_FALSE(hitMesh(square(), ray).hit);
        ray.t_max = 9.0;
        ray.t_min = 1.6;
        EXPECT_FALSE(hitMesh(square(), ray).hit);
        ray.t_min = 0.0;
        ray.origin.x = 1.001;
        EXPECT_FALSE(hitMesh(square(), ray).hit);
    }
    EXPECT_FALSE(hitMesh(square(), {.origin = {-3.0, 0.0, 1.0}, .direction = {1.0, 0.0, 0.0}}).hit) << "in its plane";
    Ray from{.origin = {0.25, 0.0, 1.0}, .direction = {0.0, 0.1, 1.0}};
    EXPECT_TRUE(hitMesh(square(), from).hit);
    from.may_start_inside = false;
    EXPECT_FALSE(hitMesh(square(), from).hit);
}

// Rays at the diagonal's and the fan's edges, to the last bit and at random, all hit.
TEST(HitMesh, HasNoGaps) {
    TriangleMesh fan;
    fan.points.push_back({0.1, 0.2, 0.3});
    for (int k = 0; k < 12; ++k) fan.points.push_back({std::cos(k * kPi / 6), std::sin(k * kPi / 6), 0.1 * (k % 3)});
    for (int k = 0; k < 12; ++k) fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 12});
    Random random(9);
    for (int k = 0; k < 20000; ++k) {
        const int corner = 1 + k % 12;
        const dvec3 target =
            fan.points[0] + uniform(random, 0.0, 0.9) * (fan.points[std::size_t(corner)] - fan.points[0]);
        const dvec3 from(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, 3.0, 1e5));
        const FirstHit hit = hitMesh(fan, {.origin = from, .direction = target - from});
        ASSERT_TRUE(hit.hit);
        EXPECT_NEAR(hit.t(), 1.0, 1e-12);
        EXPECT_LT(nearestOnMesh(fan, hit.position).distance, 1e-13);
    }
}

TEST(Mesh, NearestPoint) {
    const MeshPoint above = nearestOnMesh(square(), {0.5, -0.5, 3.0});
    EXPECT_EQ(above.triangle, 0);
    EXPECT_DOUBLE_EQ(above.distance, 2.0);
    EXPECT_LT(glm::distance(above.barycentric, dvec3(0.25, 0.5, 0.25)), 1e-15);
    const MeshPoint corner = nearestOnMesh(square(), {-4.0, 5.0, 1.0});
    EXPECT_EQ(corner.triangle, 1);
    EXPECT_DOUBLE_EQ(corner.distance, 5.0);
    EXPECT_EQ(meshNormal(square(), 0), dvec3(0.0, 0.0, 1.0));
}

TEST(Mesh, Coordinates) {
    TriangleMesh mesh = square();
    Shape shape;
    shape.geometry = mesh;
    // pbrt's own: (0, 0), (1, 0), (1, 1) at the corners of either triangle.
    EXPECT_LT(glm::distance(surfaceUv(shape, {0.5, -0.5, 1.0}), dvec2(0.75, 0.25)), 1e-15);
    EXPECT_LT(glm::distance(surfaceUv(shape, {-0.5, 0.5, 1.0}), dvec2(0.75, 0.5)), 1e-15);
    mesh.uvs = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
    shape.geometry = mesh;
    for (const dvec3& p : {dvec3(0.5, -0.5, 1.0), dvec3(-0.5, 0.5, 1.0), dvec3(0.25, 0.25, 1.0)})
        EXPECT_LT(glm::distance(surfaceUv(shape, p), dvec2(2.0 * (p.x + 1.0), p.y + 1.0)), 1e-14);
}

TEST(Checkerboard, TakesTurns) {
    const Checkerboard board{.even = dvec3(0.9), .odd = dvec3(0.1), .u_scale = 4.0, .v_scale = 2.0};
    EXPECT_EQ(checkerboardColour(board, {0.1, 0.1}), dvec3(0.9));
    EXPECT_EQ(checkerboardColour(board, {0.3, 0.1}), dvec3(0.1));
    EXPECT_EQ(checkerboardColour(board, {0.3, 0.6}), dvec3(0.9));
    EXPECT_EQ(checkerboardColour(board, {-0.1, 0.1}), dvec3(0.1));
    EXPECT_EQ(checkerboardColour(board, {-0.1, -0.1}), dvec3(0.9));
    EXPECT_EQ(checkerboardColour(board, {-0.3, -0.1}), dvec3(0.1));
}

TEST(Tracer, MeetsMeshes) {
    Scene scene;
    Shape floor;
    floor.geometry = square();
    floor.world_from_object = glm::rotate(glm::scale(dmat4(1.0), dvec3(2.0)), kPi, dvec3(1.0, 0.0, 0.0));
    floor.material =
        Matte{.reflectance = Checkerboard{.even = dvec3(0.8), .odd = dvec3(0.2), .u_scale = 2.0, .v_scale = 1.0}};
    scene.shapes.push_back(floor);
    const Tracer tracer(scene, {nullptr}, {{}});
    // The square lies at z = -2 now, its own normals downward.
    const WorldHit hit = tracer.firstHit({0.5, 0.5, 5.0}, {0.0, 0.0, -1.0});
    ASSERT_TRUE(hit.hit);
    EXPECT_DOUBLE_EQ(hit.t(), 7.0);
    EXPECT_LT(glm::distance(hit.normal, dvec3(0.0, 0.0, -1.0)), 1e-15);
    EXPECT_LT(glm::distance(hit.shading_normal, dvec3(0.0, 0.0, 1.0)), 1e-15);
    EXPECT_EQ(tracer.reflectance(0, hit.object_position), dvec3(0.2)) << "u = 0.625";
    const dvec3 above(0.5, 0.5, -2.0 + 1e-6), own = transformPoint(tracer.objectFromWorld(0), above);
    EXPECT_FALSE(tracer.occluded(above, {0.0, 0.0, 1.0}, 1e9, 0, own));
    EXPECT_TRUE(tracer.occluded(above, {0.0, 0.0, -1.0}, 1e9, 0, own));
    EXPECT_FALSE(tracer.occluded(above, {0.0, 0.0, -1.0}, 1e9, 0, own, 0)) << "as the emitter it throws no shadow";
}

}  // namespace
}  // namespace dsphere::reference::test
