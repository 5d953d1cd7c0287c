#include "tests/shaders/planet.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace dsphere::test {
namespace {

dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

glsl64::Pair wide(double value) {
    return {value, 0.0};
}

glsl32::Pair narrow(double value) {
    return {float(value), float(value - double(float(value)))};
}

// A ray from above, straight or slanted, onto the point p.
template <typename Line, typename MakePair>
Line lineThrough(const dvec3& p, const dvec3& d, MakePair pair) {
    return {pair(p.x), pair(p.y), pair(p.z), pair(d.x), pair(d.y), pair(d.z)};
}

struct Case {
    const char* name;
    std::function<Planet()> planet;
};

std::vector<Case> cases(Filter filter) {
    using enum Registration;
    return {{"random 1024x512", [=] { return Planet(randomMap(1024, 512), 15.0, Texel, filter); }},
            {"random 257x129", [=] { return Planet(randomMap(257, 129), 50.0, Texel, filter); }},
            {"random 3x2", [=] { return Planet(randomMap(3, 2), 140.0, Texel, filter); }},
            {"random 1x1", [=] { return Planet(randomMap(1, 1), 20.0, Texel, filter); }},
            {"random gridline 40x21", [=] { return Planet(randomMap(40, 21), -15.0, Gridline, filter); }}};
}

std::vector<Case> cases() {
    std::vector<Case> all = cases(Filter::Bilinear);
#ifdef WITH_CURVED
    for (Case& spline : cases(Filter::BSpline)) all.push_back(std::move(spline));
    for (int n : {1, 12, 61}) all.push_back({"ripples", [n] { return Planet(Ripples{n, n + 1}, 60.0); }});
#endif
    return all;
}

TEST(SurfaceFunctions, HeightAboveTheSurfaceEqualsTheReference) {
    std::mt19937 random(3);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        double unit = planet.unit(), base = planet.packed.reliefs[0].base, scale = planet.packed.reliefs[0].scale;
        double worst64 = 0.0, worst32 = 0.0;
        for (int k = 0; k < 4000; ++k) {
            dvec3 w = randomDirection(random), d = randomDirection(random);
            // Near the surface, where the marcher asks; a few poles among the directions.
            if (k % 10 == 0) w = glm::normalize(dvec3(1e-4 * d.x, d.y > 0 ? 1.0 : -1.0, 1e-4 * d.z));
            dvec3 p = w * (planet.surface->radius(w) / unit);
            double truth = planet.surface->f(p * unit) / unit;
            double steepness = glm::length(planet.surface->gradient(p * unit));
            auto ray64 = glsl64::makeRay(lineThrough<glsl64::Line>(p, d, wide), 0.0, 1e30, true);
            auto frame64 = glsl64::makeFrame(ray64, planet.map(), wide(base), ray64.s_point);
            auto at64 = glsl64::patchPoint(planet.map(), glsl64::fetchPatch(planet.map(), scale, frame64.cell), frame64,
                                           glsl64::localAt(frame64, ray64.d.y, ray64.s_point - frame64.anchor.s));
            worst64 = std::max(worst64, std::abs(at64.g - truth) / steepness);
            auto ray32 = glsl32::makeRay(lineThrough<glsl32::Line>(p, d, narrow), 0.0f, 1e30f, true);
            auto frame32 = glsl32::makeFrame(ray32, planet.map(), narrow(base), ray32.s_point);
            auto at32 =
                glsl32::patchPoint(planet.map(), glsl32::fetchPatch(planet.map(), float(scale), frame32.cell), frame32,
                                   glsl32::localAt(frame32, ray32.d.y, ray32.s_point - frame32.anchor.s));
            // The anchor's s is a rounded number: at32 is the height at a point this far along the ray.
            double slip = std::abs(double(ray32.s_point) - frame32.anchor.s) < 1.0 ? 1.2e-7 : 1.0;
            worst32 = std::max(worst32, std::abs(at32.g - truth) / steepness - slip);
        }
        EXPECT_LE(worst64, 2e-8) << c.name;  // the map's constants are floats in both
        EXPECT_LE(worst32, 5e-8) << c.name;
    }
}

TEST(SurfaceFunctions, GradientEqualsTheReference) {
    std::mt19937 random(4);
    for (const Case& c : cases()) {
        const Planet planet = c.planet();
        double unit = planet.unit(), base = planet.packed.reliefs[0].base, scale = planet.packed.reliefs[0].scale;
        int creased = 0, count = 4000;
        for (int k = 0; k < count; ++k) {
            dvec3 w = randomDirection(random);
            dvec3 p = w * (planet.surface->radius(w) / unit);
            auto ray = glsl64::makeRay(lineThrough<glsl64::Line>(p, -w, wide), 0.0, 1e30, true);
            auto frame = glsl64::makeFrame(ray, planet.map(), wide(base), ray.s_point);
            auto quad = glsl64::fetchPatch(planet.map(), scale, frame.cell);
            auto local = glsl64::localAt(frame, ray.d.y, ray.s_point - frame.anchor.s);
            auto at = glsl64::patchPoint(planet.map(), quad, frame, local);
            dvec3 gradient = glsl64::patchGradient(planet.map(), quad, at, frame.cell.y, p);
            dvec3 truth = planet.surface->gradient(p * unit);
            // Nodes of a subdivided map are rounded to float: 0.004 of some 400 stored units a cell, 1e-5 of the slope
            // (18 of 4,000 gradients of the 3x2 map differ by more than that). The contract's 0.02 degrees are 3.5e-4.
            if (glm::length(gradient - truth) > 5e-5 * glm::length(truth)) ++creased;
        }
        EXPECT_LE(creased, count / 1000) << c.name;  // only on edges, where two patches meet
    }
}

TEST(SurfaceFunctions, OnTheAxisTheNormalIsTheAxis) {
    Planet planet(randomMap(64, 32), 20.0);
    double base = planet.packed.reliefs[0].base, scale = planet.packed.reliefs[0].scale;
    for (double side : {1.0, -1.0}) {
        auto ray =
            glsl64::makeRay(lineThrough<glsl64::Line>({0.0, side, 0.0}, {0.0, -side, 0.0}, wide), 0.0, 1e30, true);
        auto frame = glsl64::makeFrame(ray, planet.map(), wide(base), ray.s_point);
        auto quad = glsl64::fetchPatch(planet.map(), scale, frame.cell);
        auto at = glsl64::patchPoint(planet.map(), quad, frame, glsl64::localAt(frame, ray.d.y, 0.0));
        dvec3 gradient = glsl64::patchGradient(planet.map(), quad, at, frame.cell.y, {0.0, side, 0.0});
        EXPECT_NEAR(glm::normalize(gradient).y, side, 1e-12);
    }
}

TEST(SurfaceFunctions, WrapColumnWraps) {
    EXPECT_EQ(glsl32::wrapColumn(-1, 8), 7);
    EXPECT_EQ(glsl32::wrapColumn(8, 8), 0);
    EXPECT_EQ(glsl32::wrapColumn(3, 8), 3);
}

TEST(SurfaceFunctions, TheSeamPatchReadsTheFirstColumn) {
    RawMap map = randomMap(512, 256);
    Planet planet(map, 10.0);
    auto quad = glsl64::fetchPatch(planet.map(), 1.0, {511, 100});
    EXPECT_EQ(glsl64::patchValue(quad, 0.0, 0.0), planet.packed.nodes[0]->row(100)[511]);
    EXPECT_EQ(glsl64::patchValue(quad, 1.0, 0.0), planet.packed.nodes[0]->row(100)[0]);
}

TEST(SurfaceFunctions, PolarCapsWeighTwice) {
    Planet planet(randomMap(512, 256), 10.0);
    EXPECT_EQ(planet.map().caps, 1);
    double regular = glsl64::cellsPerRadianV(planet.map(), 7);
    EXPECT_DOUBLE_EQ(glsl64::cellsPerRadianV(planet.map(), 0), 2.0 * regular);
    EXPECT_DOUBLE_EQ(glsl64::cellsPerRadianV(planet.map(), planet.map().rows - 1), 2.0 * regular);
}

}  // namespace
}  // namespace dsphere::test
