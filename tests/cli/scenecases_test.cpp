// Scenes that people brought: tests/data/cases/scenes, each with what it must do.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/support/exportedscenes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include <sys/stat.h>

namespace dsphere::test {
namespace {

class SceneCases : public CliTest {
  protected:
    SceneCases() {
        std::filesystem::copy(DSPHERE_SOURCE_DIR "/tests/data/cases/scenes", folder_.path(),
                              std::filesystem::copy_options::recursive);
    }

    Image picture(const std::string& name) const { return readPicture(path(name)); }

    /// Each line of standard error that begins with "dsphere: <kind>: ".
    static std::vector<std::string> linesOf(const Outcome& outcome, const std::string& kind) {
        std::vector<std::string> found;
        std::istringstream lines(outcome.err);
        const std::string start = "dsphere: " + kind + ": ";
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(start)) found.push_back(line.substr(start.size()));
        return found;
    }

    static double brightest(const Image& image) {
        double most = 0.0;
        for (const char* channel : {"R", "G", "B"})
            for (float value : image.at(channel).floats()) most = std::max(most, double(value));
        return most;
    }
};

TEST_F(SceneCases, AnEyeExactlyOnTheSurfaceSeesFiniteColours) {
    const Outcome outcome = run({"render", "04-nan-camera-on-surface.pbrt", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["non_finite_pixels"], 0);
    const Image image = picture("04-out.exr");
    for (const char* channel : {"R", "G", "B"})
        EXPECT_TRUE(std::ranges::all_of(image.at(channel).floats(), [](float value) { return std::isfinite(value); }));
}

TEST_F(SceneCases, AltitudeCountsFromTheGround) {
    const Outcome outcome =
        run({"render", "05-latlon-underground.pbrt", "--lookat-latlon", "13.447,-129.46,0.01", "-o", "05.exr"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(linesOf(outcome, "warning").size(), 0u) << outcome.err;
    EXPECT_GT(brightest(picture("05.exr")), 0.01);
    // Level with the horizon, eastward.
    const Outcome level = run({"render", "05-latlon-underground.pbrt", "--lookat-latlon", "13.447,-129.46,0.01",
                               "--pitch", "0", "--heading", "90", "-o", "level.exr", "--aov", "t"});
    ASSERT_EQ(level.code, 0) << level.err;
    EXPECT_EQ(run({"render", "05-latlon-underground.pbrt", "--pitch", "0"}).code, 2);
    EXPECT_EQ(run({"render", "05-latlon-underground.pbrt", "--lookat-latlon", "0,0,1", "--pitch", "91"}).code, 2);
}

TEST_F(SceneCases, AnEyeInTheGroundIsWarnedOf) {
    std::string scene = readBytes(path("05-latlon-underground.pbrt"));
    const std::string eye = "LookAt 0 1 3   0 0 0";
    folder_.write("buried.pbrt", scene.replace(scene.find(eye), eye.size(), "LookAt 0 .1 .9  0 0 3"));
    for (const char* command : {"render", "verify"}) {
        const std::vector<std::string> warnings = linesOf(run({command, "buried.pbrt"}), "warning");
        ASSERT_EQ(warnings.size(), 1u) << command;
        EXPECT_TRUE(warnings[0].starts_with("buried.pbrt:")) << warnings[0];
        EXPECT_TRUE(holds(warnings[0], "the eye lies inside this shape"));
    }
}

TEST_F(SceneCases, ExportersHeadersRenderAndAreNotedOnce) {
    const Outcome outcome = run({"render", "06-exporter-header.pbrt"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<std::string> notes = linesOf(outcome, "note");
    for (const char* subject :
         {"\"scale\"", "\"diagonal\"", "\"maxsampleluminance\"", "\"samplepixelcenter\"", "\"lightsamplestrategy\"",
          "\"rrthreshold\"", "Accelerator", "ColorSpace", "\"shutteropen\"", "\"lensradius\"", "\"focaldistance\"",
          "\"samples\"", "\"mapping\"", "\"dimension\"", "\"udelta\"", "\"alpha\"", "\"shadowalpha\"", "maxdepth"})
        EXPECT_EQ(
            std::ranges::count_if(notes, [&](const std::string& note) { return note.find(subject) != note.npos; }), 1)
            << subject << "\n"
            << outcome.err;
    EXPECT_TRUE(exists("06-out.png"));
    EXPECT_EQ(linesOf(run({"render", "06-exporter-header.pbrt", "--quiet"}), "note").size(), 0u);
}

TEST_F(SceneCases, FiltersDepthsAndBlackBodiesRender) {
    ASSERT_EQ(run({"render", "07-filter-depth.pbrt"}).code, 0);
    EXPECT_TRUE(exists("07-out.png"));
}

TEST_F(SceneCases, AByteOrderMarkIsSkipped) {
    EXPECT_EQ(run({"render", "11-bom.pbrt", "--resolution", "32,18", "--spp", "1", "-o", "11.png"}).code, 0);
}

TEST_F(SceneCases, PathsAreSoughtBesideTheFirstFileToo) {
    EXPECT_EQ(run({"render", "12-include/main.pbrt", "-o", "12.png"}).code, 0);
    std::filesystem::remove(path("12-include/textures/map.png"));
    const Outcome missing = run({"render", "12-include/main.pbrt", "-o", "12.png"});
    expectFailure(missing, 3, "12-include/geo/planet.pbrt:2:1: ");
    EXPECT_TRUE(holds(missing.err, "12-include/geo/textures/map.png"));
    EXPECT_TRUE(holds(missing.err, "sought at 12-include/textures/map.png too"));
}

// The hump rises to 1.15 radii; the light of its red patch has no green.
TEST_F(SceneCases, AnImageLiesByItsOwnLongitudes) {
    ASSERT_EQ(run({"render", "13-dem360-colour180.pbrt", "--aov", "P,Albedo", "-o", "13.exr"}).code, 0);
    const Image image = picture("13.exr");
    const auto value = [&](const char* channel, std::size_t i) { return double(image.at(channel).floats()[i]); };
    std::size_t highest = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        const double radius = std::hypot(value("P.X", i), value("P.Y", i), value("P.Z", i));
        if (radius > most) most = radius, highest = i;
    }
    EXPECT_GT(most, 1.1);
    EXPECT_GT(value("Albedo.R", highest), 2.0 * value("Albedo.G", highest));
    EXPECT_EQ(run({"verify", "13-dem360-colour180.pbrt"}).code, 0);
}

TEST_F(SceneCases, ATransformAfterTheCameraIsWarnedOf) {
    const Outcome outcome = run({"render", "16-lookat-after-camera.pbrt"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<std::string> warnings = linesOf(outcome, "warning");
    ASSERT_EQ(warnings.size(), 2u) << outcome.err;
    EXPECT_TRUE(holds(warnings[0], "16-lookat-after-camera.pbrt:3:1: LookAt stands after Camera"));
    EXPECT_TRUE(holds(warnings[1], "the eye lies inside this shape"));
}

TEST_F(SceneCases, ScenesOfThreeExportersRenderWithoutAnEdit) {
    for (const ExportedScene& exported : kExportedScenes) {
        folder_.write("exported.pbrt", exported.text);
        const Outcome outcome = run({"render", "exported.pbrt", "--resolution", "32,18", "-o", "exported.exr"});
        ASSERT_EQ(outcome.code, 0) << exported.name << "\n" << outcome.err;
        EXPECT_GT(brightest(picture("exported.exr")), 0.01) << exported.name;
        EXPECT_EQ(run({"verify", "exported.pbrt", "--resolution", "32,18"}).code, 0) << exported.name;
    }
}

TEST_F(SceneCases, EveryErrorHasItsLine) {
    folder_.write("wrong.pbrt", "Camera \"x\"\nWorldBegin\nShape \"cone\"\n");
    const Outcome outcome = run({"render", "wrong.pbrt"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(linesOf(outcome, "error").size(), 2u) << outcome.err;
    folder_.write("missing.pbrt",
                  "WorldBegin\n# get: scripts/fetch-maps\nShape \"displacedsphere\" \"string displacementmap\" "
                  "\"a.png\"\nShape \"displacedsphere\" \"string displacementmap\" \"b.png\"\n");
    const std::vector<std::string> errors = linesOf(run({"info", "missing.pbrt"}), "error");
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_TRUE(holds(errors[0], "missing.pbrt:3:1: a.png")) << errors[0];
    EXPECT_TRUE(holds(errors[0], "; to get it: scripts/fetch-maps")) << errors[0];
    EXPECT_TRUE(holds(errors[1], "missing.pbrt:4:1: b.png")) << errors[1];
}

TEST_F(SceneCases, AFifoIsRefusedAtOnce) {
    ASSERT_EQ(mkfifo(path("fifo.pbrt").c_str(), 0600), 0);
    folder_.write("includes.pbrt", "WorldBegin\nInclude \"fifo.pbrt\"\n");
    expectFailure(run({"render", "fifo.pbrt"}), 3, "is a FIFO; supported: regular files, and - for standard input");
    expectFailure(run({"info", "includes.pbrt"}), 3, "includes.pbrt:2:9: ");
    EXPECT_EQ(run(Launch{.arguments = {"info", "/dev/stdin"}, .input = "WorldBegin Shape \"sphere\""}).code, 0);
}

}  // namespace
}  // namespace dsphere::test
