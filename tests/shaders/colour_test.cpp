// The colours of images as the shaders find them, in double (the algorithm) and float (its precision), against the
// reference at the same points.

#include "reference/colour.h"
#include "render/packimage.h"
#include "tests/shaders/cpp_shaders.h"
#include "tests/support/testcolours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::test {
namespace {

struct Painted {
    Shape shape;
    ImageMap texture{"random", dvec3(0.9), -180.0, {}};
    ColourMap image;
    layout::ObjectData object = {};
    Resources resources;

    Painted(const Geometry& geometry, RawColour raw) : image(std::move(raw), "random") {
        shape.geometry = geometry;
        double inner = 0.0;
        object.kind = KIND_SPHERE;
        if (const auto* planet = std::get_if<DisplacedSphere>(&geometry)) {
            object.kind = KIND_DISPLACED;
            texture.longitude_origin = planet->longitude_origin.value_or(-180.0);
        } else if (const auto* disk = std::get_if<Disk>(&geometry)) {
            object.kind = KIND_DISK;
            inner = disk->inner_radius;
            object.inner_squared = float(inner * inner);
        }
        const PackedCentres centres = packImage(object, image, texture.longitude_origin, inner);
        object.image_centres_y = 2;
        resources.image = &image;
        resources.edges[2] = centres.columns;
        resources.edges[3] = centres.rows;
        object.texture_scale = glm::vec4(glm::vec3(texture.scale), 1.0f);
        current_resources = &resources;
    }
};

/// A point of the shape whose coordinates are floats.
glm::vec3 pointOn(const Geometry& geometry, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    dvec3 p(unit(random), unit(random), unit(random));
    if (const auto* disk = std::get_if<Disk>(&geometry)) {
        p.z = 0.0;
        return glm::vec3((disk->inner_radius + (1.0 - disk->inner_radius) * std::abs(unit(random))) *
                         glm::normalize(p));
    }
    return glm::vec3(glm::normalize(p));
}

/// Relative errors of every channel stay below: 1e-6 is a hundredth of what verify allows.
void expectAsReference(const Geometry& geometry, const RawColour& raw) {
    const Painted painted(geometry, raw);
    std::mt19937 random(3);
    double worst32 = 0.0, worst64 = 0.0;
    for (int k = 0; k < 40000; ++k) {
        const glm::vec3 p = pointOn(geometry, random);
        const dvec3 truth = reference::imageColour(painted.shape, painted.texture, painted.image, dvec3(p));
        const dvec3 in_double = glsl64::imageColour(painted.object, dvec3(p));
        const dvec3 in_float(glsl32::imageColour(painted.object, p));
        for (int c = 0; c < 3; ++c) {
            if (truth[c] == 0.0) {
                EXPECT_EQ(in_float[c], 0.0);
                continue;
            }
            worst32 = std::max(worst32, std::abs(in_float[c] / truth[c] - 1.0));
            worst64 = std::max(worst64, std::abs(in_double[c] / truth[c] - 1.0));
        }
    }
    EXPECT_LT(worst64, 1e-6);  // its texel centres and arc tangents are floats' too
    EXPECT_LT(worst32, 3e-6);
}

TEST(ShaderColour, IsTheReferencesOnEveryShape) {
    DisplacedSphere planet, turned;
    turned.longitude_origin = 77.0;
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {33, 16}, {1024, 512}, {4096, 2048}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        expectAsReference(planet, randomCodes(width, height));
        expectAsReference(turned, randomLight(width, height));
        expectAsReference(Sphere{1.0}, randomCodes(width, height, 2));
    }
    expectAsReference(Disk{.inner_radius = 0.25}, randomCodes(64, 32));
    expectAsReference(Disk{}, randomLight(7, 5));
}

TEST(ShaderColour, CoordinatesAreTheReferences) {
    const Disk disk{.inner_radius = 0.25};
    std::mt19937 random(4);
    for (const Geometry& geometry : {Geometry(DisplacedSphere{}), Geometry(Sphere{1.0}), Geometry(disk)}) {
        const Painted painted(geometry, randomCodes(1, 1));
        for (int k = 0; k < 1000; ++k) {
            const glm::vec3 p = pointOn(geometry, random);
            const dvec2 truth = reference::surfaceUv(painted.shape, dvec3(p));
            const dvec2 uv(glsl32::surfaceUv(painted.object, p, glsl32::kKinds));
            EXPECT_NEAR(uv.x, truth.x, 3e-7);
            EXPECT_NEAR(uv.y, truth.y, 3e-7);
        }
    }
}

}  // namespace
}  // namespace dsphere::test
