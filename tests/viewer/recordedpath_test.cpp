#include "viewer/recordedpath.h"

#include "base/error.h"
#include "scene/parser.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

Scene sceneOf(const std::string& camera, const std::string& shapes) {
    return parseScene(camera + " WorldBegin " + shapes, "path.pbrt", ".");
}

Scene planet(const std::string& look, const std::string& fov = "40") {
    return sceneOf("Scale -1 1 1 LookAt " + look + " Camera \"perspective\" \"float fov\" " + fov,
                   "Rotate 20 1 0 0 Shape \"displacedsphere\" \"float maxdispl\" 4");
}

/// The views of these scenes one after the other, in a path of the first one.
RecordedPath recorded(const std::vector<Scene>& scenes) {
    RecordedPath path;
    for (const Scene& scene : scenes) path = path.with(path.lineOf(scenes.front(), scene.camera, 4.0));
    return path;
}

void expectKeys(const std::vector<Scene>& scenes) {
    const RecordedPath path = recorded(scenes);
    ASSERT_EQ(path.keys(), int(scenes.size()));
    for (std::size_t k = 0; k < scenes.size(); ++k)
        EXPECT_TRUE(sameView(path.at(scenes[0], double(k) * RecordedPath::kStep), scenes[k].camera)) << path.text();
}

TEST(RecordedPath, GoesThroughItsKeysAroundAPlanet) {
    const std::vector<Scene> scenes = {planet("0 0 4  0 0 0  0 1 0"), planet("3 .5 2  0 .1 0  0 1 .2", "20"),
                                       planet("0 0 -4  0 0 0  1 1 0"), planet("0 1.2 .1  5 1.5 2  .1 1 0"),
                                       planet("0 3 0  0 5 0  1 0 0")};
    expectKeys(scenes);
    const RecordedPath path = recorded(scenes);
    EXPECT_TRUE(path.text().starts_with("frame,lat,lon,alt,heading,pitch,roll,fov\n0,")) << path.text();
    EXPECT_EQ(path.lastFrame(), 240.0);
    for (double frame = 0.0; frame <= 120.0; frame += 1.0) {
        const Camera camera = path.at(scenes[0], frame);
        EXPECT_GT(glm::length(dvec3(glm::inverse(camera.camera_from_world)[3])), 2.0) << "around it, not through it";
    }
    EXPECT_EQ(Motion::parse(path.text(), "render's").at(scenes[1], 77.0).camera, path.at(scenes[1], 77.0));
}

TEST(RecordedPath, HasPointsWhereThereIsNoPlanetAlone) {
    for (const char* shapes :
         {"Shape \"sphere\"", "Shape \"displacedsphere\" Translate 3 0 0 Shape \"displacedsphere\""}) {
        const auto scene = [&](const std::string& look) {
            return sceneOf("LookAt " + look + " Camera \"perspective\" \"float fov\" 40", shapes);
        };
        const std::vector<Scene> scenes = {scene("0 0 4  0 0 0  0 1 0"), scene("3 2 2  0 .1 0  0 1 .2")};
        expectKeys(scenes);
        EXPECT_TRUE(recorded(scenes).text().starts_with("frame,eye_x,")) << shapes;
    }
}

TEST(RecordedPath, SaysWhatNoFileCanSay) {
    const auto refuses = [](const Scene& scene, const RecordedPath& path, const std::string& part) {
        test::expectError(ExitCode::Usage, part, [&] { path.lineOf(scene, scene.camera, 1.0); });
    };
    refuses(sceneOf("Camera \"orthographic\"", "Shape \"sphere\""), {}, "this scene's is orthographic");
    refuses(sceneOf("Scale 1 2 1 LookAt 0 0 4  0 0 0  0 1 0 Camera \"perspective\"", "Shape \"sphere\""), {},
            "stretched");
    const Scene low = planet("0 0 .99  0 5 0  0 1 0");
    refuses(low, recorded({planet("0 0 4  0 0 0  0 1 0")}), "its eye is below the sphere without relief");
    expectKeys({low});
}

TEST(RecordedPath, KeysComeAndGoAtTheEnd) {
    const Scene first = planet("0 0 4  0 0 0  0 1 0"), second = planet("0 1 4  0 0 0  0 1 0");
    const RecordedPath one = recorded({first}), two = recorded({first, second});
    const std::string line = two.text().substr(one.text().size());
    EXPECT_EQ(one.with(line).text(), two.text());
    EXPECT_EQ(two.without(line)->text(), one.text());
    EXPECT_FALSE(one.without(line));
    EXPECT_EQ(one.without(one.text().substr(one.text().find('\n') + 1))->keys(), 0);
    test::expectError(ExitCode::Failure, "has changed: its last key is now at frame 60", [&] { (void)two.with(line); });
}

TEST(RecordedPath, NoOtherFileIsTouched) {
    const test::TempFolder folder;
    const std::string recorded_text = recorded({planet("0 0 4  0 0 0  0 1 0")}).text();
    EXPECT_EQ(findPathFile(folder.path(), "moon").path, folder.path() / "moon-path.csv");
    folder.write("moon-path.csv", "frame,lat,lon,alt\n0,1,2,3\n");
    PathFile file = findPathFile(folder.path(), "moon");
    EXPECT_EQ(file.path, folder.path() / "moon-path-2.csv");
    EXPECT_EQ(file.passed_over, folder.path() / "moon-path.csv");
    EXPECT_EQ(file.keys.keys(), 0);
    folder.write("moon-path-2.csv", recorded_text.substr(0, recorded_text.size() - 1));
    file = findPathFile(folder.path(), "moon");
    EXPECT_EQ(file.path, folder.path() / "moon-path-2.csv");
    EXPECT_EQ(file.keys.text(), recorded_text) << "a line that was cut short is one";
    for (const char* other : {"", "no path", "frame,lat,lon,alt,heading,pitch,roll,fov\n",
                              "frame,lat,lon,alt,heading,pitch,roll,fov\n0,1,2,3,4\n"}) {
        folder.write("moon-path-2.csv", other);
        EXPECT_EQ(findPathFile(folder.path(), "moon").path, folder.path() / "moon-path-3.csv") << other;
    }
    std::filesystem::create_directory(folder.path() / "moon-path-3.csv");
    std::filesystem::create_symlink("nothing", folder.path() / "moon-path-4.csv");
    file = findPathFile(folder.path(), "moon");
    EXPECT_EQ(file.path, folder.path() / "moon-path-5.csv");
    file.keys = *RecordedPath::parse(recorded_text, "text");
    writePathFile(file);
    EXPECT_EQ(test::readBytes(file.path), recorded_text);
    file.keys = {};
    writePathFile(file);
    EXPECT_FALSE(std::filesystem::exists(file.path)) << "a file without keys is none";
    writePathFile(file);
}

}  // namespace
}  // namespace dsphere::viewer
