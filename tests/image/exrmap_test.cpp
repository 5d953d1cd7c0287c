#include <gtest/gtest.h>

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

TEST(ExrMap, ChoosesItsChannels) {
    const auto samplesOf = [](const ExrPlanes<float>& planes) {
        return readExrOf(exrFile<float>({0, 0, 2, 1}, planes)).samples;
    };
    EXPECT_EQ(samplesOf({{"R", {1, 7}}, {"G", {2, 7}}, {"B", {4, 7}}}), (std::vector<float>{float(7.0 / 3.0), 7}));
    EXPECT_EQ(samplesOf({{"R", {1, 7}}, {"G", {2, 7}}, {"B", {4, 7}}, {"A", {0, 0}}}),
              (std::vector<float>{float(7.0 / 3.0), 7}));
    EXPECT_EQ(samplesOf({{"Y", {3, 5}}, {"A", {0, 0}}}), (std::vector<float>{3, 5}));
    EXPECT_EQ(samplesOf({{"layer.elevation", {3, 5}}}), (std::vector<float>{3, 5}));
}

TEST(ExrMap, RefusesChannelsThatAreNoHeights) {
    const std::string message = refusalOf<float>({{"R", {1, 2}}, {"G", {1, 2}}});
    EXPECT_TRUE(holds(message, "map.exr: "));
    EXPECT_TRUE(holds(message, "it has the channels G, R; a heightmap has Y, or R, G and B, or a single one"));
}

}  // namespace
}  // namespace dsphere::test
