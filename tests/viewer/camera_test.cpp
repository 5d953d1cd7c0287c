#include "viewer/camera.h"

#include "scene/parser.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::viewer {
namespace {

constexpr int kWidth = 640, kHeight = 360;

/// A unit sphere at the origin, under each camera's own text.
struct View {
    Scene scene;
    Globe globe;
    CameraControl control;

    explicit View(const std::string& camera)
        : scene(parseScene(camera +
                               "\nFilm \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 360\nWorldBegin\n"
                               "Shape \"displacedsphere\"\n",
                           "v.pbrt", {})),
          globe(scene.shapes[0], nullptr, {}),
          control(scene.camera, scene.film, globe) {}

    /// The near point of the unit sphere under the cursor.
    std::optional<dvec3> under(const dvec2& cursor) const {
        CursorRay ray = control.rayAt(cursor);
        double b = glm::dot(ray.origin, ray.direction);
        double room = b * b - glm::dot(ray.origin, ray.origin) + 1.0;
        if (room < 0.0) return {};
        return ray.origin + (-b - std::sqrt(room)) * ray.direction;
    }
    dvec2 project(const dvec3& point) const { return makeRaster(control.camera(), scene.film).project(point); }
    double level() const { return glm::dot(glm::normalize(Pose::of(control.camera()).right), dvec3(0.0, 1.0, 0.0)); }
};

const char* const kCameras[] = {
    "Scale -1 1 1 LookAt 0.6 1.05 3.19  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 39.5",
    "LookAt 3 .2 1  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 60",
    "Scale -1 1 1 LookAt .2 .1 1.2  .5 .3 0  0 1 0 Camera \"perspective\" \"float fov\" 40",
    "Scale -1 1 1 LookAt 0 1 5  0 0 0  0 1 0 Camera \"orthographic\" \"float screenwindow\" [-2.4 2.4 -1.35 1.35]",
};

class Cameras : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, Cameras, testing::ValuesIn(kCameras));

TEST_P(Cameras, TheGrabbedGroundStaysUnderTheCursor) {
    View view(GetParam());
    const dvec2 from(330.0, 170.0);
    std::optional<dvec3> grabbed = view.under(from);
    ASSERT_TRUE(grabbed);
    const double level = view.level();
    view.control.grab(from, grabbed);
    for (dvec2 to : {dvec2(350.0, 170.0), dvec2(330.0, 200.0), dvec2(300.5, 140.25), dvec2(372.0, 215.0)}) {
        view.control.orbitTo(to);
        EXPECT_LT(glm::length(view.project(*grabbed) - to), 1e-6) << to.x << ' ' << to.y;
        EXPECT_NEAR(view.level(), level, 1e-9) << "the horizon does not roll";
    }
    view.control.orbitTo(from);
    EXPECT_LT(glm::length(Pose::of(view.control.camera()).eye - Pose::of(view.scene.camera).eye), 1e-9)
        << "back at the start nothing has drifted";
}

TEST_P(Cameras, PanningHoldsThePointToo) {
    View view(GetParam());
    const dvec2 from(330.0, 170.0), to(410.0, 120.0);
    std::optional<dvec3> grabbed = view.under(from);
    view.control.grab(from, grabbed);
    view.control.panTo(to);
    EXPECT_LT(glm::length(view.project(*grabbed) - to), 1e-6);
    EXPECT_NEAR(glm::length(Pose::of(view.control.camera()).ahead - Pose::of(view.scene.camera).ahead), 0.0, 1e-12);
}

TEST_P(Cameras, ZoomKeepsWhatIsUnderTheCursorThere) {
    View view(GetParam());
    const dvec2 cursor(300.0, 190.0);
    std::optional<dvec3> point = view.under(cursor);
    for (double steps : {1.0, 3.0, -2.0, 0.25, -5.0}) {
        view.control.zoom(cursor, point, steps);
        EXPECT_LT(glm::length(view.project(*point) - cursor), 1e-5) << steps;
    }
}

TEST_P(Cameras, HandednessAndResetAreExact) {
    View view(GetParam());
    const double hand = Pose::of(view.scene.camera).handedness();
    view.control.grab({300.0, 100.0}, view.under({330.0, 170.0}));
    view.control.orbitTo({400.0, 150.0});
    view.control.axisView(7);
    EXPECT_EQ(Pose::of(view.control.camera()).handedness(), hand);
    view.control.reset();
    EXPECT_EQ(view.control.camera(), view.scene.camera);
}

TEST(CameraControl, NeverGoesThroughTheGround) {
    View view(kCameras[0]);
    const dvec2 cursor(320.0, 180.0);
    double last = view.control.altitude();
    for (int i = 0; i < 200; ++i) {
        view.control.zoom(cursor, view.under(cursor), 1.0);
        EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
        EXPECT_LE(view.control.altitude(), last + 1e-12);
        last = view.control.altitude();
    }
    EXPECT_LT(last, 1.01 * CameraControl::kLowest);
    for (int i = 0; i < 100; ++i) view.control.fly({0.0, -0.3, 1.0}, 0.1);
    EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
}

TEST(CameraControl, ReachesAMillionRadiiAndComesBack) {
    View view(kCameras[0]);
    const dvec2 cursor(320.0, 180.0);
    for (int i = 0; i < 120; ++i) view.control.zoom(cursor, view.under(cursor), -1.0);
    EXPECT_NEAR(view.control.altitude() / CameraControl::kHighest, 1.0, 1e-3);
    for (int i = 0; i < 160; ++i) view.control.zoom({400.0, 200.0}, view.under({400.0, 200.0}), 1.0);
    EXPECT_LT(view.control.altitude(), 2.0);
}

TEST(CameraControl, FliesAsFastAsItIsHigh) {
    View view(kCameras[0]);
    double high = view.control.altitude();
    dvec3 before = Pose::of(view.control.camera()).eye;
    view.control.fly({1.0, 0.0, 0.0}, 0.1);
    EXPECT_NEAR(glm::length(Pose::of(view.control.camera()).eye - before), 0.1 * high, 1e-9);
}

TEST(CameraControl, TiltsToTheHorizonAndNotBeyondTheZenith) {
    View view(kCameras[0]);
    const dvec2 cursor(320.0, 180.0);
    for (int i = 0; i < 8; ++i) view.control.zoom(cursor, view.under(cursor), 1.0);
    std::optional<dvec3> point = view.under(cursor);
    dvec3 vertical = glm::normalize(*point);
    auto slant = [&] { return -glm::dot(glm::normalize(Pose::of(view.control.camera()).ahead), vertical); };
    double before = slant();
    view.control.grab(cursor, point);
    view.control.tiltTo({320.0, 100.0});
    EXPECT_LT(slant(), before) << "an upward drag looks more along the ground";
    view.control.tiltTo({320.0, 3000.0});
    EXPECT_NEAR(slant(), 1.0, 1e-9) << "straight down";
    view.control.tiltTo({320.0, -3000.0});
    EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
}

// '1' looks at latitude 0, longitude 0 with north up and east to the right in a mirrored scene.
TEST(CameraControl, AxisViews) {
    View view(kCameras[0]);
    view.control.axisView(1);
    EXPECT_LT(glm::length(view.project({0.0, 0.0, 1.0}) - dvec2(320.0, 180.0)), 1e-9);
    EXPECT_LT(view.project({0.0, 0.5, 0.8}).y, 180.0);
    EXPECT_GT(view.project({0.5, 0.0, 0.8}).x, 320.0);
    double rim = 180.0 - view.project({0.0, 1.0, 0.0}).y;
    EXPECT_GT(rim, 0.7 * 180.0);
    EXPECT_LT(rim, 180.0);
    view.control.axisView(3);
    EXPECT_LT(glm::length(view.project({1.0, 0.0, 0.0}) - dvec2(320.0, 180.0)), 1e-9);
    view.control.axisView(7);
    EXPECT_LT(glm::length(view.project({0.0, 1.0, 0.0}) - dvec2(320.0, 180.0)), 1e-9);
}

}  // namespace
}  // namespace dsphere::viewer
