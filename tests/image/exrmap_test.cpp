#include <gtest/gtest.h>

#include <cmath>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/image/exrwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readExrOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.exr", bytes));
}

template <typename Sample>
std::string refusalOf(const ExrPlanes<Sample>& planes) {
    return messageOf(ExitCode::InvalidInput, [&] { readExrOf(exrFile({0, 0, 2, 1}, planes)); });
}

TEST(ExrMap, KeepsEveryFloatBitForBit) {
    std::vector<float> samples = floatRamp(101 * 67);
    samples[5] = std::bit_cast<float>(0x7fc12345u);  // a NaN with a payload
    for (const auto compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION})
        for (const int tile : {0, 16}) {
            SCOPED_TRACE(tile);
            const RawMap map = readExrOf(exrFile<float>({-7, 30, 94, 97}, {{"Y", samples}}, tile, compression));
            EXPECT_EQ(map.width, 101);
            EXPECT_EQ(map.height, 67);
            EXPECT_EQ(map.full_scale, 1.0);
            EXPECT_EQ(map.type, "EXR");
            EXPECT_FALSE(map.gridline);
            ASSERT_EQ(map.samples.size(), samples.size());
            for (std::size_t k = 0; k < samples.size(); ++k)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(map.samples[k]), std::bit_cast<std::uint32_t>(samples[k])) << k;
        }
}

TEST(ExrMap, KeepsEveryInteger16) {
    std::vector<std::uint32_t> samples(256 * 256);
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = std::uint32_t(k);
    for (const int tile : {0, 16}) {
        const RawMap map = readExrOf(exrFile<std::uint32_t>({0, 0, 256, 256}, {{"height", samples}}, tile));
        for (std::size_t k = 0; k < samples.size(); ++k) ASSERT_EQ(map.samples[k], float(k));
    }
}

TEST(ExrMap, WidensHalves) {
    const std::vector<half> halves{half(0.1f), half(-2.0f), half(65504.0f)};
    EXPECT_EQ(readExrOf(exrFile<half>({0, 0, 3, 1}, {{"Z", halves}})).samples,
              (std::vector<float>{float(half(0.1f)), -2, 65504}));
}

RawMap mapOf(const ExrPlanes<float>& planes) {
    return readExrOf(exrFile<float>({0, 0, 2, 1}, planes));
}

const std::vector<float> kOnes{1, 1};

TEST(ExrMap, ChoosesItsChannels) {
    const std::vector<float> mean{float(7.0 / 3.0), 7};
    const RawMap colour = mapOf({{"R", {1, 7}}, {"G", {2, 7}}, {"B", {4, 7}}});
    EXPECT_EQ(colour.samples, mean);
    EXPECT_EQ(colour.type, "colour EXR");
    EXPECT_EQ(colour.notices.at(0).kind, Notice::Kind::Warning);
    EXPECT_TRUE(holds(colour.notices[0].text, "(R 1 to 7, G 2 to 7, B 4 to 7): heights are their mean"));
    const RawMap alpha = mapOf({{"R", {1, 7}}, {"G", {2, 7}}, {"B", {4, 7}}, {"A", kOnes}});
    EXPECT_EQ(alpha.samples, mean);
    EXPECT_EQ(alpha.type, "colour EXR with alpha");
    EXPECT_EQ(mapOf({{"Y", {3, 5}}, {"A", kOnes}}).samples, (std::vector<float>{3, 5}));
    EXPECT_EQ(mapOf({{"R", {3, 5}}, {"A", kOnes}}).samples, (std::vector<float>{3, 5}));
    EXPECT_EQ(mapOf({{"R", {3, 3}}, {"G", {3, 3}}, {"B", {3, 3}}}).notices, Notices{});
}

TEST(ExrMap, OneLayerOfAnyNameIsRead) {
    EXPECT_EQ(mapOf({{"layer.elevation", {3, 5}}}).samples, (std::vector<float>{3, 5}));
    EXPECT_EQ(mapOf({{"Depth.Z", {3, 5}}}).type, "EXR, layer Depth");
    const RawMap blender = mapOf({{"ViewLayer.Combined.R", {1, 2}},
                                  {"ViewLayer.Combined.G", {1, 2}},
                                  {"ViewLayer.Combined.B", {1, 2}},
                                  {"ViewLayer.Combined.A", kOnes}});
    EXPECT_EQ(blender.samples, (std::vector<float>{1, 2}));
    EXPECT_EQ(blender.type, "colour EXR with alpha, layer ViewLayer.Combined");
    EXPECT_TRUE(blender.notices.empty());
    EXPECT_EQ(mapOf({{"v.red", {1, 2}}, {"v.green", {1, 2}}, {"v.blue", {1, 2}}}).samples, (std::vector<float>{1, 2}));
}

TEST(ExrMap, ChannelsBesideTheHeightsAreNoted) {
    const RawMap map =
        mapOf({{"R", {1, 2}}, {"G", {1, 2}}, {"B", {1, 2}}, {"N.X", kOnes}, {"N.Y", kOnes}, {"N.Z", kOnes}});
    EXPECT_EQ(map.samples, (std::vector<float>{1, 2}));
    EXPECT_TRUE(holds(map.notices.at(0).text, "map.exr: heights are its channels R, G, B; not read: N.X, N.Y, N.Z"));
    const RawMap mattes =
        mapOf({{"Y", {1, 2}}, {"CryptoObject00.R", kOnes}, {"CryptoObject00.G", kOnes}, {"CryptoObject00.B", kOnes}});
    EXPECT_EQ(mattes.samples, (std::vector<float>{1, 2}));
}

TEST(ExrMap, AlphaZeroIsUnknown) {
    const RawMap map = mapOf({{"R", {3, 5}}, {"A", {0, 0.5f}}});
    EXPECT_TRUE(std::isnan(map.samples[0]));
    EXPECT_EQ(map.samples[1], 5);
    EXPECT_TRUE(map.unknown_are_nan);
    EXPECT_TRUE(holds(map.notices.at(0).text, "partly transparent texels: 1"));
    EXPECT_TRUE(holds(refusalOf<float>({{"R", {3, 5}}, {"A", {0, 0}}}), "map.exr: its alpha is 0 everywhere"));
}

TEST(ExrMap, RefusesChannelsThatAreNoHeights) {
    const std::string two = refusalOf<float>({{"R", {1, 2}}, {"G", {1, 2}}});
    EXPECT_TRUE(holds(two,
                      "map.exr: cannot be read as EXR: several of its channels could be heights: G, R; expected Y, or "
                      "R, G and B, or a single channel, in one layer of any name"));
    EXPECT_TRUE(holds(refusalOf<float>({{"X", {1, 2}}, {"Y", {1, 2}}, {"Z", {1, 2}}}),
                      "X, Y and Z are vectors (displacement or normals), not heights"));
    EXPECT_TRUE(holds(refusalOf<float>({{"N.X", {1, 2}}, {"N.Y", {1, 2}}, {"N.Z", {1, 2}}}), "N.X, N.Y, N.Z"));
    EXPECT_TRUE(holds(
        refusalOf<float>({{"Combined.R", kOnes}, {"Combined.G", kOnes}, {"Combined.B", kOnes}, {"Depth.Z", kOnes}}),
        "several of its channels could be heights: Combined.R Combined.G Combined.B, Depth.Z"));
    EXPECT_TRUE(holds(refusalOf<float>({{"A", {1, 2}}}), "it has the channels A; expected"));
}

TEST(ExrMap, IdsAreNoHeights) {
    EXPECT_TRUE(holds(refusalOf<std::uint32_t>({{"id", {1, 2}}}), "channels of type UINT are ids, not heights"));
    EXPECT_EQ(readExrOf(exrFile<std::uint32_t>({0, 0, 2, 1}, {{"Y", {1, 2}}, {"id", {9, 9}}})).samples,
              (std::vector<float>{1, 2}));
}

TEST(ExrMap, APartOfAPictureIsWarnedOf) {
    const RawMap map = readExrOf(
        exrFile<float>({2, 3, 6, 5}, {{"Y", std::vector<float>(8, 1.0f)}}, 0, Imf::ZIP_COMPRESSION, {0, 0, 10, 10}));
    EXPECT_EQ(map.notices.at(0).kind, Notice::Kind::Warning);
    EXPECT_TRUE(holds(map.notices[0].text, "its pixels are 4x2 of a picture of 10x10"));
}

TEST(ExrMap, FurtherPartsAreNamed) {
    const TempFolder folder;
    const auto path = folder.path() / "parts.exr";
    writeExrParts(path, {"height", "mask", "beauty"}, {Imf::SCANLINEIMAGE, Imf::SCANLINEIMAGE, Imf::SCANLINEIMAGE});
    const RawMap map = readRawMap(path);
    EXPECT_EQ(map.type, "EXR, part 1 of 3");
    EXPECT_TRUE(holds(map.notices.at(0).text, "only the first of its 3 parts is read; the others are mask, beauty"));
    writeExrParts(path, {"deep"}, {Imf::DEEPSCANLINE});
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { readRawMap(path); }), "deep data"));
}

/// The file's headers with the data window's or the tiles' bytes replaced.
std::string withBytes(std::string file, const std::string& before, const std::vector<std::uint32_t>& words) {
    const std::size_t at = file.find(before) + before.size() + 4;
    for (std::size_t k = 0; k < words.size(); ++k)
        for (std::size_t byte = 0; byte < 4; ++byte) file[at + 4 * k + byte] = char(words[k] >> 8 * byte);
    return file;
}

// OpenEXR would make room for the chunks' table of what the header promises, however small the file is.
TEST(ExrMap, SizesAreNotBelievedBeforeTheFile) {
    using namespace std::string_literals;
    const auto refusal = [](const std::string& bytes) {
        return messageOf(ExitCode::InvalidInput, [&] { readExrOf(bytes); });
    };
    const std::string window = "dataWindow\0box2i\0"s, tiles = "tiles\0tiledesc\0"s;
    const std::string lines = exrFile<float>({0, 0, 10, 10}, {{"Y", std::vector<float>(100)}}, 0, Imf::NO_COMPRESSION);
    EXPECT_TRUE(holds(refusal(withBytes(lines, window, {0, 0, 9, 99999})), "a table of 100000 chunks in a file of"));
    EXPECT_TRUE(holds(refusal(withBytes(lines, window, {0, 0x80000000u, 9, 0x7fffffffu})), "10x4294967296"));
    const std::string tiled = exrFile<float>({0, 0, 10, 10}, {{"Y", std::vector<float>(100)}}, 4);
    EXPECT_TRUE(holds(refusal(withBytes(tiled, window, {0, 0, 99999, 9999})), "a table of 62500000 chunks"));
    EXPECT_TRUE(holds(refusal(withBytes(tiled, tiles, {0, 1})), "tiles of 0x1 pixels"));
    std::string long_attribute = lines;
    long_attribute[lines.find("chlist") + 10] = 0x7f;
    EXPECT_TRUE(holds(refusal(long_attribute), "reaches beyond the file's end"));
}

}  // namespace
}  // namespace dsphere::test
