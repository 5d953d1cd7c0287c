#include <gtest/gtest.h>

#include <cmath>

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

void expectUnknown(const RawMap& map, const std::vector<float>& expected) {
    EXPECT_TRUE(map.unknown_are_nan);
    ASSERT_EQ(map.samples.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        if (std::isnan(expected[k]))
            EXPECT_TRUE(std::isnan(map.samples[k])) << k;
        else
            EXPECT_EQ(map.samples[k], expected[k]) << k;
}

const float kUnknown = std::nanf("");

TEST(Png, TransparentTexelsAreUnknown) {
    const RawMap grey = readPngOf(pngFile(3, 1, 16, PngColour::GreyAlpha, {1000, 0, 2000, 7, 3000, 65535}));
    expectUnknown(grey, {kUnknown, 2000, 3000});
    EXPECT_EQ(grey.type, "16-bit PNG with alpha");
    EXPECT_TRUE(holds(grey.notices.at(0).text, "partly transparent texels: 1"));
    const RawMap rgba = readPngOf(pngFile(2, 1, 8, PngColour::Rgba, {5, 9, 200, 0, 8, 8, 8, 255}));
    expectUnknown(rgba, {kUnknown, 8});
    EXPECT_TRUE(rgba.notices.empty()) << "colours that nobody sees do not count";
    EXPECT_EQ(rgba.type, "8-bit colour PNG with alpha");
}

TEST(Png, OpaqueAlphaIsNothing) {
    const RawMap map = readPngOf(pngFile(1, 1, 8, PngColour::Rgba, {5, 5, 5, 255}));
    EXPECT_EQ(map.samples, (std::vector<float>{5}));
    EXPECT_FALSE(map.unknown_are_nan);
    EXPECT_TRUE(map.notices.empty());
    EXPECT_TRUE(holds(pngRefusal(pngFile(1, 1, 8, PngColour::Rgba, {5, 5, 5, 0})), "alpha is 0 everywhere"));
}

TEST(Png, TheTransparentColourIsUnknown) {
    const std::string grey = pngChunk("tRNS", {char(0x03), char(0xe8)});  // 1000
    const RawMap map = readPngOf(pngFile(2, 1, 16, PngColour::Grey, {1000, 2000}, grey));
    expectUnknown(map, {kUnknown, 2000});
    EXPECT_EQ(map.type, "16-bit PNG with a transparent colour");
    // Of 2 bits, whose other 14 mean nothing; compared before the values are spread.
    const std::string two = pngChunk("tRNS", {char(0xff), char(0xfd)});
    expectUnknown(readPngOf(pngFile(4, 1, 2, PngColour::Grey, {0, 1, 2, 3}, two)), {0, kUnknown, 170, 255});
    const std::string rgb = pngChunk("tRNS", {0, 1, 0, 2, 0, 4});
    expectUnknown(readPngOf(pngFile(3, 1, 8, PngColour::Rgb, {1, 2, 4, 1, 2, 2, 4, 4, 4}, rgb)),
                  {kUnknown, float(5.0 / 3.0), 4});
    const RawMap unused = readPngOf(pngFile(1, 1, 16, PngColour::Grey, {2000}, grey));
    EXPECT_FALSE(unused.unknown_are_nan);
    EXPECT_TRUE(holds(pngRefusal(pngFile(1, 1, 16, PngColour::Grey, {2000}, pngChunk("tRNS", "12345"))), "tRNS"));
}

TEST(Png, APaletteOfGreysIsLookedUp) {
    const std::string palette = pngChunk("PLTE", {0, 0, 0, 10, 10, 10, 1, 2, 3});
    const RawMap map = readPngOf(pngFile(3, 1, 8, PngColour::Palette, {0, 1, 0}, palette));
    EXPECT_EQ(map.samples, (std::vector<float>{0, 10, 0}));
    EXPECT_EQ(map.type, "8-bit palette PNG");
    EXPECT_EQ(map.full_scale, 255.0);
    // The colour is transparent, so that it does not count either.
    const std::string alpha = pngChunk("tRNS", {char(255), char(128), 0});
    const RawMap gaps = readPngOf(pngFile(3, 1, 2, PngColour::Palette, {2, 1, 0}, palette + alpha));
    expectUnknown(gaps, {kUnknown, 10, 0});
    EXPECT_TRUE(holds(gaps.notices.at(0).text, "partly transparent texels: 1"));
}

TEST(Png, APaletteOfColoursIsRefused) {
    const std::string palette = pngChunk("PLTE", {0, 0, 0, 10, 10, 10, 1, 2, 3});
    EXPECT_TRUE(holds(pngRefusal(pngFile(3, 2, 8, PngColour::Palette, {1, 1, 0, 0, 2, 1}, palette)),
                      "its palette holds colours, not heights: the texel at column 1, row 1 is R 1, G 2, B 3"));
    EXPECT_TRUE(holds(pngRefusal(pngFile(2, 1, 8, PngColour::Palette, {1, 3}, palette)),
                      "column 1, row 0 has entry 3 of a palette of 3"));
}

/// The texels of a map of `width` columns in the order of Adam7, each pass as rows without a filter.
std::string adam7(int width, int height, const std::string& texels) {
    constexpr int kLeft[] = {0, 4, 0, 2, 0, 1, 0}, kTop[] = {0, 0, 4, 0, 2, 0, 1};
    constexpr int kAcross[] = {8, 8, 4, 4, 2, 2, 1}, kDown[] = {8, 8, 8, 4, 4, 2, 2};
    std::string data;
    for (int pass = 0; pass < 7; ++pass)
        for (int j = kTop[pass]; j < height && kLeft[pass] < width; j += kDown[pass]) {
            data += '\0';
            for (int i = kLeft[pass]; i < width; i += kAcross[pass]) data += texels[std::size_t(j * width + i)];
        }
    return data;
}

TEST(Png, InterlacedOnesAreTheSame) {
    std::string texels;
    for (int k = 0; k < 11 * 9; ++k) texels += char(2 * k);
    const std::string header = big32(11) + big32(9) + std::string{8, 0, 0, 0, 1};
    const RawMap map = readPngOf("\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) +
                                 pngChunk("IDAT", zlibStored(adam7(11, 9, texels))) + pngChunk("IEND", ""));
    for (std::size_t k = 0; k < texels.size(); ++k) ASSERT_EQ(map.samples[k], float(2 * k));
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
    EXPECT_TRUE(holds(pngRefusal(bad), "IDAT: incorrect data check"));
    bad = good;
    bad[good.size() - 13] = char(bad[good.size() - 13] ^ 1);
    EXPECT_TRUE(holds(pngRefusal(bad), "IDAT: CRC error"));
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
    EXPECT_TRUE(holds(pngRefusal(withSize(4, 4, data)), "row 0 cannot be decoded: Not enough image data"));
    EXPECT_TRUE(holds(pngRefusal(withSize(4, 4, std::string(70000, 'x'))), "incorrect header check"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1, 1, "")), "Not enough image data"));
    EXPECT_TRUE(holds(pngRefusal(withSize(1, 1, "no zlib stream")), "cannot be decoded"));
}

TEST(Png, RefusesAFirstChunkOtherThanTheHeader) {
    const std::string signature = "\x89PNG\r\n\x1a\n";
    EXPECT_TRUE(holds(pngRefusal(signature + pngChunk("IEND", "") + std::string(21, 'x')), "expected IHDR of 13"));
    EXPECT_TRUE(holds(pngRefusal(signature + pngChunk("IHDR", "short") + std::string(21, 'x')),
                      "IHDR\" of 5 bytes, expected IHDR"));
}

}  // namespace
}  // namespace dsphere::test
