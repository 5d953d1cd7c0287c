#pragma once

// Scenes from text, over maps in a folder of the test's own.

#include "base/error.h"
#include "gpu/device.h"
#include "render/renderer.h"
#include "scene/parser.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace dsphere::test {

/// A scene and everything made of it on the host.
struct World {
    Scene scene;
    SceneMaps maps;
    PackedScene packed;
};

/// By how much the same hit may differ between two pipelines: not at all on lavapipe, which computes as written; other
/// drivers fuse products and sums in each pipeline as it suits it.
inline float pipelineDrift(const gpu::Device& device) {
    return device.info().type == "CPU" ? 0.0f : 1e-5f;
}

class WorldTest : public testing::Test {
  protected:
    static constexpr int kWidth = 72, kHeight = 40;

    WorldTest() {
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        writePgm16(folder_.path() / "map.pgm", fractalMap(64, 32));
        writePgm16(folder_.path() / "other.pgm", fractalMap(32, 16, 2));
    }

    World world(const std::string& shapes, const std::string& options = "") const {
        return worldOf(
            "LookAt 0 .5 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
            "Film \"rgb\" \"integer xresolution\" 72 \"integer yresolution\" 40 " +
            options +
            "\nWorldBegin\nLightSource \"distant\" \"point3 from\" [1 1 2] "
            "\"point3 to\" [0 0 0]\n" +
            shapes);
    }
    World worldOf(const std::string& text) const {
        World world;
        world.scene = parseScene(text, "world.pbrt", folder_.path());
        world.maps = loadSceneMaps(world.scene);
        world.packed = packScene(world.scene, world.maps);
        return world;
    }
    static std::string planet(const std::string& parameters = "\"float maxdispl\" 10",
                              const std::string& map = "map.pgm") {
        return "Shape \"displacedsphere\" \"string displacementmap\" \"" + map + "\" " + parameters + "\n";
    }

    TempFolder folder_;
};

}  // namespace dsphere::test
