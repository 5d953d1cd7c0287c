#include "viewer/standin.h"

#include "render/traits.h"
#include "scene/parser.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

Scene parsedPaths(const std::string& world) {
    return parseScene("Integrator \"path\"\nPixelFilter \"gaussian\"\nWorldBegin\n" + world, "standin.pbrt", "/maps");
}

TEST(StandIn, NeedsNoPaths) {
    const Scene scene = parsedPaths(
        "LightSource \"infinite\" \"rgb L\" [.1 .2 .3]\n"
        "AttributeBegin\nTranslate 0 5 0\nScale 2 2 2\nAreaLightSource \"diffuse\" \"rgb L\" [3 3 3]\n"
        "Shape \"sphere\" \"float radius\" 0.5\nAttributeEnd\n"
        "Material \"conductor\"\nShape \"displacedsphere\" \"string displacementmap\" \"a.png\"\n"
        "Material \"plastic\" \"rgb Kd\" [.1 .5 .2]\nShape \"sphere\"\n"
        "Material \"matte\" \"float sigma\" 20\nShape \"trianglemesh\" \"integer indices\" [0 1 2  0 2 3]\n"
        "\"point3 P\" [-2 -1 2  2 -1 2  2 -1 -2  -2 -1 -2]\n");
    ASSERT_TRUE(traitsOf(scene).needsPaths());
    const Scene plain = standIn(scene);
    EXPECT_FALSE(traitsOf(plain).needsPaths());
    ASSERT_EQ(plain.shapes.size(), scene.shapes.size()) << "shapes keep their numbers";
    EXPECT_EQ(plain.shapes[1].geometry, scene.shapes[1].geometry);
    EXPECT_EQ(textureAs<ConstantColour>(plain.shapes[2].material)->rgb, dvec3(.1, .5, .2));
    const auto& ground = std::get<Disk>(plain.shapes[3].geometry);
    EXPECT_NEAR(kPi * ground.radius * ground.radius, 16.0, 1e-9) << "as large as the mesh";
    EXPECT_NEAR(glm::length(transformPoint(plain.shapes[3].world_from_object, dvec3(0.0)) - dvec3(0, -1, 0)), 0.0,
                1e-12);
    ASSERT_EQ(plain.lights.size(), 2u);
    const auto& lamp = std::get<PointLight>(plain.lights[1]);
    EXPECT_NEAR(glm::length(lamp.position - dvec3(0, 5, 0)), 0.0, 1e-12);
    EXPECT_NEAR(lamp.intensity.x, 3.0 * kPi, 1e-9) << "radiance times the disk that is seen, of radius 1";
}

}  // namespace
}  // namespace dsphere::viewer
