#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readPfmOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.pfm", bytes));
}

std::string refusalOf(const std::string& bytes) {
    return messageOf(ExitCode::InvalidInput, [&] { readPfmOf(bytes); });
}

TEST(Pfm, KeepsFloatsInBothByteOrders) {
    const std::vector<float> samples = floatRamp(64 * 32);
    for (const bool little : {false, true}) {
        const RawMap map = readPfmOf(pfmFile(64, 32, samples, little));
        EXPECT_EQ(map.width, 64);
        EXPECT_EQ(map.height, 32);
        EXPECT_EQ(map.full_scale, 1.0);
        EXPECT_EQ(map.type, "float32 PFM");
        EXPECT_EQ(map.samples, samples);
    }
}

TEST(Pfm, AveragesColour) {
    const RawMap map = readPfmOf(pfmFile(1, 2, {0.1f, 0.2f, 0.4f, 0.7f, 0.7f, 0.7f}, true));
    EXPECT_EQ(map.samples, (std::vector<float>{float((double(0.1f) + double(0.2f) + double(0.4f)) / 3.0), 0.7f}));
}

TEST(Pfm, LeavesNonFiniteSamplesToTheHeightmap) {
    const float infinity = std::numeric_limits<float>::infinity();
    const RawMap map = readPfmOf(pfmFile(2, 1, {std::nanf(""), -infinity}, true));
    EXPECT_TRUE(std::isnan(map.samples[0]));
    EXPECT_EQ(map.samples[1], -infinity);
}

TEST(Pfm, TakesTheScaleForItsSignAlone) {
    const std::string value = floatBytes(2.5f, false);
    EXPECT_EQ(readPfmOf("Pf 1 1 +0.25\n" + value).samples, (std::vector<float>{2.5f}));
    EXPECT_EQ(readPfmOf("Pf\n1\n1\n1e3 " + value + "more").samples, (std::vector<float>{2.5f}));
}

TEST(Pfm, RefusesMalformedHeaders) {
    const std::string value = floatBytes(2.5f, false);
    for (const std::string scale : {"nan", "inf", "-inf", "0", "-0.0", "one", "1.0x", "1e999", "+", "-"})
        EXPECT_TRUE(holds(refusalOf("Pf 1 1 " + scale + "\n" + value), "PFM: the scale is \"" + scale));
    EXPECT_TRUE(holds(refusalOf("Pf 0 1 1\n" + value), "0x1"));
    EXPECT_TRUE(holds(refusalOf("Pf 1 -1 1\n" + value), "\"-1\""));
    EXPECT_TRUE(holds(refusalOf("PF 1048576 2048 1\n" + value), "25769803776 bytes expected"));
    EXPECT_TRUE(holds(refusalOf("Pf 1048577 1 1\n" + value), "1048577x1"));
    EXPECT_TRUE(holds(refusalOf("Pfx 1 1 1\n" + value), "\"Pfx\""));
}

}  // namespace
}  // namespace dsphere::test
