// What patch_curved/patch.glsl says of a patch, in double: its polynomial is the reference's surface, and its bounds
// hold.

#include "tests/shaders/planet.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace dsphere::test {
namespace {

using glsl64::Patch;
using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

struct Case {
    const char* name;
    std::function<Planet()> planet;
};

/// Each kind of surface; a fine map has the grid's cells as its own, a coarse one is subdivided.
std::vector<Case> cases() {
    using enum Registration;
    return {{"spline", [] { return Planet(randomMap(512, 256), 30.0, Texel, Filter::BSpline); }},
            {"spline, gridline", [] { return Planet(randomMap(512, 257), 30.0, Gridline, Filter::BSpline); }},
            {"subdivided spline", [] { return Planet(randomMap(20, 10), 30.0, Texel, Filter::BSpline); }},
            {"ripples",
             [] {
                 return Planet(Ripples{12, 12}, 30.0);
             }},
            {"bilinear", [] { return Planet(randomMap(512, 256), 30.0); }}};
}

double spanOf(const Planet& planet) {
    return planet.maps.maps[0]->greatest - planet.maps.maps[0]->least;
}

/// The patch of a cell, in stored units; the rows at the poles are drawn often.
Patch somePatch(const Planet& planet, Random& random, glsl64::ivec2& cell) {
    const layout::MapData& map = planet.map();
    cell = {int(random() % unsigned(map.width)), int(random() % unsigned(map.rows))};
    if (random() % 4 == 0) cell.y = random() % 2 ? 0 : map.rows - 1;
    return glsl64::fetchPatch(map, 1.0, cell);
}

/// The reference's stored value at that place, by way of a direction.
double reference(const Planet& planet, const glsl64::ivec2& cell, double fu, double fv) {
    const NodeGrid& nodes = *planet.resources.nodes;
    const double west = nodes.longitude(cell.x), north = nodes.colatitude(cell.y);
    const double longitude = west + fu * nodes.cellWidth();
    const double colatitude = north + fv * (nodes.colatitude(cell.y + 1) - north);
    return planet.surface->stored(
        {std::sin(colatitude) * std::sin(longitude), std::cos(colatitude), std::sin(colatitude) * std::cos(longitude)});
}

TEST(CurvedPatch, ValuesAreTheReferences) {
    Random random(1);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        const double span = spanOf(planet);
        for (int k = 0; k < 4000; ++k) {
            glsl64::ivec2 cell;
            const Patch patch = somePatch(planet, random, cell);
            const double fu = uniform(random, 0.0, 1.0), fv = uniform(random, 0.0, 1.0);
            // Nodes and phases are floats.
            ASSERT_NEAR(glsl64::patchValue(patch, fu, fv), reference(planet, cell, fu, fv), 2e-7 * span) << c.name;
        }
    }
}

TEST(CurvedPatch, NeighboursMeet) {
    Random random(2);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        const double span = spanOf(planet);
        const layout::MapData& map = planet.map();
        for (int k = 0; k < 2000; ++k) {
            glsl64::ivec2 cell;
            const Patch patch = somePatch(planet, random, cell);
            const double f = uniform(random, 0.0, 1.0);
            const Patch east = glsl64::fetchPatch(map, 1.0, {(cell.x + 1) % map.width, cell.y});
            EXPECT_NEAR(glsl64::patchValue(patch, 1.0, f), glsl64::patchValue(east, 0.0, f), 2e-7 * span) << c.name;
            if (cell.y + 1 == map.rows) continue;
            const Patch south = glsl64::fetchPatch(map, 1.0, {cell.x, cell.y + 1});
            EXPECT_NEAR(glsl64::patchValue(patch, f, 1.0), glsl64::patchValue(south, f, 0.0), 2e-7 * span) << c.name;
        }
    }
}

TEST(CurvedPatch, SlopesAreDifferencesOfValues) {
    Random random(3);
    const double step = 1e-5;
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        const double span = spanOf(planet);
        for (int k = 0; k < 2000; ++k) {
            glsl64::ivec2 cell;
            const Patch patch = somePatch(planet, random, cell);
            const double fu = uniform(random, step, 1.0 - step), fv = uniform(random, step, 1.0 - step);
            const auto value = [&](double du, double dv) { return glsl64::patchValue(patch, fu + du, fv + dv); };
            const glsl64::vec2 slopes = glsl64::patchSlopes(patch, fu, fv);
            ASSERT_NEAR(slopes.x, (value(step, 0.0) - value(-step, 0.0)) / (2.0 * step), 1e-8 * span) << c.name;
            ASSERT_NEAR(slopes.y, (value(0.0, step) - value(0.0, -step)) / (2.0 * step), 1e-8 * span) << c.name;
        }
    }
}

// In the row at a pole the slope eastward is the share of the way from the pole times what poleSlopeEast says.
TEST(CurvedPatch, PoleSlopesTimesTheShareAreTheSlopes) {
    Random random(4);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        const double span = spanOf(planet);
        const int rows = planet.map().rows;
        for (int k = 0; k < 2000; ++k) {
            const bool north = k % 2 == 0;
            const glsl64::ivec2 cell(int(random() % unsigned(planet.map().width)), north ? 0 : rows - 1);
            const Patch patch = glsl64::fetchPatch(planet.map(), 1.0, cell);
            const double fu = uniform(random, 0.0, 1.0), fv = uniform(random, 0.0, 1.0);
            const double share = north ? fv : 1.0 - fv;
            EXPECT_NEAR(share * glsl64::poleSlopeEast(patch, fu, fv, north), glsl64::patchSlopes(patch, fu, fv).x,
                        1e-6 * span)
                << c.name;
        }
    }
}

// Along parabolas of fu and fv inside the cell g's third difference, an average of its third derivative, stays within
// chordTwist; and the bound is worth having: along some chord a fifth of it is reached.
TEST(CurvedPatch, ChordTwistBoundsTheThirdDerivative) {
    Random random(5);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        double closest = 0.0;
        for (int k = 0; k < 2000; ++k) {
            glsl64::ivec2 cell;
            const Patch patch = somePatch(planet, random, cell);
            const glsl64::vec2 start(uniform(random, 0.2, 0.8), uniform(random, 0.2, 0.8));
            const glsl64::vec2 rate(uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1));
            const glsl64::vec2 bend(uniform(random, -0.02, 0.02), uniform(random, -0.02, 0.02));
            const auto value = [&](double y) {
                const glsl64::vec2 at = start + y * (rate + y * bend);
                return glsl64::patchValue(patch, at.x, at.y);
            };
            const double bound = glsl64::chordTwist(glsl64::patchBends(patch), rate, bend);
            for (double y : {0.0, 0.3, 0.7}) {
                const double h = 0.1;
                const double third = value(y + 3 * h) - 3 * value(y + 2 * h) + 3 * value(y + h) - value(y);
                const double derivative = std::abs(third) / (h * h * h);
                ASSERT_LE(derivative, bound * (1.0 + 1e-6) + 1e-6) << c.name;
                closest = std::max(closest, derivative / bound);
            }
        }
        EXPECT_GT(closest, 0.2) << c.name;
    }
}

TEST(CurvedPatch, SteepestAlongBoundsTheGradient) {
    Random random(6);
    const glsl64::vec2 steepness(3.0, 2.0);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        for (int k = 0; k < 2000; ++k) {
            glsl64::ivec2 cell;
            const Patch patch = somePatch(planet, random, cell);
            const glsl64::vec2 reach(uniform(random, 0.0, 0.2), uniform(random, 0.0, 0.2));
            const glsl64::vec3 middle(uniform(random, 0.2, 0.8), uniform(random, 0.2, 0.8), 0.0);
            const double bound = glsl64::steepestAlong(patch, glsl64::patchBends(patch), middle, reach, steepness);
            for (int n = 0; n < 4; ++n) {
                const glsl64::vec2 slopes =
                    glsl64::abs(glsl64::patchSlopes(patch, middle.x + uniform(random, -1.0, 1.0) * reach.x,
                                                    middle.y + uniform(random, -1.0, 1.0) * reach.y));
                ASSERT_LE(1.0 + glsl64::dot(slopes, steepness), bound * (1.0 + 1e-12)) << c.name;
            }
        }
    }
}

}  // namespace
}  // namespace dsphere::test
