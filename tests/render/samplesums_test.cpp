// Pictures that go on where an earlier one stopped.

#include "tests/render/world.h"
#include "tests/support/expecterror.h"

#include <random>

namespace dsphere::test {
namespace {

SampleSums randomSums(int samples) {
    SampleSums sums{samples, {{0, 0, 31, 7}, {0, 0, 40, 9}, {}}};
    std::mt19937 random(samples);
    for (const char* name : {"R", "G", "B", "A"})
        for (float& value : sums.sums.addFloat(name).floats()) value = float(random()) * 1e-6f;
    return sums;
}

TEST(SampleSums, ComeBackBitForBit) {
    for (int samples : {1, 2, 3, 7, 64, 100, 65535, 65536}) {
        const SampleSums sums = randomSums(samples);
        const Image picture = pictureOf(sums);
        EXPECT_EQ(picture.at("G").floats()[5], sums.sums.at("G").floats()[5] / float(samples));
        const bool power = (samples & (samples - 1)) == 0;
        EXPECT_EQ(picture.channels.size(), power ? 4u : 8u) << samples;
        const SampleSums again = sumsOf(picture, samples);
        EXPECT_EQ(again.samples, samples);
        EXPECT_EQ(again.sums.data, sums.sums.data);
        for (const Channel& channel : sums.sums.channels)
            EXPECT_EQ(channel.floats(), again.sums.at(channel.name).floats()) << samples;
    }
}

TEST(SampleSums, NeedTheirChannels) {
    Image picture = pictureOf(randomSums(3));
    expectError(ExitCode::InvalidInput, "no channel sum.R, which 5 samples take", [&] {
        Image means = picture;
        means.channels.resize(4);
        sumsOf(means, 5);
    });
    picture.channels.erase(picture.channels.begin() + 1);
    expectError(ExitCode::InvalidInput, "no channel G", [&] { sumsOf(picture, 4); });
}

TEST(SampleSums, PicturesWithoutAlphaHaveNoneOfItsSums) {
    Image picture = pictureOf(randomSums(4));
    picture.channels.erase(picture.channels.begin() + 3);
    EXPECT_EQ(sumsOf(picture, 4).sums.channels.size(), 3u);
}

class GoingOn : public WorldTest {
  protected:
    gpu::Device device_{{"", true}};
};

TEST_F(GoingOn, GivesThePictureOfOneRender) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    const Image whole = renderer.renderColour(5, 9, {});
    SampleSums sums = renderer.renderSums({}, 2, 9, {});
    sums = sumsOf(pictureOf(std::move(sums)), 2);
    sums = renderer.renderSums(std::move(sums), 3, 9, {});
    sums = sumsOf(pictureOf(std::move(sums)), 3);
    const Image parts = pictureOf(renderer.renderSums(std::move(sums), 5, 9, {}));
    for (const Channel& channel : whole.channels)
        EXPECT_EQ(channel.floats(), parts.at(channel.name).floats()) << channel.name;
}

TEST_F(GoingOn, StopsAfterAWholeSample) {
    World made = world(planet());
    Renderer renderer(device_, made.packed, made.scene, Marcher::Exact);
    int calls = 0;
    SampleSums sums = renderer.renderSums({}, 9, 9, [&](double) { return ++calls < 2; });
    EXPECT_EQ(calls, 2) << "who stops it is not asked again";
    EXPECT_GE(sums.samples, 1);
    EXPECT_LE(sums.samples, 2);
    const Image stopped = pictureOf(sums), whole = renderer.renderColour(sums.samples, 9, {});
    EXPECT_EQ(stopped.at("R").floats(), whole.at("R").floats());
}

}  // namespace
}  // namespace dsphere::test
