// K and Shift + K: a path of the camera is recorded and played, by real input.

#include "scene/motion.h"
#include "scene/parser.h"
#include "tests/viewer/windowfixture.h"

#include <glm/gtc/type_ptr.hpp>

namespace dsphere::test {
namespace {

class PathKeysTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        folder_.write("planet.pbrt",
                      "Scale -1 1 1 LookAt 0 0 4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 480 \"integer yresolution\" 300\n"
                      "Sampler \"independent\" \"integer pixelsamples\" 1\nIntegrator \"directlighting\"\nWorldBegin\n"
                      "LightSource \"distant\" \"point3 from\" [1 1 4]\n"
                      "Shape \"displacedsphere\" \"string displacementmap\" \"fractal.pgm\" \"float maxdispl\" 5\n");
    }
    std::string text(const std::string& name) const { return readBytes(path(name)); }
    long lines(const std::string& name) const {
        const std::string all = text(name);
        return std::count(all.begin(), all.end(), '\n');
    }
    void close(Viewing& viewing) {
        hand("key ctrl+q");
        EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
        EXPECT_EQ(viewing.errors(), "");
    }
};

bool plays(const json& frame) {
    return frame.at("playing").get<int>() >= 0;
}

TEST_F(PathKeysTest, AreRecordedTakenBackAndPlayedAsRenderFilmsThem) {
    Viewing viewing(*desktop_, folder_.path(), {"planet.pbrt", "--spp", "1"});
    viewing.waitForStill();
    hand("mousemove 240 150 key shift+k");
    viewing.waitFor("what a path needs", says("two keys make one"));
    hand("key k");
    viewing.waitFor("the first key", says("Key 1, at frame 0, is in " + path("planet-path.csv").string()));
    hand("key k");
    viewing.waitFor("no second one of the same view", says("This view is the last key, 1, of planet-path.csv already"));
    hand("key 3 sleep 0.1 key k");
    viewing.waitFor("the second key", says("dsphere render planet.pbrt --path planet-path.csv --frames 0-60"));
    hand("key 7 sleep 0.1 key k");
    viewing.waitFor("the third key", says("Key 3, at frame 120"));
    EXPECT_EQ(lines("planet-path.csv"), 4);
    hand("key ctrl+z");
    viewing.waitFor("the third key taken back", says("Key 3 is no longer in"));
    EXPECT_EQ(lines("planet-path.csv"), 3);
    EXPECT_NEAR(viewing.last().at("eye")[0].get<double>(), 90.0, 1e-6) << "the view stays";
    hand("key ctrl+y");
    viewing.waitFor("the third key again", says("Key 3, at frame 120"));

    // By hand the film becomes a hundred times as long: it does not end before the keys are pressed.
    std::string keys = text("planet-path.csv");
    keys.replace(keys.find("\n60,"), 4, "\n6000,").replace(keys.find("\n120,"), 5, "\n12000,");
    folder_.write("planet-path.csv", keys);
    hand("key shift+k");
    viewing.waitFor("the film's twentieth frame", [](const json& frame) { return frame.at("playing") > 20; });
    hand("key Escape");
    viewing.waitFor("a stop", [](const json& frame) { return !plays(frame); });
    viewing.waitForStill();

    // Each frame that was shown has the camera that render gives it.
    const Scene scene = parseScene(text("planet.pbrt"), "planet.pbrt", folder_.path());
    const Motion motion = Motion::read(path("planet-path.csv"));
    int last = -1;
    for (const json& frame : viewing.lines()) {
        if (!frame.contains("playing") || !plays(frame)) continue;
        last = frame.at("playing");
        const dmat4 camera = glm::make_mat4(frame.at("camera").get<std::vector<double>>().data());
        ASSERT_EQ(camera, motion.at(scene, last).camera.camera_from_world) << last;
    }
    ASSERT_GT(last, 20);
    EXPECT_EQ(glm::make_mat4(viewing.last().at("camera").get<std::vector<double>>().data()),
              motion.at(scene, last).camera.camera_from_world)
        << "Esc stopped it there, and closed nothing";
    hand("key F12");
    viewing.waitFor("a screenshot", says("Wrote planet-1.png, 1 sample "));
    const std::string frame = std::to_string(last);
    const std::string command =
        "cd " + folder_.path().string() + " && XDG_CACHE_HOME=cache ASAN_OPTIONS=detect_leaks=0 " + DSPHERE_PROGRAM +
        " render planet.pbrt --quiet --spp 1 --path planet-path.csv -o f-%d.png --frames " + frame;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_TRUE(text("f-" + frame + ".png") == text("planet-1.png")) << command;

    hand("key shift+k");
    viewing.waitFor("the path again", plays);
    hand("click 4");
    viewing.waitFor("the wheel stops it", [](const json& frame) { return !plays(frame); });
    hand("key shift+k");
    viewing.waitFor("the path again", plays);
    hand("key shift+k");
    viewing.waitFor("the same keys stop it", [](const json& frame) { return !plays(frame); });

    // A file that nobody may write: so is it for root too.
    std::filesystem::permissions(path("planet-path.csv"), std::filesystem::perms::owner_read);
    hand("key 1 key k");
    viewing.waitFor("an error", [](const json& frame) { return frame.at("error") && says("planet-path.csv")(frame); });
    EXPECT_EQ(text("planet-path.csv"), keys);
    hand("key Escape");
    viewing.waitFor("the window goes on", is("message", ""));
    close(viewing);
}

TEST_F(PathKeysTest, GoOnInAFileThatIsThereAndLeaveOthersAlone) {
    folder_.write("fractal-path.csv", "frame,lat,lon,alt\n0,1,2,3\n");
    const std::string hand_made = text("fractal-path.csv");
    for (int start = 0; start < 2; ++start) {
        Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "320,200", "--spp", "1"});
        viewing.waitForStill();
        hand(start == 0 ? "mousemove 160 100 key k" : "mousemove 160 100 key 3 sleep 0.1 key k");
        if (start == 0)
            viewing.waitFor("a file of its own", says("fractal-path.csv holds something else and stays as it is"));
        else
            viewing.waitFor("the keys that were there", says("It goes on from 1 key that the file had"));
        EXPECT_EQ(lines("fractal-path-2.csv"), 2 + start);
        if (start == 1) {
            const std::string keys = text("fractal-path-2.csv");
            folder_.write("fractal-path-2.csv", keys.substr(0, keys.size() - 1) + "0\n");
            hand("key ctrl+z");
            viewing.waitFor("a last key that is another", [](const json& frame) { return frame.at("error"); });
            hand("key Escape key ctrl+z");
            viewing.waitFor("undo that goes on past it",
                            [](const json& frame) { return std::abs(frame.at("eye")[1].get<double>() - 90.0) > 10.0; });
            folder_.write("fractal-path-2.csv", keys);
            hand("key shift+k");
            viewing.waitFor("the film of both", plays);
        }
        close(viewing);
    }
    EXPECT_EQ(text("fractal-path.csv"), hand_made);
}

}  // namespace
}  // namespace dsphere::test
