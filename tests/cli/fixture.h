#pragma once

#include "tests/cli/program.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <utility>

namespace dsphere::test {

/// Runs the program in a folder of the test's own, which holds a small scene, `planet.pbrt`, and its map. All tests
/// share what Mesa has compiled: half of their time would go into the same shaders.
class CliTest : public testing::Test {
  protected:
    static constexpr int kWidth = 64, kHeight = 48;

    CliTest() {
        writePgm16(folder_.path() / "map.pgm", fractalMap(64, 32));
        folder_.write("planet.pbrt", planet());
    }

    /// Camera at (0, 0, 4) towards the centre, x to the right. A displaced sphere, a sphere beside it, one sun from +x.
    static std::string planet(const std::string& displacement = "\"float maxdispl\" 10") {
        return "Scale -1 1 1\n"
               "LookAt 0 0 4  0 0 0  0 1 0\n"
               "Camera \"perspective\" \"float fov\" 40\n"
               "Film \"rgb\" \"string filename\" \"film.exr\" \"integer xresolution\" 64 \"integer yresolution\" 48\n"
               "Sampler \"independent\" \"integer pixelsamples\" 4 Integrator \"directlighting\"\n"
               "WorldBegin\n"
               "LightSource \"distant\" \"point3 from\" [1 0 .5] \"point3 to\" [0 0 0]\n"
               "Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" " +
               displacement +
               "\n"
               "Translate 1.5 0 0\n"
               "Shape \"sphere\" \"float radius\" .2\n";
    }

    Outcome run(std::vector<std::string> arguments) { return run(Launch{.arguments = std::move(arguments)}); }
    Outcome run(Launch launch) {
        launch.folder = folder_.path();
        launch.environment.push_back("XDG_CACHE_HOME=" + cache_.path().string());
        launch.environment.push_back("MESA_SHADER_CACHE_DIR=" DSPHERE_SHADER_CACHE);
        return test::launch(launch);
    }

    /// What the program must say and not do when it fails: one line on standard error, nothing on standard output.
    static void expectFailure(const Outcome& outcome, int code, const std::string& part) {
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("dsphere: error: ", 0), 0u) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, part));
    }

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

    TempFolder folder_, cache_;
};

}  // namespace dsphere::test
