// The camera paths of `render --path`: every frame of a file that is read makes a scene or an error.

#include "scene/motion.h"
#include "scene/parser.h"
#include "tests/fuzz/scratch.h"

#include <algorithm>

using namespace dsphere;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scene scene = parseScene(
        "Camera \"perspective\"\nWorldBegin\nLightSource \"distant\"\n"
        "Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\"\n",
        "scene.pbrt", ".");
    fuzz::expectHandled([&] {
        const Motion motion = Motion::parse(fuzz::textOf(data, size), "path.csv");
        const double step = std::max(0.5, motion.lastFrame() / 16.0);
        for (int k = 0; k <= 16; ++k) {
            motion.at(scene, k * step);
            motion.exposureAt(k * step);
        }
    });
    return 0;
}
