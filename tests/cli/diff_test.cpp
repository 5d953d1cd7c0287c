// dsphere diff: what it prints, what it writes, what it exits with.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace dsphere::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class DiffTest : public CliTest {
  protected:
    /// An 8x4 picture of one grey, with a channel "t" of 3 besides.
    static Image grey(float value) {
        Image image;
        image.data = image.display = {0, 0, 8, 4};
        for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats().assign(32, value);
        image.addFloat("t").floats().assign(32, 3.0f);
        return image;
    }
    void exr(const std::string& name, const Image& image) const { writeExr(path(name), image, {}); }

    DiffTest() {
        exr("a.exr", grey(0.5f));
        exr("b.exr", grey(0.25f));
    }
};

TEST_F(DiffTest, EqualPictures) {
    Outcome outcome = run({"diff", "a.exr", "a.exr", "--threshold", "0", "--metric", "max"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "MAE    0\nRMSE   0\nPSNR   inf dB\nFLIP   0\n"));
    EXPECT_TRUE(holds(outcome.out, "the pictures are equal"));
    EXPECT_EQ(outcome.err, "");
}

TEST_F(DiffTest, JsonNamesTheWorstPixel) {
    Image image = grey(0.5f);
    image.channels[1].floats()[13] = 0.0f;
    exr("c.exr", image);
    Outcome outcome = run({"diff", "a.exr", "c.exr", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    auto json = nlohmann::json::parse(outcome.out);
    EXPECT_DOUBLE_EQ(json["mae"], 0.5 / 96);
    EXPECT_DOUBLE_EQ(json["max"], 0.5);
    EXPECT_GT(json["flip"], 0.0);
    EXPECT_EQ(json["worst"], nlohmann::json::parse(R"({"x":5,"y":1,"channel":"G","a":0.5,"b":0.0})"));
    EXPECT_FALSE(json.contains("within_threshold"));
}

TEST_F(DiffTest, ThresholdDecidesTheExitCode) {
    EXPECT_EQ(run({"diff", "a.exr", "b.exr", "--threshold", "0.25"}).code, 0);
    EXPECT_EQ(run({"diff", "a.exr", "b.exr", "--threshold", "0.2499"}).code, 5);
    for (const char* metric : {"mae", "rmse", "flip", "max"}) {
        EXPECT_EQ(run({"diff", "a.exr", "b.exr", "--metric", metric, "--threshold", "0.001"}).code, 5) << metric;
        EXPECT_EQ(run({"diff", "a.exr", "b.exr", "--metric", metric, "--threshold", "0.99"}).code, 0) << metric;
    }
}

TEST_F(DiffTest, PngAgainstExrIsComparedInLinearLight) {
    writePng(path("a.png"), grey(0.5f));
    Outcome outcome = run({"diff", "a.png", "a.exr", "--metric", "max", "--threshold", "0.004"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_EQ(run({"diff", "a.png", "a.png", "--metric", "max", "--threshold", "0"}).code, 0);
}

TEST_F(DiffTest, NaNInOneOnlyIsBeyondEveryThreshold) {
    Image image = grey(0.5f);
    image.channels[2].floats()[9] = kNaN;
    exr("nan.exr", image);
    for (const char* metric : {"mae", "rmse", "max"})
        EXPECT_EQ(run({"diff", "a.exr", "nan.exr", "--metric", metric, "--threshold", "1e30"}).code, 5) << metric;
    EXPECT_EQ(run({"diff", "a.exr", "nan.exr", "--metric", "flip", "--threshold", "0.001"}).code, 5);
    EXPECT_EQ(run({"diff", "nan.exr", "nan.exr", "--metric", "max", "--threshold", "0"}).code, 0);
    auto json = nlohmann::json::parse(run({"diff", "a.exr", "nan.exr", "--json"}).out);
    EXPECT_TRUE(json["mae"].is_null());
    EXPECT_EQ(json["worst"]["channel"], "B");
    EXPECT_EQ(json["non_finite"], 1);
}

TEST_F(DiffTest, OtherChannels) {
    Outcome outcome = run({"diff", "a.exr", "b.exr", "--channel", "t", "--threshold", "0"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("FLIP"), std::string::npos);
    expectFailure(run({"diff", "a.exr", "b.exr", "--channel", "N.X"}), 3, "a.exr: has no channel N.X; it has ");
}

TEST_F(DiffTest, WritesTheDifference) {
    EXPECT_EQ(run({"diff", "a.exr", "b.exr", "-o", "d.exr"}).code, 0);
    Image difference = readExr(path("d.exr"));
    EXPECT_EQ(difference.channels.size(), 3u);
    for (float value : difference.at("G").floats()) EXPECT_EQ(value, -0.25f);
    EXPECT_EQ(run({"diff", "a.exr", "a.exr", "-o", "d.png"}).code, 0);
    Image flips = readPngPicture(path("d.png"));  // viridis begins in dark blue
    EXPECT_GT(flips.at("B").floats()[0], flips.at("R").floats()[0]);
    EXPECT_GT(flips.at("R").floats()[0], flips.at("G").floats()[0]);
}

TEST_F(DiffTest, DifferentSizesAreNamed) {
    Image wide = grey(0.5f);
    wide.data = wide.display = {0, 0, 4, 8};
    exr("wide.exr", wide);
    expectFailure(run({"diff", "a.exr", "wide.exr"}), 3, "a.exr is 8x4, wide.exr is 4x8");
    Image moved = grey(0.5f);
    moved.data = {2, 1, 10, 5};
    moved.display = {0, 0, 12, 9};
    exr("moved.exr", moved);
    expectFailure(run({"diff", "a.exr", "moved.exr"}), 3, "8x4 at (2, 1)");
}

TEST_F(DiffTest, WrongUse) {
    expectFailure(run({"diff", "a.exr"}), 2, "b is required");
    expectFailure(run({"diff", "a.exr", "b.jpg"}), 2, "b.jpg");
    expectFailure(run({"diff", "a.exr", "b.exr", "--threshold", "-1"}), 2, "--threshold");
    expectFailure(run({"diff", "a.exr", "b.exr", "--threshold", "nan"}), 2, "--threshold");
    expectFailure(run({"diff", "a.exr", "b.exr", "--metric", "ssim"}), 2, "mae|rmse|flip|max");
    expectFailure(run({"diff", "a.exr", "b.exr", "--channel", "t", "--metric", "flip"}), 2, "--metric flip");
    expectFailure(run({"diff", "a.exr", "b.exr", "--channel", "t", "-o", "d.png"}), 2, "d.png");
    expectFailure(run({"diff", "a.exr", "b.exr", "-o", "d.jpg"}), 2, "d.jpg");
    expectFailure(run({"diff", "a.exr", "b.exr", "-o", "no/d.png"}), 1, "no");
    expectFailure(run({"diff", "a.exr", "missing.exr"}), 3, "missing.exr");
}

}  // namespace
}  // namespace dsphere::test
