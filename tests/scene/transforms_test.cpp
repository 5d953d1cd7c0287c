// The transforms against matrices worked out by hand from pbrt's definitions.

#include "scene/transforms.h"
#include "tests/scene/support.h"

namespace dsphere {
namespace {

dmat4 cameraFromWorld(const std::string& transforms) {
    return parseParts(transforms + " Camera \"perspective\"").camera.camera_from_world;
}

dmat4 worldFromObject(const std::string& world) {
    return parseParts("", world).shapes.back().world_from_object;
}

TEST(Transforms, EachAlone) {
    expectNear(cameraFromWorld("Translate 1 -2 3"), rows({1, 0, 0, 1}, {0, 1, 0, -2}, {0, 0, 1, 3}));
    expectNear(cameraFromWorld("Scale 2 3 -4"), rows({2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, -4, 0}));
    expectNear(cameraFromWorld("Rotate 90 1 0 0"), rows({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}));
    expectNear(cameraFromWorld("Rotate 90 0 7 0"), rows({0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}));
    expectNear(cameraFromWorld("Rotate -90 0 0 2"), rows({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}));
    expectNear(cameraFromWorld("Rotate 120 1 1 1"), rows({0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}));
    expectNear(cameraFromWorld("Translate 5 5 5 Identity"), dmat4(1.0));
}

TEST(Transforms, MatricesAreWrittenColumnByColumn) {
    std::string matrix = "[1 2 3 0  4 5 7 0  7 8 10 0  10 11 12 1]";
    dmat4 expected = rows({1, 4, 7, 10}, {2, 5, 8, 11}, {3, 7, 10, 12});
    expectNear(cameraFromWorld("Scale 2 2 2 Transform " + matrix), expected);
    expectNear(cameraFromWorld("Scale 2 3 4 ConcatTransform " + matrix),
               rows({2, 8, 14, 20}, {6, 15, 24, 33}, {12, 28, 40, 48}));
}

TEST(Transforms, LaterOnesApplyToPointsFirst) {
    expectNear(cameraFromWorld("Translate 1 0 0 Scale 2 2 2"), rows({2, 0, 0, 1}, {0, 2, 0, 0}, {0, 0, 2, 0}));
    expectNear(cameraFromWorld("Scale 2 2 2 Translate 1 0 0"), rows({2, 0, 0, 2}, {0, 2, 0, 0}, {0, 0, 2, 0}));
}

TEST(Transforms, LookAtIsLeftHanded) {
    expectNear(cameraFromWorld("LookAt 0 0 -5  0 0 0  0 1 0"), rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 5}));
    // From +x: direction -x, right = up x direction = +z.
    expectNear(cameraFromWorld("LookAt 5 0 0  0 0 0  0 9 0"), rows({0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 5}));
    // From (3, 0, 4), up tilted towards the view: direction (-3, 0, -4)/5, right (-4, 0, 3)/5.
    expectNear(cameraFromWorld("LookAt 3 0 4  0 0 0  -3 1 -4"), rows({-.8, 0, .6, 0}, {0, 1, 0, 0}, {-.6, 0, -.8, 5}));
}

TEST(Transforms, EastLiesToTheRightOnlyWithScaleMinusOne) {
    std::string look = "LookAt 0 0 5  0 0 0  0 1 0";
    dvec3 east(0.1, 0.0, 1.0);  // of longitude 0, which faces +z and the camera
    EXPECT_LT(transformPoint(cameraFromWorld(look), east).x, 0.0);
    EXPECT_GT(transformPoint(cameraFromWorld("Scale -1 1 1 " + look), east).x, 0.0);
}

TEST(Transforms, WorldBeginsWithTheIdentity) {
    EXPECT_EQ(parseParts("Translate 1 2 3").shapes.back().world_from_object, dmat4(1.0));
    EXPECT_EQ(parseParts("Translate 1 2 3 Camera \"perspective\"").camera.camera_from_world[3], dvec4(1, 2, 3, 1));
    EXPECT_EQ(parseParts("Camera \"perspective\" Translate 1 2 3").camera.camera_from_world, dmat4(1.0));
}

TEST(Transforms, BlocksRestoreThem) {
    dmat4 shifted = rows({1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0});
    expectNear(worldFromObject("Translate 1 0 0 AttributeBegin Scale 2 2 2 AttributeEnd"), shifted);
    expectNear(worldFromObject("Translate 1 0 0 TransformBegin Scale 2 2 2 TransformEnd"), shifted);
    expectNear(worldFromObject("Translate 1 0 0 AttributeBegin TransformBegin Identity TransformEnd Scale 9 9 9 "
                               "AttributeEnd"),
               shifted);
}

TEST(Transforms, TransformEndKeepsTheMaterial) {
    Scene scene = parseParts("", "TransformBegin Material \"matte\" \"rgb Kd\" [1 0 0] TransformEnd");
    EXPECT_EQ(scene.shapes.back().material, Material{Matte{ConstantColour{dvec3(1, 0, 0)}}});
}

TEST(Transforms, UnitVectorOfAnyMagnitude) {
    for (double size : {1e-320, 1e-200, 1.0, 1e200, 1e308}) {
        std::optional<dvec3> unit = unitVector(dvec3(0.0, -size, size));
        ASSERT_TRUE(unit) << size;
        expectNear(*unit, dvec3(0.0, -std::sqrt(0.5), std::sqrt(0.5)));
    }
    EXPECT_FALSE(unitVector(dvec3(0.0)));
}

TEST(Transforms, Invertibility) {
    EXPECT_TRUE(isInvertible(dmat4(1.0)));
    EXPECT_FALSE(isInvertible(dmat4(0.0)));
    EXPECT_FALSE(isInvertible(rows({1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 1, 0})));
    EXPECT_FALSE(isInvertible(rows({1e-150, 0, 0, 0}, {0, 1e-150, 0, 0}, {0, 0, 1e-150, 0})));
    EXPECT_TRUE(isInvertible(rows({1e-9, 0, 0, 0}, {0, 1e-9, 0, 0}, {0, 0, 1e9, 0})));
}

}  // namespace
}  // namespace dsphere
