// Pictures that go on where an earlier one stopped.

#include "render/progressivefilm.h"
#include "render/shards.h"
#include "tests/render/world.h"
#include "tests/support/expecterror.h"

#include <random>

namespace dsphere::test {
namespace {

// Sums of random samples, one after another.
SampleSums randomSums(int first, int last) {
    SampleSums sums;
    for (int sample = first; sample < last; ++sample) {
        std::mt19937 random{unsigned(sample)};
        SumPart part{sample, sample + 1, {{0, 0, 31, 7}, {0, 0, 40, 9}, {}}};
        for (const char* name : {"R", "G", "B", "A"})
            for (float& value : part.sums.addFloat(name).floats()) value = float(random()) * 1e-6f;
        sums.append(std::move(part));
    }
    return sums;
}

std::vector<std::pair<int, int>> rangesOf(const SampleSums& sums) {
    std::vector<std::pair<int, int>> ranges;
    for (const SumPart& part : sums.parts()) ranges.emplace_back(part.first, part.last);
    return ranges;
}

void expectSame(const SampleSums& a, const SampleSums& b) {
    ASSERT_EQ(rangesOf(a), rangesOf(b));
    for (std::size_t i = 0; i < a.parts().size(); ++i)
        for (const Channel& channel : a.parts()[i].sums.channels)
            EXPECT_EQ(channel.floats(), b.parts()[i].sums.at(channel.name).floats());
}

TEST(SampleSums, AreAsFewAsTheirRangeAllows) {
    using Ranges = std::vector<std::pair<int, int>>;
    EXPECT_EQ(rangesOf(randomSums(0, 5)), (Ranges{{0, 5}}));
    EXPECT_EQ(rangesOf(randomSums(0, 64)), (Ranges{{0, 64}}));
    EXPECT_EQ(rangesOf(randomSums(0, 100)), (Ranges{{0, 64}, {64, 96}, {96, 100}}));
    EXPECT_EQ(rangesOf(randomSums(16, 64)), (Ranges{{16, 32}, {32, 64}}));
    EXPECT_EQ(rangesOf(randomSums(13, 18)), (Ranges{{13, 14}, {14, 15}, {15, 16}, {16, 18}}));
}

TEST(SampleSums, DoNotDependOnHowTheyAreCut) {
    const SampleSums whole = randomSums(0, 100);
    for (const std::vector<int>& cuts :
         {std::vector{0, 16, 64, 100}, std::vector{0, 1, 2, 3, 50, 51, 99, 100}, std::vector{0, 33, 66, 100}}) {
        SampleSums merged;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            merged.append(sumsOf(pictureOf(randomSums(cuts[i], cuts[i + 1])), cuts[i], cuts[i + 1]));
        expectSame(whole, merged);
    }
}

TEST(SampleSums, ComeBackBitForBit) {
    for (int samples : {1, 2, 3, 7, 16, 24, 64, 100}) {
        const SampleSums sums = randomSums(0, samples);
        const Image picture = pictureOf(sums);
        EXPECT_EQ(picture.at("G").floats()[5], sums.total().at("G").floats()[5] / float(samples));
        const bool power = (samples & (samples - 1)) == 0;
        EXPECT_EQ(picture.channels.size(), power ? 4u : 4 + 4 * sums.parts().size()) << samples;
        expectSame(sums, sumsOf(picture, 0, samples));
    }
}

TEST(SampleSums, NeedTheirChannels) {
    Image picture = pictureOf(randomSums(0, 3));
    const Image means{picture.data, picture.display, {picture.channels.begin(), picture.channels.begin() + 4}};
    expectError(ExitCode::InvalidInput, "no channel sum.0-5.R, which samples 0 to 4 take",
                [&] { sumsOf(means, 0, 5); });
    expectError(ExitCode::InvalidInput, "lacks the sums of samples 3 to 4", [&] { sumsOf(picture, 0, 5); });
    expectError(ExitCode::InvalidInput, "lacks the sums of samples -2 to -1", [&] { sumsOf(picture, -2, 3); });
    picture.channels.erase(picture.channels.begin() + 5);
    expectError(ExitCode::InvalidInput, "no channel sum.0-3.G", [&] { sumsOf(picture, 0, 3); });
}

class GoingOn : public WorldTest {
  protected:
    gpu::Device device_{{"", true}};
};

TEST_F(GoingOn, GivesThePictureOfOneRender) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    const Image whole = renderer.renderColour(5, 9, {});
    SampleSums sums = renderer.renderSums({}, 0, 2, 9, {});
    sums = sumsOf(pictureOf(sums), 0, 2);
    sums = renderer.renderSums(std::move(sums), 0, 3, 9, {});
    sums = sumsOf(pictureOf(sums), 0, 3);
    const Image parts = pictureOf(renderer.renderSums(std::move(sums), 0, 5, 9, {}));
    for (const Channel& channel : whole.channels)
        EXPECT_EQ(channel.floats(), parts.at(channel.name).floats()) << channel.name;
}

TEST_F(GoingOn, StopsAfterAWholeSample) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    int calls = 0;
    SampleSums sums = renderer.renderSums({}, 0, 9, 9, [&](double) { return ++calls < 2; });
    EXPECT_EQ(calls, 2) << "who stops it is not asked again";
    EXPECT_GE(sums.samples(), 1);
    EXPECT_LE(sums.samples(), 2);
    const Image stopped = pictureOf(sums), whole = renderer.renderColour(sums.samples(), 9, {});
    EXPECT_EQ(stopped.at("R").floats(), whole.at("R").floats());
}

// Ranges within blocks, of whole blocks and of tiles, against one render; and the film that a window shows.
TEST_F(GoingOn, RangesAndTilesMakeThePictureOfOneRender) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    const SampleSums whole = renderer.renderSums({}, 0, 41, 9, {});
    const Image all = whole.total();
    const Box picture = renderer.crop();
    for (int tile = 1; tile <= 3; ++tile) {
        renderer.setCrop(tileBox(picture, tile, 3));
        SampleSums merged;
        for (const auto& [first, last] : {std::pair(0, 5), std::pair(5, 20), std::pair(20, 41)})
            merged.append(renderer.renderSums({}, first, last, 9, {}));
        const Image part = merged.total();
        for (const Channel& channel : part.channels)
            for (int y = part.data.y0; y < part.data.y1; ++y)
                for (int x = part.data.x0; x < part.data.x1; ++x)
                    ASSERT_EQ(channel.floats()[std::size_t((y - part.data.y0) * part.data.width() + x - part.data.x0)],
                              all.at(channel.name).floats()[std::size_t(y * picture.width() + x)])
                        << channel.name << ' ' << x << ' ' << y;
    }
    renderer.setCrop(picture);
    ProgressiveFilm live(device_, renderer, kWidth, kHeight, kColourPlanes);
    live.begin({{Marcher::Exact, 0, kWidth}}, Sampling::Jittered, 9);
    for (int samples = 0; samples < 41;) samples += live.step(1.0);
    const Image shown = live.read(), mean = pictureOf(whole);
    for (const Channel& channel : shown.channels) EXPECT_EQ(channel.floats(), mean.at(channel.name).floats());
}

TEST(Shards, TilesMakeThePictureWithoutOverlap) {
    for (const Box& picture : {Box{0, 0, 1280, 720}, Box{3, 5, 10, 8}, Box{0, 0, 1, 500}, Box{100, 0, 1000, 1000}})
        for (int tiles : {1, 2, 3, 7, 16, 21}) {
            std::vector<int> hits(std::size_t(picture.width() * picture.height()));
            for (int tile = 1; tile <= tiles; ++tile) {
                const Box box = tileBox(picture, tile, tiles);
                for (int y = box.y0; y < box.y1; ++y)
                    for (int x = box.x0; x < box.x1; ++x)
                        ++hits.at(std::size_t((y - picture.y0) * picture.width() + x - picture.x0));
                if (picture.width() < 900) continue;
                EXPECT_TRUE(isAligned(box, picture));
            }
            for (int hit : hits) ASSERT_EQ(hit, 1) << tiles;
        }
}

// Whole workgroups of 64 columns make small tiles unequal, and hardly any difference to large ones.
TEST(Shards, TilesAreOfNearlyEqualAreas) {
    for (const auto& [picture, most] :
         {std::pair(Box{0, 0, 1280, 720}, 0.3), std::pair(Box{0, 0, 100000, 50000}, 0.02)})
        for (int tiles : {2, 3, 7, 16, 21, 64})
            for (int tile = 1; tile <= tiles; ++tile) {
                const Box box = tileBox(picture, tile, tiles);
                const double whole = double(picture.width()) * picture.height();
                EXPECT_NEAR(double(box.width()) * box.height() * tiles / whole, 1.0, most) << tile << '/' << tiles;
            }
}

}  // namespace
}  // namespace dsphere::test
