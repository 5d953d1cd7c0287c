#include "geo/mapfile.h"

#include <gtest/gtest.h>

#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

using Format = geo::PlacedFile::Format;

std::optional<Format> formatOfFile(const std::string& name, const std::string& bytes) {
    const TempFolder folder;
    const auto placed = geo::placedFile(folder.write(name, bytes));
    return placed ? std::optional(placed->format) : std::nullopt;
}

TEST(MapFile, ContentDecides) {
    using namespace std::string_literals;
    EXPECT_EQ(formatOfFile("a", "PDS_VERSION_ID = PDS3\r\nEND\r\n"), Format::Pds3);
    EXPECT_EQ(formatOfFile("a", "NJPL1I00PDS1 = X\r\n PDS_VERSION_ID = PDS3\r\nEND\r\n"), Format::Pds3);
    EXPECT_EQ(formatOfFile("a", "Object = IsisCube\n"), Format::Isis);
    EXPECT_EQ(formatOfFile("a", "CDF\x01\0\0\0\0"s), Format::NetCdf);
    EXPECT_EQ(formatOfFile("a", "\x89HDF\r\n\x1a\n"s), Format::NetCdf);
    EXPECT_EQ(formatOfFile("a", "SIMPLE  =                    T"), Format::Fits);
    EXPECT_EQ(formatOfFile("a", "\0\0\0\x0cjP  \r\n"s), Format::Jpeg2000);
    EXPECT_EQ(formatOfFile("a", "<?xml version=\"1.0\"?>\n<VRTDataset rasterXSize=\"1\">"), Format::Vrt);
    EXPECT_EQ(formatOfFile("a", "<?xml version=\"1.0\"?>\n<Product_Observational>"), Format::Pds4);
    EXPECT_EQ(formatOfFile("a", "ncols 32\nnrows 16\n"), Format::AsciiGrid);
    EXPECT_EQ(formatOfFile("a", "  NROWS -4\n"), Format::AsciiGrid);
    EXPECT_EQ(formatOfFile("N12E030.hgt", std::string(2 * 1201 * 1201, '\0')), Format::Hgt);
}

TEST(MapFile, ScenesAndPlainMapsAreNone) {
    EXPECT_FALSE(formatOfFile("a.pbrt", "# PDS_VERSION_ID = PDS3\nWorldBegin\n"));
    EXPECT_FALSE(formatOfFile("a", "ncols are many\n"));
    EXPECT_FALSE(formatOfFile("a", "P5 2 1 255\nab"));
    EXPECT_FALSE(formatOfFile("a", ""));
    EXPECT_FALSE(formatOfFile("a.hgt", "12"));
}

TEST(MapFile, SamplesAreFoundByTheLabelThatNamesThem) {
    const TempFolder folder;
    const auto image = folder.write("LDEM.IMG", "\x01\x02\x03\x04");
    EXPECT_FALSE(geo::placedFile(image));
    folder.write("LDEM.LBL", "PDS_VERSION_ID = PDS3\r\n^IMAGE = \"OTHER.IMG\"\r\nEND\r\n");
    EXPECT_FALSE(geo::placedFile(image)) << "the label is another image's";
    const auto label = folder.write("LDEM.LBL", "PDS_VERSION_ID = PDS3\r\n^IMAGE = \"ldem.img\"\r\nEND\r\n");
    const auto placed = geo::placedFile(image);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->format, Format::Pds3);
    EXPECT_EQ(placed->path, label);
}

TEST(MapFile, AnEnviHeaderLeadsToItsSamples) {
    const TempFolder folder;
    const auto header = folder.write("dem.hdr", "ENVI\nsamples = 1\n");
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { geo::placedFile(header); }), "without its samples"));
    const auto samples = folder.write("dem.img", "ab");
    EXPECT_EQ(geo::placedFile(header)->path, samples);
    EXPECT_EQ(geo::placedFile(samples)->format, Format::Envi);
}

TEST(MapFile, MapsAreToldFromScenes) {
    const TempFolder folder;
    EXPECT_TRUE(geo::looksLikeMap(folder.write("grid.txt", "ncols 3\nnrows 2\n")));
    EXPECT_TRUE(geo::looksLikeMap(folder.write("map", "P5 2 1 255\nab")));
    EXPECT_TRUE(geo::looksLikeMap("missing.lbl"));
    EXPECT_FALSE(geo::looksLikeMap(folder.write("scene.pbrt", "ncols 3\nnrows 2\n")));
    EXPECT_FALSE(geo::looksLikeMap(folder.write("scene.txt", "WorldBegin\n")));
    EXPECT_FALSE(geo::looksLikeMap("missing.xml"));
}

}  // namespace
}  // namespace dsphere::test
