// Ways to a place, to a file and to a panel of one's own, by real input.

#include "tests/viewer/windowfixture.h"

#include <algorithm>
#include <cmath>

namespace dsphere::test {
namespace {

double at(const json& frame, const char* name, int i) {
    return frame.at(name)[i].get<double>();
}

TEST_F(WindowTest, GoesToPlaces) {
    folder_.write("tilted.pbrt",
                  "Scale -1 1 1 LookAt 3 1 3  0 0 0  1 1 0 Camera \"perspective\" \"float fov\" 40\n"
                  "Film \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 360\n"
                  "Integrator \"directlighting\"\nWorldBegin\nLightSource \"distant\" \"point3 from\" [1 1 4]\n"
                  "Shape \"displacedsphere\" \"string displacementmap\" \"fractal.pgm\" \"float maxdispl\" 5\n");
    Viewing viewing(*desktop_, folder_.path(), {"tilted.pbrt", "--spp", "1"});
    EXPECT_GT(std::abs(at(viewing.waitForStill(), "north", 0)), 0.1) << "north lies aslant";
    hand("key n");
    const auto north_up = [](const json& frame) {
        return std::abs(at(frame, "north", 0)) < 1e-6 && at(frame, "north", 1) > 0.5;
    };
    viewing.waitFor("north up", north_up);
    hand("key ctrl+z");
    viewing.waitFor("as it was", [&](const json& frame) { return !north_up(frame); });
    click(viewing, "Compass");
    viewing.waitFor("north up by the compass", north_up);

    const json before = viewing.waitForStill();
    hand("key Right key Right");
    viewing.waitFor("a place farther east",
                    [&](const json& frame) { return at(frame, "eye", 1) > at(before, "eye", 1) + 8.0; });
    hand("key Up");
    viewing.waitFor("a place farther north",
                    [&](const json& frame) { return at(frame, "eye", 0) > at(before, "eye", 0) + 3.0; });
    hand("key plus key plus key plus");
    const double near =
        viewing
            .waitFor("a lower place",
                     [&](const json& frame) {
                         return frame.at("altitude").get<double>() < 0.7 * before.at("altitude").get<double>();
                     })
            .at("altitude");
    hand("key minus");
    viewing.waitFor("a higher one", [&](const json& frame) { return frame.at("altitude").get<double>() > 1.1 * near; });
    hand("key f");
    const double whole = viewing.waitForStill().at("altitude");
    EXPECT_GT(whole, 1.5) << "all of it";

    hand("key g");
    viewing.waitFor("a box that is typed into", is("typing", true));
    hand("type 12");
    hand("key Escape");
    viewing.waitFor("no box: Escape closed it with what was typed", is("go_to", false));
    hand("mousemove 320 180 key g");
    viewing.waitFor("a box that is typed into", is("typing", true));
    hand("key ctrl+a type 40");
    hand("key Tab type -- -75");
    hand("key Tab type 0.5");
    click(viewing, "Go");
    viewing.waitFor("40 N, 75 W", [](const json& frame) {
        return !frame.at("flying") && std::abs(at(frame, "eye", 0) - 40.0) < 1e-6 &&
               std::abs(at(frame, "eye", 1) + 75.0) < 1e-6;
    });
    hand("mousemove 400 120 sleep 0.1 click --repeat 2 --delay 40 1");
    viewing.waitFor("the place that was double clicked, from nearer", [](const json& frame) {
        return !frame.at("flying") && frame.at("altitude") < 0.25 && at(frame, "eye", 0) > 42.0 &&
               at(frame, "eye", 1) > -73.0;
    });
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

TEST_F(WindowTest, StartsWithoutAFile) {
    {
        Viewing viewing(*desktop_, folder_.path(), {"--spp", "1"});
        viewing.waitFor("the start window", is("starting", true));
        click(viewing, "Path", "click 1 type brok");
        hand("key Tab key Return");
        viewing.waitFor("what is wrong with the file", says("broken.pgm"));
        hand("key Escape");
        click(viewing, "Ripples");
        viewing.waitFor("the sample", is("file", "ripples.pbrt"));
        viewing.waitForStill();
        hand("key k");
        viewing.waitFor("a sample's path in the working folder", says("is in " + path("ripples-path.csv").string()));
        EXPECT_TRUE(std::filesystem::exists(path("ripples-path.csv")));
        hand("key ctrl+o");
        viewing.waitFor("the path box", is("path_box", true));
        hand("sleep 0.3 type frac");
        hand("sleep 0.2 key Tab key Return");
        viewing.waitFor("the map", is("file", "fractal.pgm"));
        viewing.waitForStill();
        hand("key ctrl+q");
        EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
        EXPECT_EQ(viewing.errors(), "");
    }
    Viewing viewing(*desktop_, folder_.path(), {});
    viewing.waitFor("the start window", is("starting", true));
    click(viewing, "Recent/fractal.pgm");
    viewing.waitFor("the map that was opened lately", is("file", "fractal.pgm"));
    hand("mousemove 100 100 key v key ctrl+s");
    viewing.waitFor("a scene saved while its height contours are shown", says("fractal-1.pbrt"));
    EXPECT_NE(readBytes(path("fractal-1.pbrt")).find("\"integer pixelsamples\" 16 "), std::string::npos)
        << "as many as its picture has";
    hand("key ctrl+q");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
}

TEST_F(WindowTest, ThePanelIsDockedMovedAndFolded) {
    Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "900,640", "--spp", "1"});
    viewing.waitForStill();
    hand("mousemove 200 300 key Tab");
    viewing.waitFor("the panel", is("panel", true));
    const auto has = [](const char* label) {
        return [label](const json& frame) { return frame.at("places").contains(label); };
    };
    viewing.waitFor("its rows", has("Exaggeration"));
    click(viewing, "Fold");
    viewing.waitFor("the folded panel", [&](const json& frame) { return !has("Exaggeration")(frame); });
    click(viewing, "Fold");
    const double left = at(viewing.waitFor("the open panel", has("Exaggeration")).at("places"), "Title", 0);
    click(viewing, "Title",
          "mousedown 1 mousemove_relative -- -100 0 sleep 0.1 mousemove_relative -- -100 0 mouseup 1");
    viewing.waitFor("the panel where it was moved to",
                    [&](const json& frame) { return at(frame.at("places"), "Title", 0) < left - 150.0; });
    click(viewing, "Dock");
    viewing.waitFor("the panel beside the picture", [](const json& frame) {
        return frame.at("docked") && frame.at("film")[0] == 520 && at(frame.at("places"), "Title", 0) == 520.0;
    });
    viewing.waitForStill();
    hand("mousemove " + viewing.place("Exaggeration"));
    const json tipped = viewing.waitFor("its tip", has("Tip"));
    EXPECT_LT(at(tipped.at("places"), "Tip", 2), 520.0) << "beside the panel";
    click(viewing, "Sun longitude value", "click 1 key ctrl+a type '42 W'");
    hand("key Return");
    viewing.waitFor("42 W", [](const json& frame) { return std::abs(at(frame, "sun", 1) + 42.0) < 1e-9; });
    click(viewing, "Sun latitude value", "click 1 key ctrl+a type '10.5s'");
    hand("key Return");
    viewing.waitFor("10.5 S", [](const json& frame) { return std::abs(at(frame, "sun", 0) + 10.5) < 1e-9; });
    click(viewing, "Night side value", "click 1 key ctrl+a type 40");
    hand("key Return");
    viewing.waitFor("a light for the night", is("night_light", 0.4));
    viewing.waitForStill();
    hand("key ctrl+s");
    viewing.waitFor("a saved scene", says("fractal-1.pbrt"));
    expectScreenshot(viewing, "fractal-2.png", "fractal-1.pbrt");
    click(viewing, "Dock");
    viewing.waitFor("the whole width", is("picture", json({900, 640})));
    hand("search --name dsphere windowsize --sync 640 400");
    viewing.waitFor("the panel within a smaller window", [](const json& frame) {
        return frame.at("window") == json({640, 400}) && at(frame.at("places"), "Title", 2) <= 640.0;
    });
    hand("key ctrl+q");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

/// A scene whose shaders take long shows a stand-in first; a screenshot waits for the whole.
TEST_F(WindowTest, AStandInComesFirst) {
    folder_.write("metal.pbrt",
                  "Scale -1 1 1 LookAt 0 1 4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40\n"
                  "Film \"rgb\" \"integer xresolution\" 520 \"integer yresolution\" 400\n"
                  "Sampler \"independent\" \"integer pixelsamples\" 1\nIntegrator \"path\"\nWorldBegin\n"
                  "LightSource \"infinite\" \"rgb L\" [.3 .3 .4]\nLightSource \"distant\" \"point3 from\" [1 1 1]\n"
                  "Material \"mirror\"\n"
                  "Shape \"displacedsphere\" \"string displacementmap\" \"other.pgm\" \"float maxdispl\" 3\n");
    Viewing viewing(*desktop_, folder_.path(), {"metal.pbrt", "--spp", "1"});
    viewing.waitFor("a picture", is("has_picture", true));
    expectScreenshot(viewing, "metal-1.png", "metal.pbrt");
    EXPECT_FALSE(viewing.waitForStill().at("stand_in"));
    EXPECT_TRUE(std::ranges::any_of(viewing.lines(), [](const json& frame) {
        return frame.at("stand_in") && frame.at("has_picture");
    })) << "a picture of the stand-in";
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

}  // namespace
}  // namespace dsphere::test
