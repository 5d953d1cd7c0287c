#include "viewer/camera.h"

#include "scene/parser.h"
#include "scene/transforms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::viewer {
namespace {

constexpr int kWidth = 640, kHeight = 360;

/// A unit sphere at the origin, under each camera's own text.
struct View {
    Scene scene;
    std::shared_ptr<const Bodies> bodies;
    CameraControl control;

    explicit View(const std::string& camera)
        : scene(parseScene(camera +
                               "\nFilm \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 360\nWorldBegin\n"
                               "Shape \"displacedsphere\"\n",
                           "v.pbrt", {})),
          bodies(std::make_shared<const Bodies>(std::vector{Globe(scene.shapes[0], nullptr, {})})),
          control(scene.camera, scene.film, bodies, 0) {}

    void grab(const dvec2& cursor) {
        const std::optional<dvec3> point = under(cursor);
        control.grab(cursor, point ? std::optional(Hit{*point, 0}) : std::nullopt);
    }

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
    view.grab(from);
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
    view.grab(from);
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
    view.grab({330.0, 170.0});
    view.control.orbitTo({400.0, 150.0});
    view.control.axisView(Side::North);
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

// With the cursor beside the middle: where the ray comes as near as the eye may, the wheel stops.
TEST(CameraControl, TheWheelStopsAtTheGroundAndDoesNotSlide) {
    View view("LookAt 0 0 1.00115  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 90");
    const dvec2 cursor(620.0, 180.0);
    const dvec3 start = Pose::of(view.control.camera()).eye;
    dvec3 last = start;
    for (int i = 0; i < 30; ++i) {
        const dvec3 ray = view.control.rayAt(cursor).direction;
        view.control.zoom(cursor, view.under(cursor), 1.0);
        const dvec3 eye = Pose::of(view.control.camera()).eye, moved = eye - last;
        EXPECT_LT(glm::length(glm::cross(moved, ray)), 1e-9) << "along the cursor's ray alone";
        last = eye;
    }
    EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
    EXPECT_LT(glm::length(last - start), 0.001);
    const Camera stopped = view.control.camera();
    view.control.zoom(cursor, view.under(cursor), 1.0);
    EXPECT_EQ(view.control.camera(), stopped);
}

std::shared_ptr<const Bodies> ballOf(double radius) {
    Relief relief;
    relief.base = relief.least_radius = relief.greatest_radius = radius;
    const Scene scene = parseScene("WorldBegin\nShape \"displacedsphere\"\n", "ball.pbrt", {});
    return std::make_shared<const Bodies>(std::vector{Globe(scene.shapes[0], nullptr, relief)});
}

TEST(CameraControl, GroundThatRisesPastTheEyeTakesItAlongAndBack) {
    View view("LookAt 0 0 3  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40");
    const Camera before = view.control.camera();
    EXPECT_FALSE(view.control.setBodies(ballOf(1.5)));
    EXPECT_EQ(view.control.camera(), before) << "it has room";
    EXPECT_TRUE(view.control.setBodies(ballOf(30.0)));
    EXPECT_NEAR(Pose::of(view.control.camera()).eye.z, 60.0, 1e-9) << "as large in the window as it was";
    EXPECT_FALSE(view.control.setBodies(ballOf(1.0)));
    EXPECT_EQ(view.control.camera(), before);
    view.control.setBodies(ballOf(30.0));
    view.control.reset();
    EXPECT_GT(view.control.altitude(), 30.0) << "the first view would be inside";
    const Camera moved = view.control.camera();
    view.control.setBodies(ballOf(1.0));
    EXPECT_EQ(view.control.camera(), moved) << "where the eye was put since, it stays";
}

TEST(CameraControl, ZoomsOutWhileThePlanetIsSeenAndComesBack) {
    View view(kCameras[0]);
    const dvec2 cursor(320.0, 180.0);
    for (int i = 0; i < 120; ++i) view.control.zoom(cursor, view.under(cursor), -1.0);
    const Pose pose = Pose::of(view.control.camera());
    const double rim = glm::length(view.project(glm::normalize(pose.up)) - view.project(dvec3(0.0)));
    EXPECT_NEAR(2.0 * rim, CameraControl::kFewestPixels, 0.1);
    for (int i = 0; i < 160; ++i) view.control.zoom({400.0, 200.0}, view.under({400.0, 200.0}), 1.0);
    EXPECT_LT(view.control.altitude(), 2.0);
}

// The sky that was grabbed near the ground stays under the cursor, about, and the eye stays where it is.
TEST(CameraControl, TheSkyNearTheGroundLooksAround) {
    for (const char* mirrored : {"", "Scale -1 1 1 "}) {
        View view(std::string(mirrored) + "LookAt 0 0 1.1  0.4 0 1.1  0 0 1 Camera \"perspective\" \"float fov\" 60");
        const dvec2 from(300.0, 40.0);
        ASSERT_FALSE(view.under(from));
        const dvec3 eye = Pose::of(view.control.camera()).eye, sky = eye + 1e3 * view.control.rayAt(from).direction;
        const double level = view.level();
        view.grab(from);
        for (dvec2 to : {dvec2(330.0, 40.0), dvec2(300.0, 70.0), dvec2(250.0, 55.0)}) {
            view.control.orbitTo(to);
            EXPECT_LT(glm::length(view.project(sky) - to), 6.0) << mirrored << to.x << ' ' << to.y;
            EXPECT_LT(glm::length(Pose::of(view.control.camera()).eye - eye), 1e-9);
            EXPECT_NEAR(view.level(), level, 0.05) << "the horizon does not roll";
        }
        view.control.tiltTo({300.0, 60.0});
        EXPECT_LT(glm::length(Pose::of(view.control.camera()).eye - eye), 1e-9) << "tilting too";
        view.control.panTo({310.0, 40.0});
        EXPECT_LT(glm::length(Pose::of(view.control.camera()).eye - eye), 0.1)
            << "and what moves is as far as the ground";
    }
}

// A hill above the eye: the ball that it lies on has the eye inside.
TEST(CameraControl, GroundAboveTheEyeLooksAround) {
    View view("LookAt 0 0 1.1  0.4 0 1.1  0 0 1 Camera \"perspective\" \"float fov\" 60");
    const dvec3 eye = Pose::of(view.control.camera()).eye;
    const dvec2 from(320.0, 150.0);
    view.control.grab(from, Hit{eye + 0.2 * view.control.rayAt(from).direction, 0});
    view.control.orbitTo({330.0, 160.0});
    EXPECT_LT(glm::length(Pose::of(view.control.camera()).eye - eye), 1e-9);
}

TEST(CameraControl, FromInsideTheGroundThereIsAWayOut) {
    for (double steps : {1.0, -1.0}) {
        View view("LookAt 0 0 .5  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40");
        view.control.zoom({320.0, 180.0}, Pose::of(view.scene.camera).eye, steps);
        EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
    }
    View view("LookAt 0 0 .5  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40");
    view.control.fly({0.0, 0.0, 1.0}, 0.01);
    EXPECT_GE(view.control.altitude(), 0.999 * CameraControl::kLowest);
}

/// A planet, a plain sphere, a disk and a triangle in a row along z, before a camera that looks at each.
TEST(CameraControl, FliesThroughNoShape) {
    Scene scene = parseScene(
        "Camera \"perspective\"\nWorldBegin\nShape \"displacedsphere\"\nTranslate 10 0 0\nShape \"sphere\"\n"
        "Translate 10 0 0\nShape \"disk\"\nTranslate 10 0 0\nShape \"trianglemesh\" \"point3 P\" [-1 -1 0 1 -1 0 0 1 0]"
        " \"integer indices\" [0 1 2]\n",
        "row.pbrt", {});
    std::vector<Globe> globes;
    for (const Shape& shape : scene.shapes) globes.emplace_back(shape, nullptr, Relief{});
    const auto bodies = std::make_shared<const Bodies>(globes);
    for (int k = 0; k < 4; ++k) {
        const dvec3 centre(10.0 * k, 0.0, 0.0);
        Camera camera;
        camera.camera_from_world = *lookAtMatrix(centre + dvec3(0.0, 0.0, 4.0), centre, {0.0, 1.0, 0.0});
        CameraControl control(camera, scene.film, bodies, 0);
        for (int i = 0; i < 300; ++i) control.fly({0.0, 0.0, 5.0}, 0.1);
        const double z = Pose::of(control.camera()).eye.z, surface = k < 2 ? 1.0 : 0.0;
        EXPECT_GT(z, surface) << k;
        EXPECT_LT(z, surface + 0.01) << k << ": it comes near";
        for (int i = 0; i < 60; ++i) control.zoom({640.0, 360.0}, {}, 1.0);
        EXPECT_GT(Pose::of(control.camera()).eye.z, surface) << k;
    }
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
    view.grab(cursor);
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
    view.control.axisView(Side::Front);
    EXPECT_LT(glm::length(view.project({0.0, 0.0, 1.0}) - dvec2(320.0, 180.0)), 1e-9);
    EXPECT_LT(view.project({0.0, 0.5, 0.8}).y, 180.0);
    EXPECT_GT(view.project({0.5, 0.0, 0.8}).x, 320.0);
    double rim = 180.0 - view.project({0.0, 1.0, 0.0}).y;
    EXPECT_GT(rim, 0.7 * 180.0);
    EXPECT_LT(rim, 180.0);
    view.control.axisView(Side::Right);
    EXPECT_LT(glm::length(view.project({1.0, 0.0, 0.0}) - dvec2(320.0, 180.0)), 1e-9);
    view.control.axisView(Side::North);
    EXPECT_LT(glm::length(view.project({0.0, 1.0, 0.0}) - dvec2(320.0, 180.0)), 1e-9);
}

}  // namespace
}  // namespace dsphere::viewer
