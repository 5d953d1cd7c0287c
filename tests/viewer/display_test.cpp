// What the window shows of a film, computed on the device.

#include "viewer/display.h"

#include "gpu/device.h"
#include "scene/parser.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"
#include "tests/support/testmaps.h"
#include "viewer/displayworld.h"
#include "viewer/stage.h"

#include <gtest/gtest.h>

#include <functional>
#include <tuple>

namespace dsphere::viewer {
namespace {

constexpr int kFilmWidth = 256, kFilmHeight = 160, kPlanetRadius = 58;  // of the planet: pixels, about

struct Code {
    int r, g, b;
    int light() const { return r + g + b; }
};

class DisplayTest : public testing::Test {
  protected:
    void show(const RawMap& map, const std::string& displacement) {
        test::writePgm16(folder_.path() / "map.pgm", map);
        const Scene scene = parseScene(
            "Scale -1 1 1 LookAt 0 0 4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40\n"
            "Integrator \"directlighting\"\nWorldBegin\nLightSource \"distant\" \"point3 from\" [1 0 0]\n"
            "Material \"matte\" \"rgb Kd\" [.8 .8 .8]\n"
            "Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" \"float maxdispl\" " +
                displacement,
            "display.pbrt", folder_.path());
        stage_ =
            std::make_unique<Stage>(device_, makeDocument("display.pbrt", scene, scene, Levels::Finest), MarchMethod());
        display_.forget();
    }
    void take(Show what, bool shadows, const ShownRange& range = {}) {
        const Document& document = stage_->document();
        if (stage_->prepareFilm(what, !shadows, kFilmWidth, kFilmHeight)) display_.forget();
        stage_->setCamera(document.original.camera, kFilmWidth, kFilmHeight);
        ViewSettings view;
        view.show = what;
        stage_->begin(view, Sampling::Centres, shadows);
        while (!stage_->film().step(1.0)) {
        }
        display_.convert(stage_->film(), {what, {}, range}, displayWorld(document));
        codes_.resize(std::size_t(kFilmWidth) * kFilmHeight);
        display_.pixels().download(0, 4 * codes_.size(), codes_.data());
    }
    Code at(int x, int y) const {
        const std::uint32_t code = codes_[std::size_t(y) * kFilmWidth + std::size_t(x)];
        return {int(code & 255u), int(code >> 8 & 255u), int(code >> 16 & 255u)};
    }
    /// Pixels of columns [x0, x1) for which something holds.
    int count(int x0, int x1, const std::function<bool(const Code&)>& so) const {
        int found = 0;
        for (int y = 0; y < kFilmHeight; ++y)
            for (int x = x0; x < x1; ++x) found += so(at(x, y)) ? 1 : 0;
        return found;
    }

    test::TempFolder folder_;
    gpu::Device device_{{.selector = test::testDevice(), .validation = true}};
    std::unique_ptr<Stage> stage_;
    Display display_{device_};
    std::vector<std::uint32_t> codes_;
};

/// Where a sample is half done, the pixels that have it are as bright as the others.
TEST_F(DisplayTest, SumsAreShownBetweenSamplesAndWithin) {
    show(test::fractalMap(512, 256), "2");
    take(Show::Colour, true);
    stage_->begin({}, Sampling::Jittered, true);
    ProgressiveFilm& film = stage_->film();
    const auto shown = [&] {
        display_.convert(film, {}, displayWorld(stage_->document()));
        display_.pixels().download(0, 4 * codes_.size(), codes_.data());
        return codes_;
    };
    const auto light = [&](int y0, int y1) {
        double sum = 0.0;
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < kFilmWidth; ++x) sum += at(x, y).light();
        return sum;
    };
    while (!film.step(1.0)) {
    }
    const std::vector<std::uint32_t> one = shown();
    const double upper = light(0, kFilmHeight / 2);
    while (film.share() < 0.4) ASSERT_FALSE(film.step(1e-6));
    ASSERT_FALSE(film.between());
    const std::vector<std::uint32_t> half = shown();
    EXPECT_NE(half, one);
    EXPECT_NEAR(light(0, kFilmHeight / 2), upper, 0.1 * upper) << "in codes, of which the mean of two samples has more";
    const auto lower = std::ptrdiff_t(kFilmWidth) * (3 * kFilmHeight / 4);
    EXPECT_TRUE(std::equal(half.begin() + lower, half.end(), one.begin() + lower)) << "which has one sample yet";
}

/// The sun stands on the right, so the left half of the planet is in the night.
TEST_F(DisplayTest, TheTerminatorStaysWhereShadowsAreLeftOut) {
    const int middle = kFilmWidth / 2, night = middle - kPlanetRadius / 4, day = middle + kPlanetRadius / 4;
    const auto lit = [](const Code& colour) { return colour.light() > 60; };
    show(test::fractalMap(512, 256), "8");
    take(Show::Colour, true);
    const int night_lit = count(0, night, lit), day_lit = count(day, kFilmWidth, lit);
    EXPECT_LT(night_lit, 40) << "the scene's own shadows leave the night dark";
    take(Show::Colour, false);
    EXPECT_LE(count(0, night, lit), night_lit + 20) << "no bright specks on the night side";
    EXPECT_NEAR(count(day, kFilmWidth, lit), day_lit, 0.15 * day_lit);
    EXPECT_TRUE(device_.validationMessages().empty());
}

TEST_F(DisplayTest, GraticuleLinesRunEveryThirtyDegrees) {
    show(test::constantMap(64, 32, 0.0f), "0");
    ShownRange range;
    range.graticule_spacing = 30.0;
    take(Show::Graticule, true, range);
    const auto line = [&](int x, int y) { return at(x, y).r > at(x, y).b + 60; };
    int meridians = 0, parallels = 0;
    for (int x = 1; x < kFilmWidth; ++x) meridians += line(x, 90) && !line(x - 1, 90) ? 1 : 0;
    for (int y = 1; y < kFilmHeight; ++y) parallels += line(131, y) && !line(131, y - 1) ? 1 : 0;
    EXPECT_EQ(meridians, 5) << "60 degrees west to 60 degrees east";
    EXPECT_EQ(parallels, 5);
}

TEST_F(DisplayTest, ContoursAreOfHeight) {
    const auto contours = [&](double spacing) {
        ShownRange range;
        std::tie(range.least_height, range.greatest_height) = heightRange(stage_->document(), 0);
        range.contour_spacing = 1e9;
        take(Show::Heights, true, range);
        const std::vector<std::uint32_t> bare = codes_;
        range.contour_spacing = spacing;
        take(Show::Heights, true, range);
        int differing = 0;
        for (std::size_t i = 0; i < bare.size(); ++i) differing += codes_[i] != bare[i] ? 1 : 0;
        return differing;
    };
    show(test::fractalMap(512, 256), "5");
    const int coarse = contours(15000.0), fine = contours(5000.0);
    EXPECT_GT(coarse, 100);
    EXPECT_GT(fine, 2 * coarse);
    show(test::constantMap(64, 32, 30500.0f), "5");
    EXPECT_EQ(contours(1000.0), 0) << "level ground has none";
}

TEST_F(DisplayTest, LevelGroundHasNoSlope) {
    show(test::constantMap(64, 32, 0.0f), "0");
    take(Show::Slope, true);
    EXPECT_EQ(at(128, 80).r, 0);
    EXPECT_GT(at(128, 80).b, 100);
    show(test::terraceMap(512, 256), "20");
    take(Show::Slope, true);
    EXPECT_GT(count(100, 156, [](const Code& colour) { return colour.r > 200; }), 20) << "cliffs are steep";
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(roundStep(1.0), 1.0);
    EXPECT_DOUBLE_EQ(roundStep(4.99), 2.0);
    EXPECT_DOUBLE_EQ(roundStep(7200.0), 5000.0);
    EXPECT_DOUBLE_EQ(roundStep(0.03), 0.02);
}

}  // namespace
}  // namespace dsphere::viewer
