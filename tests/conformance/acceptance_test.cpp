// The main picture's map and three generated ones, 4096x2048, every pixel of 1280x720 in the three views of
// bench: 921,600 rays each. Of the curved surfaces, and where the cases are run again, a 16th of that, unless
// DSPHERE_FULL_SIZE is set.

#include "bench/views.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cstdlib>
#include <filesystem>

namespace dsphere::conformance {
namespace {

using Acceptance = Conformance;

constexpr int kWidth = 4096, kHeight = 2048;
const bool kFullSize = std::getenv("DSPHERE_FULL_SIZE");
const int kFilmWidth = kFullSize || !isRunAgain() ? 1280 : 320;
const int kCurvedFilmWidth = kFullSize ? 1280 : 320;

void expectAllViews(World world, int film_width = kFilmWidth) {
    world.addSun(bench::kSun);
    world.scene.film.width = film_width;
    world.scene.film.height = film_width * 9 / 16;
    const auto least = std::uint64_t(0.13 * film_width * world.scene.film.height);
    for (const bench::StandardView& view : bench::standardViews()) {
        SCOPED_TRACE(view.name);
        world.scene.camera = bench::cameraOf(view, world.unit());
        verify::Report report = picture(world).report;
        EXPECT_GT(report.hits, least);
        EXPECT_GT(report.shadow_rays, least);
        expectContract(report);
        std::printf("%s: %llu tangent, distance 99.9 %% %.2g, greatest %.2g, along the ray %.2g, normals 99 %% %.2g\n",
                    view.name, static_cast<unsigned long long>(report.tangent), report.distanceQuantile(0.999),
                    report.distanceQuantile(1.0), report.worst_along_ray,
                    report.normalQuantile(verify::contract::kNormalShare));
    }
}

TEST_F(Acceptance, Fractal) {
    expectAllViews(sphereWorld(test::fractalMap(kWidth, kHeight), 5.0));
}
TEST_F(Acceptance, Spikes) {
    expectAllViews(sphereWorld(test::spikeMap(kWidth, kHeight), 60.0));
}
TEST_F(Acceptance, Checkerboard) {
    expectAllViews(sphereWorld(test::checkerboardMap(kWidth, kHeight), 25.0));
}

constexpr const char* kGeoidPath = "/usr/share/proj/egm96_15.gtx";

World geoidWorld(Filter filter = Filter::Bilinear) {
    DisplacedSphere sphere;
    sphere.max_displacement = 45.0;
    sphere.height_min = -107.0;
    sphere.height_max = 86.0;
    sphere.midlevel = 0.55;
    sphere.filter = filter;
    return sphereWorld(readRawMap(kGeoidPath), sphere);
}

TEST_F(Acceptance, Geoid) {
    if (!std::filesystem::exists(kGeoidPath)) GTEST_SKIP() << "the package proj-data is not installed";
    expectAllViews(geoidWorld());
}

using CurvedViews = Conformance;

void expectSplineViews(RawMap map, double percent) {
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    sphere.filter = Filter::BSpline;
    expectAllViews(sphereWorld(std::move(map), sphere), kCurvedFilmWidth);
}

TEST_F(CurvedViews, SplineOfTheGeoid) {
    if (!std::filesystem::exists(kGeoidPath)) GTEST_SKIP() << "the package proj-data is not installed";
    expectAllViews(geoidWorld(Filter::BSpline), kCurvedFilmWidth);
}
TEST_F(CurvedViews, SplineOfSpikes) {
    expectSplineViews(test::spikeMap(1024, 512), 60.0);
}
TEST_F(CurvedViews, SplineOfACheckerboard) {
    expectSplineViews(test::checkerboardMap(1024, 512), 25.0);
}

TEST_F(CurvedViews, Ripples) {
    for (double percent : {5.0, 25.0, 60.0}) {
        SCOPED_TRACE(percent);
        DisplacedSphere sphere;
        sphere.max_displacement = percent;
        sphere.ripples = Ripples{};
        World world;
        world.maps.maps.push_back(std::make_unique<Heightmap>(loadHeightmap(sphere)));
        world.addSphere(sphere, 0);
        expectAllViews(std::move(world), kCurvedFilmWidth);
    }
}

// From 1e6 R, through a field of view that shows the same, the answers are as exact as from 3 R.
TEST_F(Acceptance, FarAsNear) {
    World world = sphereWorld(test::fractalMap(1024, 512), 5.0);
    world.addSun(dvec3(1.5, 1.8, 1.9));
    world.scene.film.width = 640;
    world.scene.film.height = 360;
    dvec3 towards = glm::normalize(dvec3(2.4, 1.2, 1.6));
    double near_quantile = 0.0;
    for (double distance : {3.0, 1e6}) {
        SCOPED_TRACE(distance);
        world.lookAt(towards * distance * world.unit(), dvec3(0.0), dvec3(0.0, 1.0, 0.0), pictureFov(distance, 0.8));
        verify::Report report = picture(world).report;
        expectContract(report);
        if (near_quantile == 0.0) near_quantile = report.distanceQuantile(0.999);
        EXPECT_LE(report.distanceQuantile(0.999), 1.1 * near_quantile);
        EXPECT_LE(report.worst_along_ray, 1.0);
    }
}

}  // namespace
}  // namespace dsphere::conformance
