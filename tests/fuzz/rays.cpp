// Rays of `query`, NumPy or CSV. `ground` and `alt` are of a small map.

#include "query/rayreader.h"
#include "scene/parser.h"
#include "surface/scenemaps.h"
#include "tests/fuzz/scratch.h"

using namespace dsphere;

// In place of query/frames.cpp, which needs the scene as the device has it.
std::size_t query::bodyOf(const Scene&) {
    return 0;
}

namespace {

struct World {
    fuzz::Scratch scratch;
    Scene scene;
    SceneMaps maps;

    World() {
        scratch.write("map.pgm", "P2\n4 2\n9\n0 1 2 3\n4 5 6 7\n");
        scene = parseScene("WorldBegin\nShape \"displacedsphere\" \"string displacementmap\" \"map.pgm\"\n",
                           "scene.pbrt", scratch.path());
        maps = loadSceneMaps(scene);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const World world;
    static const query::Geography geography(world.scene, world.maps, query::Frame::World);
    const std::filesystem::path file = world.scratch.write("rays", fuzz::textOf(data, size));
    fuzz::expectHandled([&] {
        const auto rays = query::openRays(file.string(), {}, geography);
        std::vector<double> room;
        while (rays->read(room, 256).count > 0) rays->share();
    });
    return 0;
}
