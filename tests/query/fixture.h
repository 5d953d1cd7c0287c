#pragma once

// A scene on a device, ready for rays.

#include "gpu/device.h"
#include "query/engine.h"
#include "scene/parser.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace dsphere::query {

class QueryTest : public testing::Test {
  protected:
    QueryTest() {
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        test::writePgm16(folder_.path() / "map.pgm", test::fractalMap(256, 128));
        test::writePgm16(folder_.path() / "coarse.pgm", test::fractalMap(16, 8));
    }

    ~QueryTest() override { EXPECT_TRUE(device_.validationMessages().empty()); }

    struct World {
        Scene scene;
        SceneMaps maps;
        PackedScene packed;
        DeviceScene on_device;
        Engine engine;

        World(gpu::Device& device, Scene read, const Engine::Options& options)
            : scene(std::move(read)),
              maps(loadSceneMaps(scene)),
              packed(packScene(scene, maps)),
              on_device(device, packed),
              engine(device, scene, maps, packed, on_device, options) {}
    };

    World world(const std::string& shapes, const Engine::Options& options = {}) {
        return {
            device_,
            parseScene("WorldBegin\nLightSource \"distant\" \"point3 from\" [2 1 0] \"point3 to\" [0 0 0]\n" + shapes,
                       "test.pbrt", folder_.path()),
            options};
    }
    static std::string planet(const std::string& parameters, const std::string& map = "map.pgm") {
        return "Shape \"displacedsphere\" \"string displacementmap\" \"" + map + "\" " + parameters + "\n";
    }

    test::TempFolder folder_;
    gpu::Device device_{{.selector = test::testDevice(), .validation = true, .caches = false}};
};

}  // namespace dsphere::query
