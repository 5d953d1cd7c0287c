// The spans of pixels that are dispatched hold every ray that comes near an object.

#include "render/spans.h"

#include "reference/camera.h"
#include "tests/render/world.h"

#include <cmath>

namespace dsphere::test {
namespace {

class SpansTest : public WorldTest {
  protected:
    /// Whether a ray at the raster position comes within the greatest radius of a shape's centre.
    static bool near(const World& world, double x, double y) {
        reference::CameraRay ray = reference::cameraRay(world.scene.camera, world.scene.film, x, y);
        for (std::size_t i = 0; i < world.scene.shapes.size(); ++i) {
            const Shape& shape = world.scene.shapes[i];
            dmat4 to_object = glm::inverse(shape.world_from_object);
            dvec3 o = transformPoint(to_object, ray.origin), d = transformVector(to_object, ray.direction);
            double radius = world.maps.map_of_shape[i] >= 0 ? world.maps.reliefs[i].greatest_radius
                                                            : std::get<Sphere>(shape.geometry).radius;
            bool ahead = glm::dot(o, d) < 0.0 || glm::length(o) < radius;
            if (ahead && glm::length(glm::cross(o, d)) <= radius * glm::length(d)) return true;
        }
        return false;
    }

    /// Every near ray is inside; returns the share of the dispatched pixels that are near.
    static double expectAllInside(const World& world) {
        Box box = cropBox(world.scene.film);
        std::vector<Span> spans = objectSpans(world.packed.state.objects, box);
        EXPECT_EQ(spans.size(), std::size_t(box.height()));
        int inside = 0, used = 0;
        for (int j = 0; j < box.height(); ++j) {
            const Span& span = spans[std::size_t(j)];
            EXPECT_TRUE(span.empty() || (span.x0 >= 0 && span.x1 <= box.width()));
            inside += span.empty() ? 0 : span.x1 - span.x0;
            for (int i = 0; i < box.width(); ++i) {
                bool any = false;  // at any jitter
                for (double dy : {0.0, 0.5, 1.0})
                    for (double dx : {0.0, 0.5, 1.0}) any = any || near(world, box.x0 + i + dx, box.y0 + j + dy);
                used += any;
                if (any) {
                    EXPECT_TRUE(i >= span.x0 && i < span.x1) << "pixel " << i << ", " << j;
                }
            }
        }
        return inside ? double(used) / inside : 1.0;
    }
};

// Spans are wider by some five pixels a side, much on so small a picture.
TEST_F(SpansTest, OneSphere) {
    EXPECT_GT(expectAllInside(world(planet())), 0.6);
}

TEST_F(SpansTest, SmallOnesApart) {
    EXPECT_GT(expectAllInside(world("Translate -1 .6 0\nShape \"sphere\" \"float radius\" .3\n")), 0.35);
    expectAllInside(
        world("Translate -1 .6 0\nShape \"sphere\" \"float radius\" .3\n"
              "Translate 2.2 -1 .5\nShape \"sphere\" \"float radius\" .2\n"));
}

TEST_F(SpansTest, AtTheEdgeAndOutside) {
    expectAllInside(world("Translate 3 0 0\nShape \"sphere\" \"float radius\" 1\n"));
    World far_off = world("Translate 50 0 0\nShape \"sphere\" \"float radius\" 1\n");
    for (const Span& span : objectSpans(far_off.packed.state.objects, cropBox(far_off.scene.film)))
        EXPECT_TRUE(span.empty());
}

TEST_F(SpansTest, TransformedOnes) {
    expectAllInside(world("Translate .3 .1 0\nRotate 30 1 1 0\nScale 1.4 .3 .8\n" + planet()));
}

TEST_F(SpansTest, CameraInsideOrClose) {
    expectAllInside(world("Translate 0 .5 4\nShape \"sphere\" \"float radius\" 2\n"));
    expectAllInside(world("Translate 0 .5 2.9\nShape \"sphere\" \"float radius\" 1\n"));
}

// A sphere of radius 1 whose ground is `height` below the camera, which looks so many degrees down and is rolled.
std::string groundBelow(double height, double down, double roll) {
    const dvec3 eye(0.0, 0.5, 4.0), forward = glm::normalize(-eye),
                                    right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const dvec3 up = glm::cross(right, forward);
    const dvec3 below = std::sin(glm::radians(roll)) * right - std::cos(glm::radians(roll)) * up;
    const dvec3 centre =
        eye + (1.0 + height) * (std::cos(glm::radians(down)) * below + std::sin(glm::radians(down)) * forward);
    return fmt::format("Translate {} {} {}\nShape \"sphere\" \"float radius\" 1\n", centre.x, centre.y, centre.z);
}

// The sky is left out, though lines through its pixels meet the sphere behind the camera.
TEST_F(SpansTest, CloseAboveTheGround) {
    for (double roll : {0.0, 20.0, 90.0, 200.0, 315.0})
        for (double height : {0.001, 0.01, 0.1, 1.0})
            for (double down : {-15.0, 0.0, 5.0, 30.0, 85.0}) {
                SCOPED_TRACE(fmt::format("height {}, {} degrees down, roll {}", height, down, roll));
                EXPECT_GT(expectAllInside(world(groundBelow(height, down, roll))), height < 0.1 ? 0.6 : 0.4);
            }
    const World away = world(groundBelow(0.01, -80.0, 0.0));
    for (const Span& span : objectSpans(away.packed.state.objects, cropBox(away.scene.film))) EXPECT_TRUE(span.empty());
}

// Its rays have many starts, however far off it stands.
TEST_F(SpansTest, Orthographic) {
    for (double distance : {3.0, 1e4, 1e8}) {
        SCOPED_TRACE(distance);
        World far;
        far.scene =
            parseScene(fmt::format("LookAt 0 0 {} 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" "
                                   "[-1.8 1.8 -1.013 1.013]\nFilm \"rgb\" \"integer xresolution\" 72 "
                                   "\"integer yresolution\" 40\nWorldBegin\nShape \"sphere\" \"float radius\" 1\n",
                                   distance),
                       "world.pbrt", folder_.path());
        far.maps = loadSceneMaps(far.scene);
        far.packed = packScene(far.scene, far.maps);
        EXPECT_GT(expectAllInside(far), 0.6);
    }
}

TEST_F(SpansTest, Crop) {
    expectAllInside(world(planet(), "\"float cropwindow\" [.4 .9 .2 .7]"));
}

}  // namespace
}  // namespace dsphere::test
