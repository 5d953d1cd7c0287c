// Path files: what their columns do to a scene, and what their errors say.

#include "scene/motion.h"
#include "scene/transforms.h"
#include "tests/scene/support.h"
#include "tests/support/expecterror.h"

namespace dsphere {
namespace {

using test::expectError;
using test::holds;
using test::messageOf;

Scene planet(const std::string& camera = "LookAt 0 0 5  0 0 0  0 1 0") {
    return parseParts("Scale -1 1 1 " + camera + " Camera \"perspective\" \"float fov\" 40",
                      "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0] "
                      "Shape \"displacedsphere\" \"float maxdispl\" 4 ");
}

Scene moved(const std::string& text, double frame, const Scene& scene = planet()) {
    return Motion::parse(text, "fly.csv").at(scene, frame);
}

dvec3 eyeOf(const Scene& scene) {
    return dvec3(glm::inverse(scene.camera.camera_from_world)[3]);
}

dvec3 seen(const Scene& scene, const dvec3& world) {
    return transformPoint(scene.camera.camera_from_world, world);
}

void expectPlace(const dvec3& a, const dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z;
}

TEST(Motion, WhatHasNoColumnStays) {
    const Scene scene = planet(), same = moved("exposure\n1\n", 3, scene);
    EXPECT_EQ(same.camera, scene.camera);
    EXPECT_EQ(same.lights, scene.lights);
    EXPECT_EQ(Motion::parse("exposure\n1.5\n", "x").exposureAt(7), 1.5);
    EXPECT_FALSE(Motion::parse("fov\n40\n", "x").exposureAt(7));
}

TEST(Motion, AnEyeLooksWhereTheSceneLooked) {
    const Scene scene = moved("frame, eye_x, eye_y, eye_z\r\n10, 4, 0, 3\r\n", 0);
    expectPlace(eyeOf(scene), {4, 0, 3});
    expectPlace(seen(scene, dvec3(0.0)), {0, 0, 5});
    EXPECT_GT(seen(scene, {3, 0, -4}).x, 0.0) << "mirrored as the scene's camera is";
}

TEST(Motion, EyeLookUpAndFovAreALookAt) {
    const Scene scene = moved("eye_x,eye_y,eye_z,look_x,look_y,look_z,up_x,up_y,up_z,fov\n1,2,3,0,1,0,0,0,1,20\n", 0);
    const Scene same = planet("LookAt 1 2 3  0 1 0  0 0 1");
    for (int i = 0; i < 4; ++i)
        expectPlace(dvec3(scene.camera.camera_from_world[i]), dvec3(same.camera.camera_from_world[i]));
    EXPECT_EQ(scene.camera.fov_degrees, 20.0);
}

TEST(Motion, ARollLeansToTheRight) {
    const Scene level = moved("lat,lon,alt,heading,pitch\n10,20,1,30,-60\n", 0);
    const Scene leaning = moved("lat,lon,alt,heading,pitch,roll\n10,20,1,30,-60,90\n", 0);
    const dvec3 there(0.3, -0.2, 0.9), was = seen(level, there), is = seen(leaning, there);
    expectPlace(eyeOf(leaning), eyeOf(level));
    expectPlace(is, {-was.y, was.x, was.z});
    expectPlace(seen(moved("lat,lon,alt,roll\n0,0,1,350\n0,0,1,10\n", 0.5), there),
                seen(moved("lat,lon,alt\n0,0,1\n", 0), there));
}

TEST(Motion, PlacesLookStraightDownUnlessTold) {
    const Scene down = moved("lat,lon,alt\n0,90,1\n", 0);
    expectPlace(eyeOf(down), {2, 0, 0});
    expectPlace(seen(down, {1, 0.1, 0}), {0, 0.1, 1});
    EXPECT_GT(seen(down, {1, 0, -0.1}).x, 0.0) << "east, beyond 90 degrees, is to the right";
    const Scene level = moved("lat,lon,alt,heading,pitch\n0,0,1,90,0\n", 0);
    expectPlace(eyeOf(level), {0, 0, 2});
    expectPlace(seen(level, {1, 0, 2}), {0, 0, 1});
    expectPlace(seen(level, {0, 0, 3}), {0, 1, 0});
    EXPECT_GT(seen(level, {0, -1, 2}).x, 0.0) << "south is to the right of east";
}

TEST(Motion, EmptyCellsAreNoKeys) {
    const std::string text = "frame,fov,exposure\n0,10,\n\n5,,2\n10,30,\n";
    EXPECT_EQ(moved(text, 5).camera.fov_degrees, 20.0);
    EXPECT_EQ(Motion::parse(text, "x").exposureAt(0), 2.0);
}

TEST(Motion, FovStaysWithinItsKeys) {
    const std::string text = "frame,fov\n0,170\n1,170\n2,1\n3,1\n";
    for (double frame = 0.0; frame <= 3.0; frame += 0.1) {
        EXPECT_LE(moved(text, frame).camera.fov_degrees, 170.0);
        EXPECT_GE(moved(text, frame).camera.fov_degrees, 1.0);
    }
}

TEST(Motion, SunAndExaggeration) {
    const Scene scene = moved("sun_lon,sun_lat,exaggeration\n90,30,2.5\n", 0);
    expectPlace(std::get<DistantLight>(scene.lights[0]).direction, {std::sqrt(0.75), 0.5, 0});
    EXPECT_EQ(std::get<DisplacedSphere>(scene.shapes[0].geometry).max_displacement, 10.0);
}

TEST(Motion, ATableTurnsEastwardBeforeCameraAndSun) {
    Scene scene = planet();
    const dvec3 sun = std::get<DistantLight>(scene.lights[0]).direction;
    turnTable(scene, 90.0);
    expectPlace(seen(scene, {0, 0, 1}), {1, 0, 5});  // was in front, went east, which is to the right
    expectPlace(seen(scene, {-1, 0, 0}), {0, 0, 4});
    EXPECT_NEAR(glm::length(std::get<DistantLight>(scene.lights[0]).direction - dvec3(-sun.z, 0, 0)), 0.0, 1e-12);
    turnTable(scene, 270.0);
    for (int i = 0; i < 4; ++i)
        expectPlace(dvec3(scene.camera.camera_from_world[i]), dvec3(planet().camera.camera_from_world[i]));
}

struct BadPath {
    const char *text, *message;
};

TEST(Motion, ErrorsNameFileRowAndColumn) {
    const BadPath cases[] = {
        {"", "fly.csv: is empty"},
        {"\n \n", "fly.csv: is empty"},
        {"fov\n", "fly.csv: has no keys"},
        {"frame,zoom\n1,2\n", "fly.csv:1: column \"zoom\": is unknown; there are frame, eye_x,"},
        {"fov,fov\n1,2\n", "fly.csv:1: column fov: stands there twice"},
        {"frame,fov\n1,wide\n", "fly.csv:2: column fov: expected a number, not \"wide\""},
        {"frame,fov\n1,30mm\n", "fly.csv:2: column fov: expected a number"},
        {"frame,fov\n1,nan\n", "fly.csv:2: column fov: expected a number"},
        {"frame,fov\n1,30\n2,180\n", "fly.csv:3: column fov: expected at most 179.99, not 180"},
        {"frame,fov\n1,0\n", "fly.csv:2: column fov: expected at least 0.0001, not 0"},
        {"frame,fov\n\n1,30,7\n", "fly.csv:3: has 3 values for 2 columns"},
        {"frame,fov\n5,30\n5,40\n", "fly.csv:3: column frame: 5 comes after 5; frames must grow"},
        {"frame,fov\n1e10,30\n", "fly.csv:2: column frame: expected -1000000000 to 1000000000, not 10000000000"},
        {"frame,fov\n5,30\n5.0000001,40\n", "fly.csv:3: column frame: 5.0000001 comes after 5; frames must grow, by"},
        {"eye_x,eye_y,eye_z\n0,1e16,0\n", "fly.csv:2: column eye_y: expected at most 1000000000000000, not 1e+16"},
        {"frame,fov\n,30\n", "fly.csv:2: column frame: expected a number"},
        {"frame,fov,exposure\n1,30,\n", "fly.csv: column exposure: has no value in any row"},
        {"eye_x,eye_y\n1,2\n", "fly.csv:1: column eye_x: needs eye_z beside it"},
        {"lat,lon\n1,2\n", "fly.csv:1: column lat: needs alt beside it"},
        {"sun_lat\n1\n", "fly.csv:1: column sun_lat: needs sun_lon beside it"},
        {"heading\n1\n", "fly.csv:1: column heading: needs lat, lon and alt"},
        {"roll\n1\n", "fly.csv:1: column roll: needs lat, lon and alt"},
        {"lat,lon,alt,look_x,look_y,look_z\n1,2,3,4,5,6\n", "fly.csv:1: column look_x: and lat exclude each other"},
        {"lat,lon,alt\n1,2,0\n", "fly.csv:2: column alt: expected more than 0, not 0"},
        {"lat,lon,alt\n91,2,1\n", "fly.csv:2: column lat: expected at most 90, not 91"},
    };
    for (const BadPath& one : cases)
        EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { Motion::parse(one.text, "fly.csv"); }), one.message));
}

TEST(Motion, ErrorsOfASceneThatDoesNotFitNameTheFrame) {
    const auto messageFor = [](const std::string& text, const Scene& scene) {
        return messageOf(ExitCode::InvalidInput, [&] { moved(text, 4, scene); });
    };
    const Scene plain = parseParts("Camera \"orthographic\"", "Shape \"sphere\"");
    EXPECT_TRUE(holds(messageFor("fov\n30\n", plain), "fly.csv: frame 4: fov needs a perspective camera"));
    EXPECT_TRUE(holds(messageFor("lat,lon,alt\n1,2,3\n", plain), "need a displacedsphere"));
    EXPECT_TRUE(holds(messageFor("sun_lon,sun_lat\n1,2\n", plain), "need a distant light"));
    EXPECT_TRUE(holds(messageFor("eye_x,eye_y,eye_z,look_x,look_y,look_z\n1,1,1,1,1,1\n", planet()),
                      "frame 4: the eye (1, 1, 1) is the point looked at"));
    expectError(ExitCode::InvalidInput, "--path: cannot open nowhere.csv: No such file",
                [] { Motion::read("nowhere.csv"); });
}

}  // namespace
}  // namespace dsphere
