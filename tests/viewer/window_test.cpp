// The window from opening to closing, by real input in an X server of the test's own, under the validation layers.

#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"
#include "tests/viewer/desktop.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace dsphere::test {
namespace {

using nlohmann::json;

auto is(const char* name, const json& value) {
    return [name, value](const json& frame) { return frame.at(name) == value; };
}

auto says(const std::string& part) {
    return [part](const json& frame) { return frame.at("message").get<std::string>().find(part) != std::string::npos; };
}

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!desktopAvailable()) GTEST_SKIP() << "Xvfb or xdotool is missing";
        writePgm16(path("fractal.pgm"), fractalMap(512, 256));
        writePgm16(path("other.pgm"), terraceMap(256, 128));
        folder_.write("broken.pgm", "P5\n64 32\n65535\nshort");
        desktop_ = std::make_unique<Desktop>(folder_.path());
        ASSERT_FALSE(desktop_->display().empty());
    }

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    void hand(const std::string& arguments) { EXPECT_TRUE(desktop_->hand(arguments)) << arguments; }
    /// Takes a screenshot, renders the same with as many samples, and compares byte by byte.
    void expectScreenshot(Viewing& viewing, const std::string& name, const std::string& scene,
                          const std::string& options = "") {
        hand("key F12");
        const std::string told = "Wrote " + name + ", ";
        json frame = viewing.waitFor("a screenshot", says(told));
        const int samples = std::atoi(frame.at("message").get<std::string>().substr(told.size()).c_str());
        ASSERT_GE(samples, 1);
        std::string command = "cd " + folder_.path().string() +
                              " && XDG_CACHE_HOME=cache ASAN_OPTIONS=detect_leaks=0 " + DSPHERE_PROGRAM + " render " +
                              scene + " --quiet -o rendered.png --spp " + std::to_string(samples) + " " + options;
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_TRUE(readBytes(path("rendered.png")) == readBytes(path(name))) << command;
    }

    TempFolder folder_;
    std::unique_ptr<Desktop> desktop_;
};

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
    viewing.waitFor("the steps", is("value", 1));
    hand("key v key v key v key v key v key v");
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
    viewing.waitFor("a saved scene, whose film is not the screenshot", says("fractal-2.pbrt"));
    expectScreenshot(viewing, "fractal-3.png", "fractal-2.pbrt");

    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "") << "the validation layers are silent";
}

/// By the places that they have in a window of this size.
TEST_F(WindowTest, ThePanelChoosesDetailAndFilter) {
    Viewing viewing(*desktop_, folder_.path(), {"fractal.pgm", "--resolution", "1000,720", "--spp", "1"});
    viewing.waitForStill();
    hand("mousemove 300 360 key Tab");
    viewing.waitFor("the panel", is("panel", true));
    hand("mousemove 835 113 sleep 0.3 click 1 sleep 1 mousemove 707 184 sleep 0.3 click 1");
    viewing.waitFor("a detail of one pixel", is("detail", 1));
    viewing.waitForStill();
    hand("mousemove 835 287 sleep 0.3 click 1 sleep 1 mousemove 707 337 sleep 0.3 click 1");
    viewing.waitFor("the spline", is("filter", 1));
    viewing.waitForStill();
    hand("mousemove 835 287 sleep 0.3 click 1 sleep 1 key Escape sleep 0.5 key Tab");
    viewing.waitFor("no panel: Escape closed the list alone", is("panel", false));
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
    hand("search --name dsphere windowsize --sync 640 360");
    viewing.waitFor("the first size", is("window", json({640, 360})));

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
    writePgm16(path("other.pgm"), fractalMap(128, 64));
    viewing.waitFor("the changed map",
                    [](const json& frame) { return frame.at("message") == "" && !frame.at("busy"); });
    viewing.waitForStill();
    expectScreenshot(viewing, "other-2.png", "other.pgm", "--resolution 640,360");
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

TEST_F(WindowTest, NoDisplay) {
    Process process({DSPHERE_PROGRAM, "view", "fractal.pgm"}, {"DISPLAY=", "WAYLAND_DISPLAY="}, folder_.path(), {},
                    path("errors"));
    EXPECT_EQ(process.finish(20.0), 4);
    EXPECT_NE(readBytes(path("errors")).find("dsphere render"), std::string::npos);
}

}  // namespace
}  // namespace dsphere::test
