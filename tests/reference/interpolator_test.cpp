// The surface's own interpolation at single places against the reference's, which shares no code with it.

#include "surface/interpolator.h"
#include "reference/surface.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

void expectSame(const Heightmap& map, Filter filter) {
    Relief relief = makeRelief(1.0, 10.0);
    relief.filter = filter;
    relief.greatest_radius = 1.1;
    const Surface surface(map, relief);
    const Interpolator interpolator(map, filter);
    Random random(7);
    for (int i = 0; i < 4000; ++i) {
        dvec3 p = randomUnit(random);
        if (i % 4 == 0) p = glm::normalize(dvec3(1e-4 * p.x, p.y < 0.0 ? -1.0 : 1.0, 1e-4 * p.z));  // at a pole
        const double longitude = std::atan2(p.x, p.z), colatitude = std::atan2(std::hypot(p.x, p.z), p.y);
        const HeightSample sample = interpolator.at(longitude, colatitude);
        ASSERT_NEAR(sample.value, surface.stored(p), 1e-12) << longitude << " " << colatitude;
        const double rho = std::hypot(p.x, p.z), r = surface.radius(p);
        const dvec3 east(p.z / rho, 0.0, -p.x / rho), south = glm::cross(east, p);
        const dvec3 gradient =
            p - relief.scale / r * (sample.per_longitude / rho * east + sample.per_colatitude * south);
        ASSERT_LT(glm::distance(gradient, surface.gradient(r * p)), 1e-8) << longitude << " " << colatitude;
    }
}

TEST(Interpolator, IsTheReferencesSurface) {
    for (Registration registration : {Registration::Texel, Registration::Gridline})
        for (Filter filter : {Filter::Bilinear, Filter::BSpline})
            for (const auto& [width, height] : {std::pair(32, 17), std::pair(5, 3), std::pair(1, 2)})
                expectSame(noiseMap(width, height, registration, 3), filter);
    expectSame(noiseMap(4, 1, Registration::Texel, 4), Filter::Bilinear);
}

TEST(Interpolator, KnowsTheLongitudeOriginAndRipples) {
    expectSame(makeMap(
                   8, 4, Registration::Texel, [](int i, int j) { return i * 0.1 + j * 0.05; }, 0.0),
               Filter::Bilinear);
    expectSame(makeMap(
                   8, 4, Registration::Gridline, [](int i, int j) { return i * 0.1 + j * 0.05; }, -37.5),
               Filter::BSpline);
    Heightmap ripples = flatMap(1, 1, Registration::Texel, 0.0);
    ripples.ripples = Ripples{7, 5};
    expectSame(ripples, Filter::Bilinear);
}

// On one patch a sample tells all the others.
TEST(Interpolator, ASampleDescribesItsWholePatch) {
    for (Registration registration : {Registration::Texel, Registration::Gridline}) {
        const Heightmap map = noiseMap(16, 9, registration, 5);
        const Interpolator heights(map, Filter::Bilinear);
        Random random(11);
        int same = 0;
        for (int i = 0; i < 4000; ++i) {
            const dvec3 p = randomUnit(random), q = randomUnit(random);
            const double longitude = std::atan2(p.x, p.z), colatitude = std::acos(p.y);
            const double east = 0.1 * q.x, south = 0.1 * q.y;
            if (std::abs(longitude + east) > kPi || colatitude + south < 0.0 || colatitude + south > kPi) continue;
            if (!heights.onOnePatch(longitude, colatitude, longitude + east, colatitude + south)) continue;
            ++same;
            const HeightSample from = heights.at(longitude, colatitude);
            const double there =
                from.value + east * from.per_longitude + south * from.per_colatitude + east * south * from.mixed;
            ASSERT_NEAR(there, heights.at(longitude + east, colatitude + south).value, 1e-12);
        }
        EXPECT_GT(same, 1000);
        EXPECT_FALSE(Interpolator(map, Filter::BSpline).onOnePatch(0.1, 0.1, 0.1, 0.1)) << "no such patch";
    }
}

}  // namespace
}  // namespace dsphere::reference::test
