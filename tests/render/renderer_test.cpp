#include "render/progressivefilm.h"
#include "tests/render/world.h"
#include "tests/support/keepdriver.h"

#include <cmath>

namespace dsphere::test {
namespace {

class RendererTest : public WorldTest {
  protected:
    void TearDown() override {
        for (const std::string& message : device_.validationMessages()) ADD_FAILURE() << message;
    }

    gpu::Device device_{{"", true}};
};

/// Every channel of `cut` holds what `picture` does there, bit for bit.
void expectPart(const Image& cut, const Image& picture) {
    for (std::size_t c = 0; c < cut.channels.size(); ++c)
        for (int y = cut.data.y0; y < cut.data.y1; ++y)
            for (int x = cut.data.x0; x < cut.data.x1; ++x) {
                const auto placeIn = [&](const Image& image) {
                    return std::size_t(y - image.data.y0) * std::size_t(image.data.width()) +
                           std::size_t(x - image.data.x0);
                };
                const std::size_t i = placeIn(cut), k = placeIn(picture);
                const Channel &part = cut.channels[c], &whole = picture.channels[c];
                if (part.isFloat())
                    ASSERT_EQ(part.floats()[i], whole.floats()[k]) << part.name << " at " << x << ' ' << y;
                else
                    ASSERT_EQ(part.uints()[i], whole.uints()[k]) << part.name << " at " << x << ' ' << y;
            }
}

TEST_F(RendererTest, CropsArePartsOfTheWhole) {
    World whole = world(planet());
    Image picture = Renderer(device_, whole.packed, whole.scene, Marcher::Exact).renderPlanes(kVerifyPlanes, {});
    EXPECT_EQ(picture.channels.size(), std::size_t(PLANE_COUNT - 1)) << "all but A";
    for (std::array<double, 4> crop :
         {std::array{0.3, 0.8, 0.2, 0.9}, std::array{0.0, 0.02, 0.0, 0.03}, std::array{0.5, 0.51, 0.0, 1.0}}) {
        World part = world(planet());
        part.scene.film.crop = crop;
        Image cut = Renderer(device_, part.packed, part.scene, Marcher::Exact).renderPlanes(kVerifyPlanes, {});
        EXPECT_EQ(cut.display, (Box{0, 0, kWidth, kHeight}));
        ASSERT_EQ(cut.data, cropBox(part.scene.film));
        ASSERT_NO_FATAL_FAILURE(expectPart(cut, picture));
    }
}

// In a crop of eight columns an invocation has one pixel, in the whole picture up to eight: paths are the same. Live
// pictures in the smallest slices are cut into parts of tiles.
TEST_F(RendererTest, PathsDoNotDependOnTurns) {
    const std::string objects = "Material \"matte\" \"rgb Kd\" [.9 .9 .9] \"float sigma\" 20\n" + planet() +
                                "Material \"conductor\"\nTranslate 1.1 0 .4\nShape \"sphere\" \"float radius\" .4\n";
    World whole = world(objects);
    whole.scene.film.width = 131;
    ASSERT_TRUE(whole.packed.traits.needsPaths());
    Renderer renderer(device_, whole.packed, whole.scene, Marcher::Exact);
    const Image picture = renderer.renderColour(3, 5, {});
    for (int first : {0, 40, 96, 128}) {
        World part = world(objects);
        part.scene.film.width = 131;
        part.scene.film.crop = {first / 131.0, std::min(first + 8, 131) / 131.0, 0.0, 1.0};
        const Image cut = Renderer(device_, part.packed, part.scene, Marcher::Exact).renderColour(3, 5, {});
        ASSERT_LE(cut.data.width(), 8);
        ASSERT_EQ(cut.channels.size(), 3u);
        ASSERT_NO_FATAL_FAILURE(expectPart(cut, picture));
    }
    ProgressiveFilm live(device_, renderer, 131, kHeight, kColourPlanes);
    live.begin({{Marcher::Exact, 0, 131}}, Sampling::Jittered, 5);
    for (int samples = 1; samples <= 3;) samples += live.step(1e-9);
    const Image grown = live.read();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(grown.channels[c].floats(), picture.channels[c].floats());
}

// All loops of an invocation share one limit, so few turns where one pixel's are long; baselines have no second pass.
TEST_F(RendererTest, TurnsAreFewWhereLoopsAreLong) {
    SceneTraits traits = world("Material \"conductor\"\n" + planet()).packed.traits;
    ASSERT_TRUE(traits.needsPaths());
    const int most = turnsOf(device_, traits, Marcher::Exact);
    EXPECT_EQ(turnsOf(device_, traits, Marcher::Naive), 1);
    EXPECT_EQ(turnsOf(device_, traits, Marcher::Lipschitz), 1);
    if (device_.info().type != "CPU") {
        EXPECT_EQ(most, 1);
        return;
    }
    EXPECT_LE(most, 8);
    traits.triangles = MAX_TRIANGLES;
    traits.paths.max_depth = 8;
    EXPECT_EQ(turnsOf(device_, traits, Marcher::Exact), 1);
    traits.triangles = 0;
    traits.objects = MAX_OBJECTS;
    EXPECT_LE(turnsOf(device_, traits, Marcher::Exact), most);
    traits.paths.max_depth = MAX_DEPTH;
    traits.lights = MAX_LIGHTS;
    EXPECT_EQ(turnsOf(device_, traits, Marcher::Exact), 1);
}

// Rows far below, beside and between the objects are never dispatched.
TEST_F(RendererTest, UndispatchedPixelsAreMisses) {
    World made = world("Translate -1 .6 0\nShape \"sphere\" \"float radius\" .3\n");
    Image image = Renderer(device_, made.packed, made.scene, Marcher::Exact).renderPlanes(kAovPlanes, {});
    int misses = 0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        bool miss = image.at("id").uints()[i] == 0;
        ASSERT_EQ(std::isinf(image.at("t").floats()[i]), miss) << "pixel " << i;
        misses += miss;
    }
    EXPECT_GT(misses, kWidth * kHeight / 2);
    EXPECT_LT(misses, kWidth * kHeight);
}

// A ramp needs the map's value under the hit from every marcher.
TEST_F(RendererTest, BaselinesAreColouredByHeightToo) {
    World made =
        world("Texture \"h\" \"spectrum\" \"heightramp\"\nMaterial \"matte\" \"texture Kd\" \"h\"\n" + planet());
    Image exact = Renderer(device_, made.packed, made.scene, Marcher::Exact).renderPlanes(kAovPlanes, {});
    for (Marcher marcher : {Marcher::Naive, Marcher::NaiveShell, Marcher::Lipschitz}) {
        Image image = Renderer(device_, made.packed, made.scene, marcher).renderPlanes(kAovPlanes, {});
        int close = 0, hits = 0;
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            if (!image.at("id").uints()[i] || !exact.at("id").uints()[i]) continue;
            ++hits;
            close += std::abs(image.at("Albedo.G").floats()[i] - exact.at("Albedo.G").floats()[i]) < 0.02f;
        }
        EXPECT_GT(hits, 100);
        EXPECT_GT(close, 0.95 * hits) << int(marcher);
    }
}

// Sample i of a growing picture is sample i of a render, whatever the number of samples, slices and tiles.
// What a pipeline was made without, such as ramps, is there once another packing needs it.
TEST_F(RendererTest, APackingOfOtherTraitsIsDrawnAsIfItWereTheFirst) {
    const World plain = world(planet());
    const World ramped = world(
        "Texture \"by height\" \"spectrum\" \"heightramp\" \"string ramp\" \"viridis\"\n"
        "Material \"matte\" \"texture Kd\" \"by height\"\n" +
        planet());
    ASSERT_NE(plain.packed.traits, ramped.packed.traits);
    Renderer renderer(device_, plain.packed, plain.scene, Marcher::Exact);
    const Image grey = renderer.renderColour(1, 0, {});
    for (const World* next : {&ramped, &plain}) {
        renderer.setPacking(next->packed);
        renderer.setCamera(next->scene);
        const Image fresh = Renderer(device_, next->packed, next->scene, Marcher::Exact).renderColour(1, 0, {});
        ASSERT_NO_FATAL_FAILURE(expectPart(renderer.renderColour(1, 0, {}), fresh));
        EXPECT_EQ(fresh.at("R").floats() == grey.at("R").floats(), next == &plain);
    }
}

TEST_F(RendererTest, LivePicturesEqualRenders) {
    World made = world(planet() + "Translate 1.3 0 0\nShape \"sphere\" \"float radius\" .2\n");
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    ProgressiveFilm live(device_, renderer, kWidth + 9, kHeight + 5, kColourPlanes);
    live.begin({{Marcher::Exact, 0, 31}, {Marcher::Exact, 31, kWidth}}, Sampling::Jittered, 5);
    for (int samples = 1; samples <= 3; ++samples) {
        while (!live.step(1e-9)) EXPECT_LT(live.samples(), samples);
        EXPECT_EQ(live.samples(), samples);
        Image image = live.read(), render = renderer.renderColour(samples, 5, {});
        ASSERT_EQ(image.data, render.data);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(image.channels[c].floats(), render.channels[c].floats()) << samples;
    }
    MarchMethod unshadowed;
    unshadowed.shadows = false;
    live.begin({{unshadowed, 0, kWidth}}, Sampling::Centres, 5);
    while (!live.step(1.0)) {
    }
    Image bright = live.read();
    live.begin({{Marcher::Exact, 0, kWidth}}, Sampling::Centres, 5);
    while (!live.step(1.0)) {
    }
    Image image = live.read();
    // Without shadow rays light fades at the horizon, where what is lit is dim.
    constexpr float kDim = 0.05f;
    int lit = 0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        const float shadowed = image.at("R").floats()[i], faded = bright.at("R").floats()[i];
        if (shadowed <= kDim) continue;
        EXPECT_EQ(faded, shadowed);
        ++lit;
    }
    EXPECT_GT(lit, 100);
}

TEST_F(RendererTest, ColourIsTheMeanOfItsSamples) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    Image few = renderer.renderColour(2, 5, {}), many = renderer.renderColour(64, 5, {});
    double sums[2] = {};
    for (std::size_t i = 0; i < few.pixelCount(); ++i) {
        sums[0] += few.at("R").floats()[i];
        sums[1] += many.at("R").floats()[i];
    }
    EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.02);
    EXPECT_EQ(renderer.stats().camera_rays, 66u * kWidth * kHeight);
    EXPECT_GT(renderer.stats().device_seconds, 0.0);
}

// Submissions grow while they are quick: at one tile a sample the growth must have an end.
TEST_F(RendererTest, ManySamplesOfATinyPicture) {
    World made = world(planet());
    made.scene.film.crop = {0.5, 0.52, 0.5, 0.52};
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    int calls = 0;
    // A render that does not get on is stopped rather than waited for.
    renderer.renderColour(200, 0, [&](double) { return ++calls <= 1000; });
    EXPECT_LE(calls, 1000);
}

TEST_F(RendererTest, ProgressGrowsToOne) {
    World made = world(planet());
    std::vector<double> shares;
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    renderer.renderColour(3, 0, [&](double share) {
        shares.push_back(share);
        return true;
    });
    ASSERT_GE(shares.size(), 3u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.front(), 0.0);
    EXPECT_DOUBLE_EQ(shares.back(), 1.0);
}

TEST_F(RendererTest, StopsWhenProgressSaysSo) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    for (int last : {1, 2}) {
        int calls = 0;
        auto stop = [&](double) { return ++calls < last; };
        try {
            renderer.renderColour(10, 0, stop);
            ADD_FAILURE() << "was not stopped";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::Interrupted);
        }
        EXPECT_EQ(calls, last);
    }
    EXPECT_EQ(renderer.renderColour(1, 0, {}).channels.size(), 3u) << "it can be used again";
}

}  // namespace
}  // namespace dsphere::test
