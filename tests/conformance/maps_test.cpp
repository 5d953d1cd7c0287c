// Hard maps, every way of reading one, and every sign and size of displacement.

#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>
#include <functional>

namespace dsphere::conformance {
namespace {

struct MapCase {
    std::string name;
    std::function<RawMap()> map;
    DisplacedSphere sphere;

    friend void PrintTo(const MapCase& c, std::ostream* out) { *out << c.name; }
};

DisplacedSphere displaced(double percent) {
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    return sphere;
}

DisplacedSphere registered(Registration registration) {
    DisplacedSphere sphere = displaced(15.0);
    sphere.registration = registration;
    return sphere;
}

DisplacedSphere shifted(double longitude_origin) {
    DisplacedSphere sphere = displaced(15.0);
    sphere.longitude_origin = longitude_origin;
    return sphere;
}

DisplacedSphere trueScale(double per_unit, double midlevel) {
    DisplacedSphere sphere;
    sphere.radius = 1737.4;
    sphere.height_scale = per_unit;
    sphere.midlevel = midlevel;
    return sphere;
}

DisplacedSphere ranged(double height_min, double height_max) {
    DisplacedSphere sphere = displaced(15.0);
    sphere.height_min = height_min;
    sphere.height_max = height_max;
    sphere.midlevel = 0.5;
    return sphere;
}

std::function<RawMap()> fractal(int width = 512, int height = 256) {
    return [=] { return test::fractalMap(width, height); };
}

std::function<RawMap()> random(int width, int height) {
    return [=] { return test::randomMap(width, height); };
}

// Values of 0 .. 255: slopes are steps.
RawMap byteMap() {
    RawMap map = test::fractalMap(512, 256);
    for (float& value : map.samples) value = std::floor(value / 256.0f);
    map.full_scale = 255.0;
    return map;
}

// base and what lies `span` above it: floats of such values times a scale would lose the range's bits.
std::function<RawMap()> farFromZero(float base, float span) {
    return [=] {
        RawMap map = test::randomMap(512, 256);
        for (float& value : map.samples) value = base + std::round(value / 65535.0f * span);
        return map;
    };
}

class Maps : public Conformance, public testing::WithParamInterface<MapCase> {};

// From near and far, aimed at the solid and beside it.
TEST_P(Maps, FromAllAround) {
    World world = sphereWorld(GetParam().map(), GetParam().sphere);
    Queries rays = randomRays(kManyRays / 2, 1.2, 1.05, 31), far = randomRays(kManyRays / 2, 5.0, 1.05, 32);
    rays.insert(rays.end(), far.begin(), far.end());
    expectContract(probe(world, rays));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Maps,
    testing::Values(MapCase{"Flat", [] { return test::constantMap(512, 256, 0.0f); }, displaced(0.0)},
                    MapCase{"FlatUnderDisplacement", [] { return test::constantMap(512, 256, 0.0f); }, displaced(15.0)},
                    MapCase{"Constant", [] { return test::constantMap(512, 256, 0.7f); }, displaced(15.0)},
                    MapCase{"Checkerboard", [] { return test::checkerboardMap(512, 256); }, displaced(15.0)},
                    MapCase{"CoarseCheckerboard", [] { return test::checkerboardMap(32, 16); }, displaced(50.0)},
                    MapCase{"Needles", [] { return test::spikeMap(512, 256); }, displaced(15.0)},
                    MapCase{"Terraces", [] { return test::terraceMap(512, 256); }, displaced(15.0)},
                    MapCase{"EightBit", byteMap, displaced(15.0)}),
    caseName<MapCase>);

INSTANTIATE_TEST_SUITE_P(Sizes, Maps,
                         testing::Values(MapCase{"1x1", random(1, 1), displaced(15.0)},
                                         MapCase{"2x1", random(2, 1), displaced(15.0)},
                                         MapCase{"3x2", random(3, 2), displaced(15.0)},
                                         MapCase{"257x129", random(257, 129), displaced(15.0)},
                                         MapCase{"1021x511", random(1021, 511), displaced(15.0)},
                                         MapCase{"2048x3", random(2048, 3), displaced(15.0)},
                                         MapCase{"3x2048", random(3, 2048), displaced(15.0)}),
                         caseName<MapCase>);

INSTANTIATE_TEST_SUITE_P(Displacements, Maps,
                         testing::Values(MapCase{"0percent", fractal(), displaced(0.0)},
                                         MapCase{"0p000001percent", fractal(), displaced(1e-6)},
                                         MapCase{"15percent", fractal(), displaced(15.0)},
                                         MapCase{"50percent", fractal(), displaced(50.0)},
                                         MapCase{"140percent", fractal(), displaced(140.0)},
                                         MapCase{"Minus15percent", fractal(), displaced(-15.0)}),
                         caseName<MapCase>);

INSTANTIATE_TEST_SUITE_P(Readings, Maps,
                         testing::Values(MapCase{"Gridline", fractal(721, 361), registered(Registration::Gridline)},
                                         MapCase{"CoarseGridline", random(12, 7), registered(Registration::Gridline)},
                                         MapCase{"LonOrigin0", random(512, 256), shifted(0.0)},
                                         MapCase{"LonOrigin33", random(512, 256), shifted(33.0)},
                                         MapCase{"LonOrigin33Odd", random(257, 129), shifted(33.0)},
                                         MapCase{"HeightScale", fractal(), trueScale(0.004, 20000.0)},
                                         MapCase{"HeightRange", fractal(), ranged(10000.0, 60000.0)},
                                         MapCase{"LittleContrast", farFromZero(30000, 200), ranged(30000.0, 30200.0)},
                                         MapCase{"RadiiInMetres", farFromZero(1737400, 15000),
                                                 trueScale(0.005, 1737400.0)}),
                         caseName<MapCase>);

// Rays aimed around one texel that stands out of level ground: its flanks, its foot and its tip.
void expectAroundTexel(float ground, float texel, int i, int j) {
    RawMap map = test::constantMap(512, 256, ground);
    map.samples[std::size_t(j * map.width + i)] = 65535.0f * texel;
    World world = sphereWorld(std::move(map), 15.0);
    const Heightmap& heights = *world.maps.maps[0];
    Random random(33);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        double spread = 2.5 * 2.0 * kPi / 512;
        double latitude = nodeLatitude(heights, j) + uniform(random, -spread, spread);
        double longitude = nodeLongitude(heights, i) + uniform(random, -spread, spread) / std::cos(latitude);
        dvec3 at = uniform(random, 0.85, 1.02) * direction(longitude, latitude);
        rays.push_back(aim(at + 2.0 * glm::normalize(randomUnit(random) + 1.05 * at), at));
    }
    expectContract(probe(world, rays));
}

using SingleTexel = Conformance;

TEST_F(SingleTexel, Spike) {
    expectAroundTexel(0.0f, 1.0f, 200, 100);
}

TEST_F(SingleTexel, Pit) {
    expectAroundTexel(1.0f, 0.0f, 200, 100);
}

TEST_F(SingleTexel, SpikeAtTheSeam) {
    expectAroundTexel(0.0f, 1.0f, 511, 100);
    expectAroundTexel(0.0f, 1.0f, 0, 100);
}

TEST_F(SingleTexel, PitAtTheSeam) {
    expectAroundTexel(1.0f, 0.0f, 511, 100);
    expectAroundTexel(1.0f, 0.0f, 0, 100);
}

TEST_F(SingleTexel, SpikeInTheFirstRow) {
    expectAroundTexel(0.0f, 1.0f, 77, 0);
}

TEST_F(SingleTexel, PitInTheLastRow) {
    expectAroundTexel(1.0f, 0.0f, 77, 255);
}

}  // namespace
}  // namespace dsphere::conformance
