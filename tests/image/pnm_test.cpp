#include <gtest/gtest.h>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readPnmOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.pgm", bytes));
}

std::string pnmRefusal(const std::string& bytes) {
    return messageOf(ExitCode::InvalidInput, [&] { readPnmOf(bytes); });
}

TEST(Pnm, KeepsEveryValueOf16Bits) {
    const RawMap map = readPnmOf(pnmFile(256, 256, 65535, ramp(65536)));
    EXPECT_EQ(map.width, 256);
    EXPECT_EQ(map.height, 256);
    EXPECT_EQ(map.full_scale, 65535.0);
    EXPECT_EQ(map.type, "16-bit PGM");
    for (std::size_t k = 0; k < 65536; ++k) ASSERT_EQ(map.samples[k], float(k));
}

TEST(Pnm, KeepsEveryValueOf8Bits) {
    const RawMap map = readPnmOf(pnmFile(32, 8, 255, ramp(256)));
    EXPECT_EQ(map.full_scale, 255.0);
    EXPECT_EQ(map.type, "8-bit PGM");
    for (std::size_t k = 0; k < 256; ++k) ASSERT_EQ(map.samples[k], float(k));
}

TEST(Pnm, MaxvalIsTheFullScale) {
    const RawMap map = readPnmOf(pnmFile(2, 1, 1000, {1, 1000}));
    EXPECT_EQ(map.full_scale, 1000.0);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 1000}));
    EXPECT_EQ(readPnmOf(pnmFile(2, 1, 1, {0, 1})).full_scale, 1.0);
    EXPECT_TRUE(holds(pnmRefusal(pnmFile(2, 2, 1000, {1, 2, 3, 1001})), "column 1, row 1 is over the maxval of 1000"));
}

TEST(Pnm, AveragesColourInFloat) {
    EXPECT_EQ(readPnmOf(pnmFile(2, 1, 255, {1, 2, 4, 7, 7, 7})).samples, (std::vector<float>{float(7.0 / 3.0), 7}));
    const RawMap wide = readPnmOf(pnmFile(1, 2, 65535, {65535, 65534, 65535, 300, 300, 300}));
    EXPECT_EQ(wide.samples, (std::vector<float>{float(196604.0 / 3.0), 300}));
    EXPECT_EQ(wide.type, "16-bit PPM");
}

TEST(Pnm, ReadsPlainText) {
    EXPECT_EQ(readPnmOf("P2 3 2 65535\n0 1 2\n3 4\t65535").samples, (std::vector<float>{0, 1, 2, 3, 4, 65535}));
    EXPECT_EQ(readPnmOf("P2\n2 1\n9\n1#one\n# two\n2\n").samples, (std::vector<float>{1, 2}));
    EXPECT_EQ(readPnmOf("P3 2 1 255 1 2 4 5 5 5\n").samples, (std::vector<float>{float(7.0 / 3.0), 5}));
    EXPECT_TRUE(holds(pnmRefusal("P2 2 1 9 1 10\n"), "column 1, row 0 is over the maxval of 9"));
    EXPECT_TRUE(holds(pnmRefusal("P2 2 1 9 1 -1\n"), "\"-1\""));
    EXPECT_TRUE(holds(pnmRefusal("P2 2 1 9 1 1.5\n"), "\"1.5\""));
    EXPECT_TRUE(holds(pnmRefusal("P2 2 1 9 1     \n"), "truncated"));
    EXPECT_TRUE(holds(pnmRefusal("P2 2 1 9 1 99999999999999999999999\n"), "whole number"));
}

TEST(Pnm, HeaderMayHoldComments) {
    EXPECT_EQ(readPnmOf("P5 # a map\r\n#\n2# wide\n 1\n255\nAB").samples, (std::vector<float>{65, 66}));
    // netpbm: a comment right behind maxval ends with the header, a '#' one byte later is data.
    EXPECT_EQ(readPnmOf("P5 2 1 255# end\nAB").samples, (std::vector<float>{65, 66}));
    EXPECT_EQ(readPnmOf("P5 2 1 255\n#B").samples, (std::vector<float>{35, 66}));
}

TEST(Pnm, GeoidsSayWhatTheyMean) {
    const std::string header = "P5\n# Geoid file in PGM format\n# Offset -108\r\n# Scale 0.003\n# Origin 90N 180W\n";
    const RawMap map = readPnmOf(header + "# AREA_OR_POINT Point\n2 1\n65535\nAABB");
    EXPECT_EQ(map.samples, (std::vector<float>{0x4141, 0x4242})) << "as stored";
    EXPECT_EQ(map.facts.value_offset, -108.0);
    EXPECT_EQ(map.facts.value_scale, 0.003);
    EXPECT_EQ(map.facts.unit, "m");
    EXPECT_EQ(map.longitude_origin, -180.0);
    EXPECT_TRUE(map.gridline);
    EXPECT_TRUE(holds(map.notices.at(0).text,
                      "by its comments, heights in metres are -108 + 0.003 x the stored values, "
                      "the longitude origin is -180 and the registration gridline"));
    const RawMap area = readPnmOf("P2 # Scale 2\n1 #Offset 0\n1\n# AREA_OR_POINT Area\n9 5");
    EXPECT_EQ(area.facts.value_scale, 2.0);
    EXPECT_FALSE(area.gridline);
    EXPECT_FALSE(area.longitude_origin);
}

TEST(Pnm, OtherCommentsSayNothing) {
    for (const char* comment : {"# Scale 2\n", "# Offset 2\n# Scale of the map\n", "# Offset nan\n# Scale 1\n",
                                "# Offset 1\n# Scale 0\n", "# Origin 90S 0E\n"}) {
        const RawMap map = readPnmOf("P2\n" + std::string(comment) + "1 1 9 5");
        EXPECT_FALSE(map.facts.value_scale) << comment;
        EXPECT_TRUE(map.notices.empty());
    }
    for (const std::string origin : {"90S 0E", "0E 90N", "90N", "90N 0", "north"})
        EXPECT_TRUE(holds(pnmRefusal("P2\n# Offset 0\n# Scale 1\n# Origin " + origin + "\n1 1 9 5"),
                          "the origin is \"" + origin + "\", expected"));
}

TEST(Pnm, IgnoresWhatFollowsTheRaster) {
    EXPECT_EQ(readPnmOf("P5 2 1 255\nABmore").samples, (std::vector<float>{65, 66}));
    EXPECT_EQ(readPnmOf("P2 2 1 255\n1 2 more").samples, (std::vector<float>{1, 2}));
}

TEST(Pnm, RefusesMalformedHeaders) {
    EXPECT_TRUE(holds(pnmRefusal("P5 0 1 255\n"), "0x1"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 0 255\n"), "1x0"));
    EXPECT_TRUE(holds(pnmRefusal("P5 -1 1 255\nA"), "\"-1\""));
    EXPECT_TRUE(holds(pnmRefusal("P5 1048577 1 255\nA"), "1048577x1"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1048576 4096 255\nA"), "texels"));
    EXPECT_TRUE(holds(pnmRefusal("P6 1048576 2048 65535\nA"), "12884901888 bytes"));
    EXPECT_TRUE(holds(pnmRefusal("P2 1048576 2048 255\n1 "), "4294967295 bytes"));
    EXPECT_TRUE(holds(pnmRefusal("P5 9223372036854775807 9223372036854775807 255\nA"), "at most"));
    EXPECT_TRUE(holds(pnmRefusal("P5 99999999999999999999 1 255\nA"), "whole number"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 1 0\nA"), "maxval is 0"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 1 65536\nAB"), "maxval is 65536"));
    EXPECT_TRUE(holds(pnmRefusal("P5 2 two 255\nAB"), "\"two\""));
    EXPECT_TRUE(holds(pnmRefusal("P55 1 1 255\nA"), "\"P55\""));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 1 " + std::string(1000, '1') + "\nA"), "expected the maxval"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 1 \x01\x02\nA"), "expected the maxval"));
    EXPECT_TRUE(holds(pnmRefusal("P5 1 1 255"), "1 bytes expected"));
    EXPECT_TRUE(holds(pnmRefusal("P5 #"), "truncated"));
}

}  // namespace
}  // namespace dsphere::test
