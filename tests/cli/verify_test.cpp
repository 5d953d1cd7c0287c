#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace dsphere::test {
namespace {

using nlohmann::json;

class VerifyTest : public CliTest {
  protected:
    /// The map's needles at 40 %: steps of |p| - r jump through them.
    void makeSteep() {
        writePgm16(path("map.pgm"), spikeMap(64, 32));
        folder_.write("planet.pbrt", planet("\"float maxdispl\" 40"));
    }
};

TEST_F(VerifyTest, TheContractHolds) {
    Outcome outcome = run({"verify", "planet.pbrt"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"wrong verdicts", "later roots", "wrong shadows", "The contract holds."})
        EXPECT_TRUE(holds(outcome.out, part));
    EXPECT_EQ(folder_.entries(), 2u) << "pictures are for failures";
}

TEST_F(VerifyTest, Json) {
    Outcome outcome = run({"verify", "planet.pbrt", "--json", "--validation"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json report = json::parse(outcome.out);
    EXPECT_EQ(report.at("scene"), "planet.pbrt");
    EXPECT_EQ(report.at("rays").get<int>(), kWidth * kHeight);
    EXPECT_EQ(report.at("wrong_verdicts").get<int>(), 0);
    EXPECT_EQ(report.at("later_roots").get<int>(), 0);
    EXPECT_TRUE(report.at("passed").get<bool>());
}

TEST_F(VerifyTest, SampleOfThePixels) {
    json report = json::parse(run({"verify", "planet.pbrt", "--json", "--sample", "100"}).out);
    EXPECT_EQ(report.at("rays").get<int>(), 100);
}

TEST_F(VerifyTest, TheNaiveMarcherFailsAndLeavesItsPictures) {
    makeSteep();
    Outcome outcome = run({"verify", "planet.pbrt", "--marcher", "naive", "-o", "evidence"});
    EXPECT_EQ(outcome.code, 5) << outcome.out << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "The contract is broken:"));
    EXPECT_TRUE(holds(outcome.err, "pixel "));
    Image device = readExr(path("evidence-device.exr")), reference = readExr(path("evidence-reference.exr"));
    Image difference = readExr(path("evidence-difference.exr"));
    EXPECT_EQ(device.data, (Box{0, 0, kWidth, kHeight}));
    EXPECT_EQ(reference.data, device.data);
    EXPECT_NE(reference.at("id").floats(), device.at("id").floats());
    EXPECT_TRUE(std::ranges::any_of(difference.at("t").floats(), [](float value) { return value != 0.0f; }));
}

TEST_F(VerifyTest, FailureAsJson) {
    makeSteep();
    Outcome outcome = run({"verify", "planet.pbrt", "--marcher", "naive", "--json", "--quiet"});
    EXPECT_EQ(outcome.code, 5);
    EXPECT_EQ(outcome.err, "");
    EXPECT_FALSE(json::parse(outcome.out).at("passed").get<bool>());
    EXPECT_TRUE(exists("dsphere-verify-device.exr"));
}

TEST_F(VerifyTest, TheExactMarcherPassesTheSame) {
    makeSteep();
    EXPECT_EQ(run({"verify", "planet.pbrt"}).code, 0);
}

}  // namespace
}  // namespace dsphere::test
