#include <gtest/gtest.h>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readPngOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.png", bytes));
}

std::string pngRefusal(const std::string& bytes) {
    return messageOf(ExitCode::InvalidInput, [&] { readPngOf(bytes); });
}

TEST(Png, KeepsEveryValueOf16Bits) {
    const RawMap map = readPngOf(pngFile(256, 256, 16, PngColour::Grey, ramp(65536)));
    EXPECT_EQ(map.width, 256);
    EXPECT_EQ(map.height, 256);
    EXPECT_EQ(map.full_scale, 65535.0);
    EXPECT_EQ(map.type, "16-bit PNG");
    EXPECT_FALSE(map.gridline);
    EXPECT_FALSE(map.longitude_origin);
    for (std::size_t k = 0; k < 65536; ++k) ASSERT_EQ(map.samples[k], float(k));
}

TEST(Png, KeepsEveryValueOf8Bits) {
    const RawMap map = readPngOf(pngFile(16, 16, 8, PngColour::Grey, ramp(256)));
    EXPECT_EQ(map.full_scale, 255.0);
    EXPECT_EQ(map.type, "8-bit PNG");
    for (std::size_t k = 0; k < 256; ++k) ASSERT_EQ(map.samples[k], float(k));
}

TEST(Png, SpreadsLowDepthsOver8Bits) {
    EXPECT_EQ(readPngOf(pngFile(2, 1, 1, PngColour::Grey, {0, 1})).samples, (std::vector<float>{0, 255}));
    EXPECT_EQ(readPngOf(pngFile(3, 2, 2, PngColour::Grey, {0, 1, 2, 3, 2, 1})).samples,
              (std::vector<float>{0, 85, 170, 255, 170, 85}));
    EXPECT_EQ(readPngOf(pngFile(3, 1, 4, PngColour::Grey, {0, 1, 15})).samples, (std::vector<float>{0, 17, 255}));
}

TEST(Png, AveragesColourInFloat) {
    const std::vector<float> expected{float((1 + 2 + 4) / 3.0), 65535};
    EXPECT_EQ(readPngOf(pngFile(2, 1, 16, PngColour::Rgb, {1, 2, 4, 65535, 65535, 65535})).samples, expected);
    EXPECT_EQ(readPngOf(pngFile(2, 1, 8, PngColour::Rgb, {1, 2, 4, 9, 9, 9})).samples,
              (std::vector<float>{expected[0], 9}));
}

TEST(Png, IgnoresAlpha) {
    EXPECT_EQ(readPngOf(pngFile(2, 1, 16, PngColour::GreyAlpha, {1000, 0, 2000, 7})).samples,
              (std::vector<float>{1000, 2000}));
    EXPECT_EQ(readPngOf(pngFile(1, 1, 8, PngColour::Rgba, {5, 5, 5, 0})).samples, (std::vector<float>{5}));
    const std::string transparent = pngChunk("tRNS", {char(0x03), char(0xe8)});
    EXPECT_EQ(readPngOf(pngFile(2, 1, 16, PngColour::Grey, {1000, 2000}, transparent)).samples,
              (std::vector<float>{1000, 2000}));
}

TEST(Png, LooksUpThePalette) {
    const std::string palette = pngChunk("PLTE", {0, 0, 0, 10, 10, 10, 1, 2, 3});
    EXPECT_EQ(readPngOf(pngFile(3, 1, 8, PngColour::Palette, {2, 1, 0}, palette)).samples,
              (std::vector<float>{2, 10, 0}));
}

TEST(Png, SkipsOtherChunksAndWhatFollowsTheEnd) {
    const std::string gamma = pngChunk("gAMA", big32(45455)), text = pngChunk("tEXt", "Comment");
    const RawMap map = readPngOf(pngFile(2, 1, 16, PngColour::Grey, {258, 40000}, gamma + text) + "more");
    EXPECT_EQ(map.samples, (std::vector<float>{258, 40000}));
    const std::string empty = pngChunk("IDAT", "");
    EXPECT_EQ(readPngOf(pngFile(1, 1, 8, PngColour::Grey, {9}, empty)).samples, (std::vector<float>{9}));
}

TEST(Png, RefusesDamage) {
    const std::string good = pngFile(4, 2, 16, PngColour::Grey, ramp(8));
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string bad = good;
        bad[at] = char(bad[at] ^ 0x10);
        SCOPED_TRACE(at);
        EXPECT_NE(pngRefusal(bad), "");
    }
    std::string bad = good;
    bad[good.size() - 30] = char(bad[good.size() - 30] ^ 1);
    EXPECT_TRUE(holds(pngRefusal(bad), "checksum"));
}

std::string withSize(std::uint32_t width, std::uint32_t height, const std::string& data) {
    const std::string header = big32(width) + big32(height) + std::string{16, 0, 0, 0, 0};
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", data) + pngChunk("IEND", "");
}

TEST(Png, RefusesSizesTheDataCannotFill) {
    const std::string data = zlibStored("12345");
    EXPECT_TRUE(holds(pngRefusal(withSize(0, 1, data)), "0x1"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1, 0, data)), "1x0"));
    EXPECT_TRUE(holds(pngRefusal(withSize(0xffffffffu, 1, data)), "4294967295x1"));
    EXPECT_TRUE(holds(pngRefusal(withSize((1u << 20) + 1, 1, data)), "1048577x1"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1u << 20, 1u << 12, data)), "texels"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1u << 20, 1u << 11, data)), "cannot hold"));
    EXPECT_TRUE(holds(pngRefusal(withSize(4, 4, data)), "not enough pixels"));
    EXPECT_TRUE(holds(pngRefusal(withSize(4, 4, std::string(70000, 'x'))), "bytes of data for 4x4"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1, 1, "")), "0 bytes of data cannot hold"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1, 1, "no zlib stream")), "cannot be decoded"));
}

TEST(Png, RefusesAFirstChunkOtherThanTheHeader) {
    const std::string signature = "\x89PNG\r\n\x1a\n";
    EXPECT_TRUE(holds(pngRefusal(signature + pngChunk("IEND", "")), "expected IHDR"));
    EXPECT_TRUE(holds(pngRefusal(signature + pngChunk("IHDR", "short")), "expected IHDR"));
}

}  // namespace
}  // namespace dsphere::test
