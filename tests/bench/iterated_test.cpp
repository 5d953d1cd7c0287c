// Photogrammetry's iteration on planets whose hits are known.

#include "bench/iterated.h"
#include "bench/suite.h"
#include "bench/views.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::bench {
namespace {

class Iterated : public testing::TestWithParam<bool> {
  protected:
    static Workload planet(RawMap map, double percent) {
        Workload workload = suiteWorkload(std::move(map), percent);
        Film film;
        film.width = 1000;
        film.height = 1000;
        workload.views.push_back(
            {"whole", cameraOf(standardViews()[0], workload.maps.reliefs[0].greatest_radius), film});
        return workload;
    }
};

TEST_P(Iterated, FindsASphereAtOnce) {
    const Workload flat = planet(test::constantMap(64, 32, 0.0f), 5.0);
    const IteratedSearch search(flat, GetParam());
    const PixelSize pixel(flat.views[0]);
    EXPECT_NEAR(search.find({0.0, 0.3, 4.0}, {0.0, 0.0, -1.0}, pixel).value(), 4.0 - std::sqrt(0.91), 1e-12);
    EXPECT_NEAR(search.find({0.0, 0.3, 4.0}, {0.0, 0.0, -2.0}, pixel).value(), 2.0 - 0.5 * std::sqrt(0.91), 1e-12);
    EXPECT_FALSE(search.find({0.0, 1.1, 4.0}, {0.0, 0.0, -1.0}, pixel));
    EXPECT_FALSE(search.find({0.0, 0.3, 4.0}, {0.0, 0.0, 1.0}, pixel)) << "behind it";
}

TEST_P(Iterated, ComesToRestOnGentleHills) {
    const Workload hills = planet(test::fractalMap(64, 32), 2.0);
    const IteratedSearch search(hills, GetParam());
    const PixelSize pixel(hills.views[0]);
    const Interpolator heights(*hills.maps.maps[0], Filter::Bilinear);
    const Relief& relief = hills.maps.reliefs[0];
    for (double y : {-0.4, -0.1, 0.2, 0.5}) {
        const double t = search.find({0.1, y, 4.0}, {0.0, 0.0, -1.0}, pixel).value();
        const dvec3 p(0.1, y, 4.0 - t);
        const double stored = heights.at(std::atan2(p.x, p.z), std::acos(p.y / glm::length(p))).value;
        EXPECT_NEAR(glm::length(p), relief.base + relief.scale * stored, 3e-5) << y;
    }
}

// A ray over the datum sphere that a ridge beside it would stop: the iteration takes it for a miss.
TEST_P(Iterated, NeverMeetsWhatStandsAboveItsFirstSphere) {
    RawMap map = test::constantMap(360, 180, 0.0f);
    for (int j = 0; j < 180; ++j) map.samples[std::size_t(j) * 360 + 270] = 65535.0f;  // longitude 90, +x
    const Workload ridge = planet(std::move(map), 10.0);
    EXPECT_FALSE(IteratedSearch(ridge, GetParam()).find({1.08, 0.0, 4.0}, {0.0, 0.0, -1.0}, PixelSize(ridge.views[0])));
}

INSTANTIATE_TEST_SUITE_P(BothForms, Iterated, testing::Values(false, true));

}  // namespace
}  // namespace dsphere::bench
