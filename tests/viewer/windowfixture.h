#pragma once

#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"
#include "tests/viewer/desktop.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace dsphere::test {

using nlohmann::json;

inline auto is(const char* name, const json& value) {
    return [name, value](const json& frame) { return frame.at(name) == value; };
}

inline auto says(const std::string& part) {
    return [part](const json& frame) { return frame.at("message").get<std::string>().find(part) != std::string::npos; };
}

/// Maps in a folder of the test's own, and a desktop.
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
    /// Puts the mouse on a control and presses it.
    void click(Viewing& viewing, const std::string& label, const std::string& how = "click 1") {
        hand("mousemove " + viewing.place(label) + " sleep 0.2 " + how);
    }
    void hand(const std::string& arguments) { EXPECT_TRUE(desktop_->hand(arguments)) << arguments; }
    /// Takes a screenshot, renders the same with as many samples, and compares byte by byte.
    void expectScreenshot(Viewing& viewing, const std::string& name, const std::string& scene,
                          const std::string& options = "", const std::string& keys = "key F12") {
        hand(keys);
        const std::string told = "Wrote " + name + ", ";
        json frame = viewing.waitFor("a screenshot", says(told));
        const int samples = std::atoi(frame.at("message").get<std::string>().substr(told.size()).c_str());
        ASSERT_GE(samples, 1);
        std::string command = "cd " + folder_.path().string() +
                              " && XDG_CACHE_HOME=cache " DSPHERE_SHADER_CACHE " ASAN_OPTIONS=detect_leaks=0 " +
                              DSPHERE_PROGRAM + " render " + scene + " --quiet -o rendered.png --spp " +
                              std::to_string(samples) + " " + options;
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_TRUE(readBytes(path("rendered.png")) == readBytes(path(name))) << command;
    }

    TempFolder folder_;
    std::unique_ptr<Desktop> desktop_;
};

}  // namespace dsphere::test
