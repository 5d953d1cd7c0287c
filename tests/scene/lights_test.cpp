// Infinite and area lights, and triangle meshes.

#include "tests/scene/support.h"

namespace dsphere {
namespace {

TEST(InfiniteLights, Constant) {
    auto light = onlyLight<InfiniteLight>("LightSource \"infinite\"");
    EXPECT_EQ(light, InfiniteLight{});
    EXPECT_EQ(onlyLight<InfiniteLight>("LightSource \"infinite\" \"rgb L\" [1 2 3] \"float scale\" 2").radiance,
              dvec3(2, 4, 6));
}

TEST(InfiniteLights, ImagesTurnWithTheTransform) {
    for (std::string word : {"mapname", "filename"}) {
        auto light = onlyLight<InfiniteLight>(
            "Translate 1 2 3 Scale -1 1 1 Rotate 90 0 0 1\nLightSource \"infinite\" "
            "\"string " +
            word + "\" \"sky.exr\"");
        EXPECT_EQ(light.map_path, "folder/sky.exr");
        EXPECT_EQ(light.where.line, 4);
        const dmat3 expected(dvec3(0, 1, 0), dvec3(1, 0, 0), dvec3(0, 0, 1));  // x to y, y to -x, then x mirrored
        for (int column = 0; column < 3; ++column) expectNear(light.world_from_light[column], expected[column]);
    }
}

TEST(InfiniteLights, MatricesOfSixDigitsAreRotations) {
    EXPECT_EQ(onlyLight<InfiniteLight>("Transform [.707107 .707107 0 0 -.707107 .707107 0 0 0 0 1 0 0 0 0 1]\n"
                                       "LightSource \"infinite\"")
                  .world_from_light[0]
                  .x,
              0.707107);
}

TEST(AreaLights, ShineFromSpheresAndDisksInTheFilesOrder) {
    Scene scene = parse(R"(WorldBegin
        Shape "sphere"
        AttributeBegin
            AreaLightSource "diffuse" "rgb L" [1 2 3] "float scale" 2
            Shape "sphere"
            LightSource "point"
            Scale -2 2 2
            Shape "disk"
        AttributeEnd
        Shape "sphere"
        AreaLightSource "diffuse" "bool twosided" true
        Shape "disk")");
    ASSERT_EQ(scene.shapes.size(), 5u);
    ASSERT_EQ(scene.lights.size(), 4u) << "the AttributeEnd ends the light";
    EXPECT_EQ(scene.lights[0], (Light{AreaLight{1, dvec3(2, 4, 6), false}}));
    EXPECT_EQ(scene.lights[1], Light{PointLight{}});
    EXPECT_EQ(scene.lights[2], (Light{AreaLight{2, dvec3(2, 4, 6), false}}));
    EXPECT_EQ(scene.lights[3], (Light{AreaLight{4, dvec3(1.0), true}}));
}

TEST(AreaLights, TransformEndKeepsThem) {
    Scene scene = parseParts("", "TransformBegin AreaLightSource \"diffuse\" TransformEnd");
    EXPECT_EQ(scene.lights.size(), 1u);
}

TriangleMesh meshOf(const std::string& parameters) {
    return std::get<TriangleMesh>(parse("WorldBegin Shape \"trianglemesh\" " + parameters).shapes.at(0).geometry);
}

TEST(TriangleMeshes, ThreePointsAreATriangle) {
    TriangleMesh mesh = meshOf("\"point3 P\" [0 0 0  1 0 0  0 2 0]");
    EXPECT_EQ(mesh.points, (std::vector<dvec3>{dvec3(0.0), dvec3(1, 0, 0), dvec3(0, 2, 0)}));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
    EXPECT_TRUE(mesh.uvs.empty());
}

TEST(TriangleMeshes, IndicesAndCoordinates) {
    const std::string quad = "\"point P\" [0 0 0 1 0 0 1 0 1 0 0 1] \"integer indices\" [0 1 2 0 2 3] ";
    for (std::string uv : {"\"point2 uv\"", "\"float uv\"", "\"float st\"", "\"point2 st\""}) {
        TriangleMesh mesh = meshOf(quad + uv + " [0 0 8 0 8 8 0 8]");
        EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
        EXPECT_EQ(mesh.uvs, (std::vector<dvec2>{{0, 0}, {8, 0}, {8, 8}, {0, 8}})) << uv;
    }
}

TEST(TriangleMeshes, SixtyFourAreEnough) {
    std::string points = "\"point3 P\" [", indices = "] \"integer indices\" [";
    for (int i = 0; i < 192; ++i) {
        points += std::to_string(i) + " " + std::to_string(i % 3 == 1) + " 0 ";
        indices += std::to_string(i) + " ";
    }
    EXPECT_EQ(meshOf(points + indices + "]").triangles.size(), 64u);
}

}  // namespace
}  // namespace dsphere
