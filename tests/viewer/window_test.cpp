// The window from opening to closing, by real input in an X server of the test's own, under the validation layers.

#include "tests/viewer/windowfixture.h"

namespace dsphere::test {
namespace {

TEST_F(WindowTest, AWalk) {
    Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "640,360", "--spp", "4"});
    const double home = viewing.waitForStill().at("altitude");
    expectScreenshot(viewing, "fractal-1.png", "fractal.pgm", "--resolution 640,360");

    desktop_->drag(320, 180, 420, 150);
    json turned = viewing.waitForStill();
    EXPECT_NEAR(turned.at("altitude").get<double>(), home, 0.1) << "it turned about the centre";
    hand("mousemove 320 160 click --repeat 60 --delay 10 4");
    viewing.waitFor("the ground", [](const json& frame) { return frame.at("altitude") < 0.002; });
    EXPECT_GE(viewing.waitForStill().at("altitude").get<double>(), 0.0009);
    desktop_->drag(320, 180, 320, 60, 2);
    EXPECT_GE(viewing.waitForStill().at("altitude").get<double>(), 0.0009);
    hand("mousemove 320 160 click --repeat 40 --delay 10 5");
    viewing.waitFor("the height", [&](const json& frame) { return frame.at("altitude") > 0.5; });
    hand("key Return");
    viewing.waitFor("the first view", [&](const json& frame) { return frame.at("altitude") == home; });

    hand("key m");
    viewing.waitFor("the naive marcher", is("marcher", 1));
    hand("key m key m key m");
    viewing.waitFor("the exact marcher", is("marcher", 0));
    hand("key x");
    viewing.waitFor("the split", is("split", true));
    desktop_->drag(320, 250, 200, 250);
    viewing.waitFor("the divider", [](const json& frame) {
        return std::abs(frame.at("divider").get<double>() - 200.0 / 640.0) < 0.01;
    });
    hand("key x key v");
    viewing.waitFor("the height contours", is("value", 1));
    hand("key v key v");
    viewing.waitFor("the graticule", is("value", 3));
    hand("key v key v key v key v key v key v key v");
    viewing.waitFor("the colour", is("value", 0));
    hand("key h");
    viewing.waitFor("the keys", is("keys", true));
    hand("key Escape");
    viewing.waitFor("the window without the keys", is("keys", false));

    desktop_->drag(320, 180, 250, 220);
    hand("keydown l");
    desktop_->drag(320, 180, 380, 150);
    hand("keyup l");
    viewing.waitForStill();
    hand("key ctrl+s");
    viewing.waitFor("a saved scene", says("fractal-2.pbrt"));
    EXPECT_NE(readBytes(path("fractal-2.pbrt")).find("\"fractal-2.png\""), std::string::npos)
        << "it renders to a file that is not there yet";
    expectScreenshot(viewing, "fractal-3.png", "fractal-2.pbrt");

    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "") << "the validation layers are silent";
}

TEST_F(WindowTest, ThePanelChangesAndTakesBack) {
    Viewing viewing(*desktop_, folder_.path(),
                    {"fractal.pgm", "--resolution", "900,640", "--spp", "1", "--exaggeration", "3"});
    viewing.waitForStill();
    hand("mousemove 300 360 key Tab");
    viewing.waitFor("the panel", is("panel", true));
    EXPECT_EQ(viewing.last().at("exaggeration"), 3.0) << "as the command line says";
    click(viewing, "Advanced");
    click(viewing, "Detail");
    click(viewing, "Detail/One pixel");
    viewing.waitFor("a detail of one pixel", is("detail", 1));
    click(viewing, "Surface");
    click(viewing, "Surface/B-spline");
    viewing.waitFor("the spline", is("filter", 1));
    click(viewing, "Surface");
    hand("sleep 0.3 key Escape sleep 0.3 key Escape");
    viewing.waitFor("no panel: Escape closed the list, then the panel", is("panel", false));
    hand("key ctrl+z");
    viewing.waitFor("the surface as it was", is("filter", 0));
    hand("key ctrl+z");
    viewing.waitFor("the detail as it was", is("detail", 0));
    hand("key ctrl+shift+z");
    viewing.waitFor("the detail again", is("detail", 1));

    // All at once, as it comes where the program is busy.
    hand("key Tab");
    click(viewing, "Exaggeration value", "click 1 key ctrl+a type 1.25");
    hand("key Return mousemove 200 300 mousedown 1 mousemove 210 300 mousemove 220 300 mousemove 230 300 mouseup 1");
    viewing.waitFor("the value that was typed", is("exaggeration", 1.25));
    click(viewing, "Exaggeration", "click 1");
    viewing.waitFor("a slider's value", [](const json& frame) { return frame.at("exaggeration") > 4.0; });
    click(viewing, "Exaggeration", "sleep 0.3 click --repeat 2 --delay 40 1");  // not the last click's second
    viewing.waitFor("double click: as it was opened", is("exaggeration", 3.0));
    const double home = viewing.waitForStill().at("altitude");
    click(viewing, "Exaggeration value", "click 1 key ctrl+a type 900");
    hand("key Return");
    const json out = viewing.waitFor("ground that took the eye along", says("The ground rose past the eye"));
    EXPECT_GT(out.at("altitude").get<double>(), home);
    click(viewing, "Exaggeration", "click --repeat 2 --delay 40 1");
    viewing.waitFor("ground that brought it back", [&](const json& frame) {
        return frame.at("exaggeration") == 3.0 && std::abs(frame.at("altitude").get<double>() - home) < 1e-9;
    });
    click(viewing, "Exaggeration value", "click 1 key ctrl+a type -- -1000");
    hand("key Return");
    viewing.waitFor("what is wrong, in the panel's words", says("An exaggeration of -1000 is too much"));
    json last =
        viewing.waitFor("the last that fits", [](const json& frame) { return frame.at("exaggeration") > -1000; });
    EXPECT_FALSE(last.at("error")) << "it goes by itself: the picture is good";
    for (int i = 0; i < 8 && viewing.last().at("exaggeration") != 1.25; ++i) hand("key ctrl+z sleep 0.4");
    EXPECT_EQ(viewing.last().at("exaggeration"), 1.25) << "undo goes past what was refused";

    click(viewing, "Exaggeration value", "click 1 key ctrl+a type 2");
    hand("key Return");
    viewing.waitFor("an edit", is("exaggeration", 2.0));
    hand("mousemove 200 300 key Escape sleep 0.3 key Escape");
    viewing.waitFor("a question, since there are edits", is("asks", true));
    hand("key Tab sleep 0.2 key ctrl+q sleep 0.2");
    EXPECT_TRUE(viewing.last().at("asks")) << "asking twice is no answer";
    EXPECT_FALSE(viewing.last().at("panel")) << "nor is another key";
    click(viewing, "Leaving/Save");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
    EXPECT_TRUE(std::filesystem::exists(path("fractal-1.pbrt")));
    EXPECT_EQ(viewing.output(), "wrote " + path("fractal-1.pbrt").string() + "\n");
}

/// A planet, a smaller one beside it, and a plain sphere.
TEST_F(WindowTest, EveryObjectIsOneToMoveAbout) {
    folder_.write(
        "three.pbrt",
        "Scale -1 1 1 LookAt 0 0 8  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40\n"
        "Film \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 360\n"
        "Sampler \"independent\" \"integer pixelsamples\" 1\nIntegrator \"directlighting\"\nWorldBegin\n"
        "LightSource \"distant\" \"point3 from\" [0 1 4]\n"
        "Shape \"displacedsphere\" \"string displacementmap\" \"fractal.pgm\" \"float maxdispl\" 5\n"
        "Translate 3 0 0\nShape \"displacedsphere\" \"string displacementmap\" \"other.pgm\" \"float maxdispl\" 5\n"
        "Translate -6 0 0\nShape \"sphere\"\n");
    Viewing viewing(*desktop_, folder_.path(), {"three.pbrt", "--spp", "1"});
    viewing.waitForStill();
    const auto hovers = [](const std::string& words) {
        return [words](const json& frame) { return frame.at("hover").get<std::string>().find(words) == 0; };
    };
    hand("mousemove 501 180");
    json second = viewing.waitFor("the second planet's place", hovers("planet 2"));
    EXPECT_NE(second.at("hover").get<std::string>().find("height"), std::string::npos) << second.at("hover");
    hand("mousemove 138 180");
    viewing.waitFor("the sphere", hovers("sphere 3"));
    hand("mousemove 700 500");
    viewing.waitFor("nothing once the cursor has left", is("hover", ""));
    hand("mousemove 501 180 click 1");
    viewing.waitFor("the second is the target", is("target_shape", 1));
    json before = viewing.waitForStill();
    desktop_->drag(501, 180, 521, 180);
    json after = viewing.waitForStill();
    EXPECT_NEAR(after.at("altitude").get<double>(), before.at("altitude").get<double>(), 1.5);
    EXPECT_GT(std::abs(after.at("eye")[1].get<double>() - before.at("eye")[1].get<double>()), 5.0)
        << "it turned about the second";
    hand("key 1");
    viewing.waitFor("the second ahead",
                    [](const json& frame) { return std::abs(frame.at("eye")[0].get<double>()) < 0.01; });
    hand("keydown shift keydown w");
    viewing.waitFor("its ground", [](const json& frame) { return frame.at("altitude") < 0.003; });
    hand("keyup w keyup shift");
    EXPECT_GT(viewing.waitForStill().at("altitude").get<double>(), 0.0009) << "never through it";
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

/// Near the ground of a smooth surface, with the horizon in the middle.
TEST_F(WindowTest, NearTheGround) {
    folder_.write("near.pbrt",
                  "Scale -1 1 1 LookAt 0 .2 1.1  1 .2 1.06  0 0 1 Camera \"perspective\" \"float fov\" 60\n"
                  "Film \"rgb\" \"integer xresolution\" 640 \"integer yresolution\" 360\n"
                  "Sampler \"independent\" \"integer pixelsamples\" 1\nIntegrator \"directlighting\"\nWorldBegin\n"
                  "LightSource \"distant\" \"point3 from\" [0 1 4]\n"
                  "Shape \"displacedsphere\" \"string displacementmap\" \"fractal.pgm\" \"float maxdispl\" 10 "
                  "\"string filter\" \"bspline\"\n");
    Viewing viewing(*desktop_, folder_.path(), {"near.pbrt", "--spp", "1"});
    json before = viewing.waitForStill();
    desktop_->drag(320, 30, 380, 40);
    json after = viewing.waitForStill();
    EXPECT_EQ(after.at("message"), "");
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(after.at("eye")[k].get<double>(), before.at("eye")[k].get<double>(), 1e-6);
    desktop_->drag(320, 30, 340, 100, 2);
    after = viewing.waitForStill();
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(after.at("eye")[k].get<double>(), before.at("eye")[k].get<double>(), 1e-6);
    hand("key r mousemove 320 350 keydown q");
    viewing.waitFor("the ground of the spline", [](const json& frame) { return frame.at("altitude") < 0.0011; });
    hand("keyup q");
    json low = viewing.waitForStill();
    EXPECT_GE(low.at("altitude").get<double>(), 0.0009);
    EXPECT_NE(low.at("hover").get<std::string>().find("distance"), std::string::npos) << "the picture is of the ground";
    EXPECT_EQ(low.at("hover").get<std::string>().find("distance 0 "), std::string::npos);
    hand("mousemove 320 350 click --repeat 30 --delay 10 5");
    viewing.waitFor("the wheel leads out", [](const json& frame) { return frame.at("altitude") > 0.1; });
    hand("key m key m key m");
    viewing.waitFor("a marcher that cannot show it says so", says("Lipschitz"));
    viewing.waitFor("the exact one instead", is("marcher", 0));
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

TEST_F(WindowTest, SizesAndFiles) {
    Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "640,360", "--spp", "2"});
    viewing.waitForStill();
    for (int i = 0; i < 20; ++i)
        hand("search --name dsphere windowsize " + std::to_string(400 + 23 * i) + " " +
             std::to_string(300 + 17 * (i % 7)) + " sleep 0.05");
    viewing.waitFor("the last size", is("window", json({837, 385})));
    viewing.waitForStill();
    hand("search --name dsphere windowunmap sleep 0.2 windowmap");
    hand("search --name dsphere windowsize --sync 640 387");
    viewing.waitFor("the first size", is("window", json({640, 387})));

    ASSERT_TRUE(desktop_->drop(path("other.pgm")));
    viewing.waitFor("the other map", is("file", "other.pgm"));
    viewing.waitForStill();
    ASSERT_TRUE(desktop_->drop(path("broken.pgm")));
    viewing.waitFor("an error", says("broken.pgm"));
    EXPECT_EQ(viewing.last().at("file"), "other.pgm") << "the old picture stays";
    EXPECT_TRUE(viewing.last().at("error"));
    hand("mousemove 320 180");
    expectScreenshot(viewing, "other-1.png", "other.pgm", "--resolution 640,360");

    folder_.write("other.pgm", "P5\n64 32\n65535\nshort");
    viewing.waitFor("an error of the changed file", says("other.pgm"));
    hand("key Tab");
    click(viewing, "Exaggeration value", "click 1 key ctrl+a type 2.5");
    hand("key Return");
    viewing.waitFor("an edit", is("exaggeration", 2.5));
    writePgm16(path("other.pgm"), fractalMap(128, 64));
    viewing.waitFor("the changed map",
                    [](const json& frame) { return frame.at("message") == "" && !frame.at("busy"); });
    EXPECT_EQ(viewing.waitForStill().at("exaggeration"), 2.5) << "the edit stays on top of the new file";
    expectScreenshot(viewing, "other-2.png", "other.pgm", "--resolution 640,360 --exaggeration 2.5");

    hand("search --name dsphere windowsize 8000 6000");
    json large = viewing.waitFor("a window larger than the device can render", [](const json& frame) {
        return frame.at("window") == json({8000, 6000}) && frame.at("film")[0] > 1000;
    });
    EXPECT_LT(large.at("picture")[0].get<int>(), 8000);
    EXPECT_GT(large.at("picture")[0].get<int>(), 4000);
    hand("search --name dsphere windowsize --sync 640 387");
    viewing.waitFor("the first size", is("window", json({640, 387})));
    viewing.waitForStill();
    ASSERT_TRUE(desktop_->drop(path("fractal.pgm")));
    viewing.waitFor("a question, since there is an edit", is("asks", true));
    hand("key Escape");
    viewing.waitFor("the edit that stays", is("asks", false));
    EXPECT_EQ(viewing.last().at("file"), "other.pgm");
    EXPECT_EQ(viewing.last().at("exaggeration"), 2.5);
    ASSERT_TRUE(desktop_->drop(path("fractal.pgm")));
    click(viewing, "Leaving/Discard");
    viewing.waitFor("the file that was dropped", is("file", "fractal.pgm"));
    hand("key ctrl+q");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

TEST_F(WindowTest, AScreenshotWaitsForItsSamples) {
    Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "320,240", "--spp", "60000"});
    viewing.waitFor("a first sample", [](const json& frame) { return frame.at("samples") >= 1; });
    hand("mousemove 160 100 key F12");
    viewing.waitFor("it waits", is("waits", true));
    hand("key Escape");
    viewing.waitFor("no screenshot", is("waits", false));
    hand("key F12");
    viewing.waitFor("it waits", is("waits", true));
    hand("key 3");
    viewing.waitFor("no screenshot of another view", says("No screenshot was made"));
    viewing.waitFor("a first sample", [](const json& frame) { return frame.at("samples") >= 1; });
    hand("key 1 sleep 0.2 key r sleep 0.2");
    viewing.waitFor("a first sample of the first view", [](const json& frame) { return frame.at("samples") >= 1; });
    expectScreenshot(viewing, "fractal-1.png", "fractal.pgm", "--resolution 320,240", "key F12 sleep 0.1 key F12");
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

// As where the device that renders cannot present.
TEST_F(WindowTest, PicturesByWayOfTheHost) {
    Viewing viewing(*desktop_, folder_.path(),
                    {"fractal.pgm", "--resolution", "640,360", "--spp", "2", "--present-apart"});
    viewing.waitForStill();
    desktop_->drag(320, 180, 420, 150);
    hand("search --name dsphere windowsize --sync 500 400");
    viewing.waitFor("the size", is("window", json({500, 400})));
    viewing.waitForStill();
    hand("key ctrl+s");
    viewing.waitFor("a saved scene", says("fractal-1.pbrt"));
    expectScreenshot(viewing, "fractal-2.png", "fractal-1.pbrt");
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

TEST_F(WindowTest, FilesAlone) {
    for (const char* name : {"-", "/dev/stdin"}) {
        Process process({DSPHERE_PROGRAM, "view", name}, {}, folder_.path(), {}, path("errors"));
        EXPECT_EQ(process.finish(20.0), 2) << name;
        EXPECT_NE(readBytes(path("errors")).find("standard input"), std::string::npos) << name;
    }
}

// The frame that fails to be shown is still being drawn, from a picture that goes with the window.
TEST_F(WindowTest, AFrameThatIsNotShownIsAnError) {
    for (const char* call : {"2", "3"}) {
        Process process(
            {DSPHERE_PROGRAM, "view", "fractal.pgm"},
            {"DISPLAY=" + desktop_->display(), "XDG_CACHE_HOME=" + path("cache").string(), DSPHERE_SHADER_CACHE,
             "VK_LAYER_PATH=" DSPHERE_INJECT_LAYER, "VK_INSTANCE_LAYERS=VK_LAYER_DSPHERE_inject",
             "DSPHERE_INJECT=vkQueuePresentKHR:" + std::string(call) + ":-1000000000"},
            folder_.path(), {}, path("errors"));
        EXPECT_EQ(process.finish(60.0), 1) << call;  // shaders that are being compiled are waited for
        EXPECT_NE(readBytes(path("errors")).find("vkQueuePresentKHR failed: VK_ERROR_SURFACE_LOST_KHR"),
                  std::string::npos);
    }
}

TEST_F(WindowTest, NoDisplay) {
    Process process({DSPHERE_PROGRAM, "view", "fractal.pgm"}, {"DISPLAY=", "WAYLAND_DISPLAY="}, folder_.path(), {},
                    path("errors"));
    EXPECT_EQ(process.finish(20.0), 4);
    EXPECT_NE(readBytes(path("errors")).find("dsphere render"), std::string::npos);
}

}  // namespace
}  // namespace dsphere::test
