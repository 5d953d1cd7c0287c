#include "viewer/edits.h"

#include "scene/parser.h"
#include "viewer/state.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

Scene parsed(const std::string& world) {
    return parseScene("WorldBegin\n" + world, "edits.pbrt", "/maps");
}

const char* const kPlanets =
    "LightSource \"distant\" \"point3 from\" [0 1 0]\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"a.png\" \"float maxdispl\" 2 \"float nodata\" -32768\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"b.png\" \"float heightscale\" .1\n"
    "Material \"mirror\"\nShape \"sphere\"\n";

TEST(Edits, ReachTheirOwnShape) {
    const Scene original = parsed(kPlanets);
    Edits edits = noEdits(original, 1.0);
    EXPECT_EQ(reworkBetween(original, edited(original, edits)), Rework::Nothing);
    edits.shapes[1].exaggeration = 3.0;
    edits.shapes[1].midlevel = 0.5;
    const Scene scene = edited(original, edits);
    EXPECT_EQ(scene.shapes[0].geometry, original.shapes[0].geometry);
    EXPECT_DOUBLE_EQ(*std::get<DisplacedSphere>(scene.shapes[1].geometry).height_scale, 0.3);
    EXPECT_EQ(std::get<DisplacedSphere>(scene.shapes[1].geometry).midlevel, 0.5);
    EXPECT_EQ(reworkBetween(original, scene), Rework::Relief);
}

TEST(Edits, TakeTheLeastWork) {
    const Scene original = parsed(kPlanets);
    const auto rework = [&](const auto& change) {
        Edits edits = noEdits(original, 1.0);
        change(edits);
        return reworkBetween(original, edited(original, edits));
    };
    EXPECT_EQ(rework([](Edits& e) { e.sun_brightness = 2.0; }), Rework::Look);
    EXPECT_EQ(rework([](Edits& e) { e.sun_direction = dvec3(1.0, 0.0, 0.0); }), Rework::Look);
    EXPECT_EQ(rework([](Edits& e) { e.shapes[0].texture = ConstantColour{.rgb = dvec3(0.25)}; }), Rework::Look);
    EXPECT_EQ(rework([](Edits& e) { e.shapes[0].texture = HeightRamp{.ramp = "viridis"}; }), Rework::Relief)
        << "shaders know that there is none";
    const Scene ramped = edited(original, [&] {
        Edits edits = noEdits(original, 1.0);
        edits.shapes[0].texture = edits.shapes[1].texture = HeightRamp{.ramp = "viridis"};
        return edits;
    }());
    Edits other = noEdits(ramped, 1.0);
    other.shapes[0].texture = HeightRamp{.ramp = "geoid"};
    EXPECT_EQ(reworkBetween(ramped, edited(ramped, other)), Rework::Look);
    other.shapes[0].texture = ConstantColour{};
    EXPECT_EQ(reworkBetween(ramped, edited(ramped, other)), Rework::Look) << "the second is still coloured by heights";
    ImageMap image;
    image.path = "c.png";
    EXPECT_EQ(rework([&](Edits& e) { e.shapes[0].texture = image; }), Rework::Reading);
    EXPECT_EQ(rework([](Edits& e) { e.shapes[0].filter = Filter::BSpline; }), Rework::Reading);
    EXPECT_EQ(rework([](Edits& e) { e.shapes[2].texture = ConstantColour{}; }), Rework::Nothing) << "mirrors have none";
}

TEST(Edits, TheNightSideHasALightOfItsOwn) {
    const Scene original = parsed(kPlanets);
    Edits edits = noEdits(original, 1.0);
    edits.night_light = 0.25;
    const Scene lit = edited(original, edits);
    ASSERT_EQ(lit.lights.size(), 2u);
    const auto &sun = std::get<DistantLight>(lit.lights[0]), &opposite = std::get<DistantLight>(lit.lights[1]);
    EXPECT_EQ(opposite.direction, -sun.direction);
    EXPECT_EQ(opposite.radiance, 0.25 * sun.radiance);
    EXPECT_EQ(reworkBetween(original, lit), Rework::Reading) << "shaders know how many lights there are";
    edits.night_light = 0.5;
    EXPECT_EQ(reworkBetween(lit, edited(original, edits)), Rework::Look);
    // Saved and opened again.
    Edits again = noEdits(lit, 1.0);
    EXPECT_EQ(again.night_light, 0.25);
    EXPECT_EQ(edited(lit, again).lights, lit.lights);
    again.night_light = 0.5;
    again.sun_direction = dvec3(1.0, 0.0, 0.0);
    const Scene turned = edited(lit, again);
    ASSERT_EQ(turned.lights.size(), 2u) << "the one that was there";
    EXPECT_EQ(std::get<DistantLight>(turned.lights[1]), (DistantLight{{-1.0, 0.0, 0.0}, 0.5 * sun.radiance}));
}

// Nothing equals NaN, not even itself.
TEST(Edits, AnUnknownValueOfNanIsNoChange) {
    Scene original = parsed(kPlanets);
    std::get<DisplacedSphere>(original.shapes[0].geometry).nodata = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(reworkBetween(original, edited(original, noEdits(original, 1.0))), Rework::Nothing);
}

TEST(Edits, StayOnAnotherVersionOfTheSceneWhereTheyFit) {
    const Scene original = parsed(kPlanets);
    Edits edits = noEdits(original, 1.0);
    edits.shapes[0].exaggeration = 2.0;
    edits.shapes[1].exaggeration = 3.0;
    edits.sun_brightness = 2.0;
    std::vector<std::string> lost;
    EXPECT_EQ(refit(edits, original, 1.0, lost), edits);
    EXPECT_TRUE(lost.empty());
    const Edits fitted = refit(edits, parsed("Shape \"displacedsphere\"\nShape \"sphere\"\n"), 1.0, lost);
    EXPECT_EQ(fitted.shapes.size(), 2u);
    EXPECT_EQ(fitted.shapes[0].exaggeration, 2.0);
    EXPECT_EQ(fitted.shapes[1], ShapeEdits{});
    EXPECT_EQ(fitted.sun_brightness, 1.0);
    EXPECT_EQ(lost, (std::vector<std::string>{"sphere 2 has no relief now", "there is no sun now"}));
    lost.clear();
    edits = noEdits(original, 1.0);
    edits.shapes[0].texture = HeightRamp{.ramp = "viridis"};
    edits.shapes[2].texture = ConstantColour{};
    refit(edits, parsed("Material \"mirror\"\nShape \"displacedsphere\"\n"), 1.0, lost);
    EXPECT_EQ(lost, (std::vector<std::string>{"the material of planet has no colour now", "shape 3 is gone"}));
}

// The factor of the command line is no change of a shape that has no relief.
TEST(Edits, BeginWithAFactorOfEveryRelief) {
    const Scene original = parsed(kPlanets);
    const Edits edits = noEdits(original, 3.0);
    EXPECT_EQ(edits.shapes[1].exaggeration, 3.0);
    EXPECT_EQ(edits.shapes[2], ShapeEdits{});
    std::vector<std::string> lost;
    EXPECT_EQ(refit(edits, original, 3.0, lost), edits);
    EXPECT_TRUE(lost.empty());
    const Scene larger = parsed(std::string(kPlanets) + "Shape \"displacedsphere\"\n");
    EXPECT_EQ(refit(edits, larger, 3.0, lost).shapes[3].exaggeration, 3.0);
}

TEST(History, GoesBackAndForth) {
    State state;
    History history;
    history.start(state);
    EXPECT_EQ(history.step(-1), nullptr);
    for (float exposure : {1.0f, 2.0f, 2.0f, 3.0f}) {
        state.tone.exposure = exposure;
        history.add(state);
    }
    EXPECT_EQ(history.step(-1)->tone.exposure, 2.0f);
    EXPECT_EQ(history.step(-1)->tone.exposure, 1.0f) << "what is the same is one state";
    EXPECT_EQ(history.step(1)->tone.exposure, 2.0f);
    state.tone.exposure = 7.0f;
    history.add(state);
    EXPECT_EQ(history.step(1), nullptr) << "a change ends what could be redone";
    EXPECT_EQ(history.step(-1)->tone.exposure, 2.0f);
}

TEST(History, WhatCannotBeShownIsNotGoneBackTo) {
    State state;
    History history;
    history.start(state);
    for (const float exposure : {1.0f, 2.0f, 1.0f}) {
        state.tone.exposure = exposure;
        history.add(state);
    }
    history.amend([](State& one) {
        if (one.tone.exposure == 2.0f) one.tone.exposure = 1.0f;
    });
    ASSERT_NE(history.step(-1), nullptr);
    EXPECT_EQ(history.step(-1), nullptr) << "the three that are alike now are one";
    EXPECT_EQ(history.step(1)->tone.exposure, 1.0f);
}

TEST(History, ForgetsTheOldest) {
    State state;
    History history;
    history.start(state);
    for (int i = 1; i <= 1000; ++i) {
        state.tone.exposure = float(i);
        history.add(state);
    }
    int back = 0;
    while (history.step(-1)) ++back;
    EXPECT_EQ(back, int(History::kMost) - 1);
}

}  // namespace
}  // namespace dsphere::viewer
