#include "geo/label.h"

#include <gtest/gtest.h>

#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

geo::Pds3Label labelOf(const std::string& text) {
    const TempFolder folder;
    return geo::Pds3Label(folder.write("map.lbl", text));
}

std::string mapLabel(const std::string& west, const std::string& east, const std::string& more) {
    return "PDS_VERSION_ID = PDS3\r\nMAP_PROJECTION_TYPE = \"SIMPLE CYLINDRICAL\"\r\nMAP_RESOLUTION = 2 "
           "<PIXEL/DEGREE>\r\n"
           "WESTERNMOST_LONGITUDE = " +
           west + " <deg>\r\nEASTERNMOST_LONGITUDE = " + east + " <deg>\r\n" + more +
           "\r\nEND\r\nMINIMUM_LATITUDE = 7\r\n";
}

const char* const kPoles = "MAXIMUM_LATITUDE = 90.0 <deg>\r\nMINIMUM_LATITUDE = -90.0 <deg>";

TEST(Label, TakesQuotesAndUnitsOff) {
    const auto label = labelOf(
        "PDS_VERSION_ID = \"PDS3\"\r\nUNIT = FOOT\r\nOBJECT = IMAGE\r\n  UNIT = \"METER\"\r\n  OFFSET = 1737400. "
        "<m>\r\n"
        "  BAD = 'N/A'\r\n  MISSING_CONSTANT = 16#FF7FFFFB#\r\nEND_OBJECT = IMAGE\r\nA_AXIS_RADIUS = +1737.4 "
        "<km>\r\nEND\r\n"
        "LATER = 1\r\n");
    EXPECT_EQ(label.text("UNIT"), "METER") << "an image's own key counts before others";
    EXPECT_EQ(label.number("OFFSET"), 1737400.0);
    EXPECT_EQ(label.number("A_AXIS_RADIUS"), 1737.4);
    EXPECT_FALSE(label.number("BAD"));
    EXPECT_EQ(label.text("LATER"), "");
    ASSERT_TRUE(label.missing());
    EXPECT_EQ(label.missing()->second, double(std::bit_cast<float>(0xff7ffffbu)));
}

TEST(Label, MissingIntegersAndNone) {
    EXPECT_EQ(labelOf("MISSING = -32768\nEND\n").missing()->second, -32768.0);
    EXPECT_EQ(labelOf("CORE_NULL = 16#8001#\nEND\n").missing()->second, -32767.0);
    EXPECT_FALSE(labelOf("SAMPLE_TYPE = MSB_INTEGER\nEND\n").missing());
}

TEST(Label, GridByItsOutermostDegrees) {
    const auto grid = labelOf(mapLabel("0.0", "360.0", kPoles)).grid(720, 360);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->west, 0.0);
    EXPECT_EQ(grid->north, 90.0);
    EXPECT_EQ(grid->dx, 0.5);
    EXPECT_EQ(grid->dy, -0.5);
    const auto nodes = labelOf(mapLabel("-180", "180", kPoles)).grid(721, 361);
    ASSERT_TRUE(nodes);
    EXPECT_EQ(nodes->west, -180.25);
    EXPECT_EQ(nodes->north, 90.25);
}

TEST(Label, WestLongitudesStillRunEastwardInTheImage) {
    const auto grid =
        labelOf(mapLabel("270", "270", std::string(kPoles) + "\r\nPOSITIVE_LONGITUDE_DIRECTION = WEST")).grid(720, 360);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->west, -270.0);
    EXPECT_EQ(grid->dx, 0.5);
}

TEST(Label, NoGridWhereKeysContradictOrLack) {
    EXPECT_FALSE(labelOf(mapLabel("0", "360", kPoles)).grid(700, 360));
    EXPECT_FALSE(labelOf(mapLabel("0", "360", "")).grid(720, 360));
    EXPECT_FALSE(labelOf("MAP_PROJECTION_TYPE = SINUSOIDAL\nEND\n").grid(720, 360));
}

}  // namespace
}  // namespace dsphere::test
