// The camera as the GPU gets it, against the reference's, which is written apart.

#include "render/raster.h"

#include "reference/camera.h"
#include "render/pack.h"
#include "scene/parser.h"

#include <gtest/gtest.h>

namespace dsphere::test {
namespace {

class RasterTest : public testing::TestWithParam<const char*> {
  protected:
    Scene scene_ = parseScene(std::string(GetParam()) + "\nWorldBegin\nShape \"sphere\"\n", "camera.pbrt", ".");
    Raster raster_ = makeRaster(scene_.camera, scene_.film);
};

TEST_P(RasterTest, RaysAreTheReferences) {
    for (double y : {0.0, 0.5, 17.25, double(scene_.film.height)})
        for (double x : {0.0, 0.5, 33.75, double(scene_.film.width)}) {
            reference::CameraRay ray = reference::cameraRay(scene_.camera, scene_.film, x, y);
            dvec3 direction = glm::normalize(raster_.direction.at(x, y)), start = raster_.start.at(x, y);
            EXPECT_LT(glm::distance(direction, ray.direction), 1e-14) << x << ", " << y;
            EXPECT_LT(glm::distance(start, ray.origin), 1e-13 * (1.0 + glm::length(ray.origin))) << x << ", " << y;
        }
}

TEST_P(RasterTest, ProjectIsTheInverse) {
    for (double y : {0.5, 17.25})
        for (double x : {0.5, 33.75}) {
            dvec2 place = raster_.project(raster_.start.at(x, y) + 3.0 * raster_.direction.at(x, y));
            EXPECT_NEAR(place.x, x, 1e-9);
            EXPECT_NEAR(place.y, y, 1e-9);
        }
}

dvec3 sumOf(const layout::vec4& row, const layout::vec4& row_lo) {
    return dvec3(row) + dvec3(row_lo);
}

// Rows and _lo rows together: 48 bits of what is fixed, 36 of the steps from pixel to pixel.
TEST_P(RasterTest, PackedRaysAreTheReferencesTo36Bits) {
    const PackedScene packed = packScene(scene_, loadSceneMaps(scene_));
    const layout::ObjectData& o = packed.state.objects.at(0).data;
    for (double y : {0.0, 17.0, scene_.film.height - 1.0})
        for (double x : {0.0, 33.0, scene_.film.width - 1.0}) {
            const double right = x - double(o.anchor_x), down = y - double(o.anchor_y);
            const dvec3 direction = sumOf(o.direction_0, o.direction_0_lo) +
                                    right * sumOf(o.direction_x, o.direction_x_lo) +
                                    down * sumOf(o.direction_y, o.direction_y_lo);
            const dvec3 point = sumOf(o.point_0, o.point_0_lo) + right * sumOf(o.point_x, o.point_x_lo) +
                                down * sumOf(o.point_y, o.point_y_lo);
            const reference::CameraRay ray = reference::cameraRay(scene_.camera, scene_.film, x + 0.5, y + 0.5);
            EXPECT_LT(glm::distance(glm::normalize(direction), ray.direction), 1e-10) << x << ", " << y;
            EXPECT_LT(glm::length(glm::cross(point - ray.origin, ray.direction)), 1e-10 * (1.0 + glm::length(point)))
                << x << ", " << y;
        }
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, RasterTest,
    testing::Values(
        "Camera \"perspective\"", "Camera \"perspective\" \"float fov\" 1 LookAt 3 4 500  0 0 0  0 1 0",
        "Scale -1 1 1 LookAt 3 1 -2  0 .2 0  .1 1 0 Camera \"perspective\" \"float fov\" 38",
        "LookAt 0 0 4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 140 "
        "Film \"rgb\" \"integer xresolution\" 90 \"integer yresolution\" 211",
        "Camera \"perspective\" \"float screenwindow\" [-2 1 -.25 .5]",
        "Camera \"perspective\" \"float frameaspectratio\" 2", "LookAt 3 1 -2  0 .2 0  .1 1 0 Camera \"orthographic\"",
        "Scale -1 1 1 LookAt 0 0 4  0 0 0  0 1 0 Camera \"orthographic\" \"float screenwindow\" [-2 3 -1 .5]"));

TEST(Raster, ProjectOfAPointBehindIsTheMiddle) {
    Scene scene = parseScene("Camera \"perspective\"\nWorldBegin\nShape \"sphere\"\n", "camera.pbrt", ".");
    EXPECT_EQ(makeRaster(scene.camera, scene.film).project({0.0, 0.0, -1.0}), dvec2(640.0, 360.0));
}

// pbrt: from ceil(x0 width) to before ceil(x1 width).
TEST(Raster, CropBox) {
    Film film;
    film.width = 10;
    film.height = 7;
    EXPECT_EQ(cropBox(film), (Box{0, 0, 10, 7}));
    film.crop = {0.25, 0.75, 0.5, 1.0};
    EXPECT_EQ(cropBox(film), (Box{3, 4, 8, 7}));
    film.crop = {0.0, 0.5, 0.0, 0.5};
    Box left = cropBox(film);
    film.crop = {0.5, 1.0, 0.5, 1.0};
    EXPECT_EQ((Box{left.x1, left.y1, 10, 7}), cropBox(film)) << "neighbours share no pixel and leave none out";
}

}  // namespace
}  // namespace dsphere::test
