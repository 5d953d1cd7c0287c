// The certified first hit against a dense search in long double, on small maps of every kind.

#include "base/parallel.h"
#include "tests/reference/agree.h"

#include <gtest/gtest.h>

namespace dsphere::reference::test {
namespace {

struct Case {
    const char* name;
    Heightmap map;
    Relief relief;
};

std::vector<Case> cases() {
    using enum Registration;
    std::vector<Case> all;
    all.push_back({"1x1 texel", noiseMap(1, 1, Texel, 1), makeRelief(1.0, 40.0)});
    all.push_back({"2x1 texel 140 %", noiseMap(2, 1, Texel, 2), makeRelief(1.0, 140.0)});
    all.push_back({"1x3 texel", noiseMap(1, 3, Texel, 3), makeRelief(2.0, 60.0)});
    all.push_back({"3x2 texel", noiseMap(3, 2, Texel, 4), makeRelief(1.0, 100.0)});
    all.push_back({"3x2 gridline", noiseMap(3, 2, Gridline, 5), makeRelief(1.0, 60.0)});
    all.push_back({"4x3 gridline", noiseMap(4, 3, Gridline, 6), makeRelief(1.0, 140.0)});
    all.push_back({"8x4 texel", noiseMap(8, 4, Texel, 7), makeRelief(1.0, 50.0, 0.5)});
    all.push_back({"8x4 negative", noiseMap(8, 4, Texel, 8), makeRelief(1000.0, -70.0)});
    all.push_back({"8x5 gridline checkerboard", checkerboard(8, 5, Gridline), makeRelief(1.0, 30.0)});
    all.push_back({"16x8 texel", noiseMap(16, 8, Texel, 9), makeRelief(1e-3, 20.0)});
    all.push_back({"16x8 checkerboard 140 %", checkerboard(16, 8, Texel), makeRelief(1.0, 140.0)});
    all.push_back({"7x9 gridline", noiseMap(7, 9, Gridline, 10), makeRelief(1.0, 5.0)});
    all.push_back({"64x1 texel", noiseMap(64, 1, Texel, 11), makeRelief(1.0, 30.0)});
    all.push_back({"32x17 spikes", noiseMap(32, 17, Texel, 12), makeRelief(1.0, 120.0)});
    for (std::size_t k = 0; k < all.size(); ++k) all[k].map.longitude_origin = -180.0 + 77.7 * double(k);
    return all;
}

void compareAll(int rays, int samples, std::uint64_t seed) {
    for (const Case& what : cases()) {
        const Surface surface(what.map, what.relief);
        const Oracle oracle(what.map, what.relief);
        const double radius = surface.greatestRadius();
        Tally tally;
        parallelFor(std::size_t(rays), [&](std::size_t k) {
            Random random(seed + 1000003 * k);
            const double distance = radius * (k % 3 == 0 ? 1.0001 : k % 3 == 1 ? 1.5 : 20.0);
            expectAgreement(what.name, surface, oracle, randomRay(random, distance, radius), samples, tally);
        });
        printf("    %-28s %d rays, %d hits, %d tangent\n", what.name, tally.rays.load(), tally.hits.load(),
               tally.tangent.load());
        EXPECT_EQ(tally.finer, 0) << what.name;
        EXPECT_LE(tally.tangent, 2 + rays / 100) << what.name;
    }
}

TEST(RandomMaps, AgreeWithDenseSearch) {
    compareAll(60, 20000, 1);
}

TEST(RandomMaps, AgreeWithVeryDenseSearch) {
    compareAll(6, 200000, 2);
}

}  // namespace
}  // namespace dsphere::reference::test
