#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readTiffOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.tif", bytes));
}

std::string refusalOf(const std::string& bytes) {
    return messageOf(ExitCode::InvalidInput, [&] { readTiffOf(bytes); });
}

/// Every byte order, size of offsets and arrangement of texels, the edges never falling on a block's.
std::vector<TiffForm> forms() {
    std::vector<TiffForm> all;
    for (const char* mode : {"wl", "wb", "wl8", "wb8"})
        for (const int compression :
             {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS})
            for (const int planar : {PLANARCONFIG_CONTIG, PLANARCONFIG_SEPARATE})
                for (const int tile : {0, 16, 48}) {
                    TiffForm form;
                    form.mode = mode;
                    form.compression = compression;
                    form.planar = planar;
                    form.tile_width = tile;
                    form.tile_height = 32;
                    form.rows_per_strip = 7;
                    all.push_back(form);
                }
    return all;
}

std::string nameOf(const TiffForm& form) {
    return form.mode + ", compression " + std::to_string(form.compression) + ", planar " + std::to_string(form.planar) +
           ", tiles " + std::to_string(form.tile_width);
}

/// Every value that a sample of 16 bits has, in 257 columns.
template <typename Sample>
std::vector<Sample> everyValue() {
    std::vector<Sample> samples(257 * 256);
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = Sample(k);
    return samples;
}

template <typename Sample>
void expectEveryValue(const TiffForm& form, double full_scale, const std::string& type) {
    SCOPED_TRACE(nameOf(form));
    const std::vector<Sample> samples = everyValue<Sample>();
    const RawMap map = readTiffOf(tiffFile(form, 257, 256, samples));
    EXPECT_EQ(map.width, 257);
    EXPECT_EQ(map.height, 256);
    EXPECT_EQ(map.full_scale, full_scale);
    EXPECT_EQ(map.type, type);
    EXPECT_FALSE(map.gridline);
    EXPECT_FALSE(map.longitude_origin);
    EXPECT_TRUE(std::ranges::equal(map.samples, samples, {}, {}, [](Sample s) { return float(s); }));
}

TEST(Tiff, KeepsEveryInteger) {
    for (const TiffForm& form : forms()) {
        expectEveryValue<std::uint16_t>(form, 65535.0, "16-bit TIFF");
        expectEveryValue<std::int16_t>(form, 32767.0, "signed 16-bit TIFF");
    }
    expectEveryValue<std::uint8_t>({}, 255.0, "8-bit TIFF");
    expectEveryValue<std::int8_t>({}, 127.0, "signed 8-bit TIFF");
}

void expectBits(const std::vector<float>& read, const std::vector<float>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t k = 0; k < read.size(); ++k)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(read[k]), std::bit_cast<std::uint32_t>(written[k])) << k;
}

TEST(Tiff, KeepsEveryFloatBitForBit) {
    std::vector<float> samples = floatRamp(101 * 67);
    samples[5] = std::bit_cast<float>(0x7fc12345u);  // a NaN with a payload
    samples[6] = -0.0f;
    for (const TiffForm& form : forms()) {
        SCOPED_TRACE(nameOf(form));
        const RawMap map = readTiffOf(tiffFile(form, 101, 67, samples));
        EXPECT_EQ(map.full_scale, 1.0);
        EXPECT_EQ(map.type, "float32 TIFF");
        expectBits(map.samples, samples);
    }
}

TEST(Tiff, UndoesPredictors) {
    TiffForm form;
    form.compression = COMPRESSION_ADOBE_DEFLATE;
    form.predictor = PREDICTOR_HORIZONTAL;
    expectEveryValue<std::uint16_t>(form, 65535.0, "16-bit TIFF");
    form.predictor = PREDICTOR_FLOATINGPOINT;
    const std::vector<float> samples = floatRamp(101 * 67);
    expectBits(readTiffOf(tiffFile(form, 101, 67, samples)).samples, samples);
}

TEST(Tiff, AStripOfTheWholeMap) {
    TiffForm form;
    form.rows_per_strip = 256;
    expectEveryValue<std::uint16_t>(form, 65535.0, "16-bit TIFF");
    form.compression = COMPRESSION_LZW;
    expectEveryValue<std::uint16_t>(form, 65535.0, "16-bit TIFF");
}

TEST(Tiff, AlphaZeroIsUnknownAndColoursAreWarnedOf) {
    for (TiffForm form : forms()) {
        SCOPED_TRACE(nameOf(form));
        form.samples = 4;
        form.photometric = PHOTOMETRIC_RGB;
        const RawMap colour = readTiffOf(tiffFile<std::uint8_t>(form, 3, 1, {1, 2, 99, 255, 9, 9, 9, 7, 1, 200, 3, 0}));
        EXPECT_EQ(colour.type, "8-bit colour TIFF with alpha");
        EXPECT_EQ(colour.samples[0], 34.0f);
        EXPECT_EQ(colour.samples[1], 9.0f);
        EXPECT_TRUE(std::isnan(colour.samples[2]));
        EXPECT_TRUE(colour.unknown_are_nan);
        ASSERT_EQ(colour.notices.size(), 2u);
        EXPECT_TRUE(holds(colour.notices[0].text, "channels differ (R 1 to 9, G 2 to 9, B 9 to 99)"));
        EXPECT_TRUE(holds(colour.notices[1].text, "partly transparent texels: 1"));
        form.samples = 2;
        form.photometric = PHOTOMETRIC_MINISBLACK;
        const RawMap grey = readTiffOf(tiffFile<float>(form, 1, 2, {-1000, 0, 2000, 1}));
        EXPECT_EQ(grey.type, "float32 TIFF with alpha");
        EXPECT_TRUE(std::isnan(grey.samples[0]));
        EXPECT_EQ(grey.samples[1], 2000.0f);
        EXPECT_TRUE(grey.notices.empty());
    }
}

TEST(Tiff, AveragesColour) {
    const std::vector<std::uint16_t> texels{1, 2, 4, 9, 65535, 65535, 65535, 8, 7, 7, 7, 7};
    for (TiffForm form : forms()) {
        SCOPED_TRACE(nameOf(form));
        form.samples = 4;
        form.photometric = PHOTOMETRIC_RGB;
        const RawMap map = readTiffOf(tiffFile(form, 3, 1, texels));
        EXPECT_EQ(map.samples, (std::vector<float>{float(7.0 / 3.0), 65535, 7}));
        form.samples = 3;
        EXPECT_EQ(readTiffOf(tiffFile<float>(form, 2, 1, {1, 2, 4, 0.1f, 0.1f, 0.1f})).samples,
                  (std::vector<float>{float(7.0 / 3.0), 0.1f}));
        form.samples = 2;
        form.photometric = PHOTOMETRIC_MINISBLACK;
        EXPECT_EQ(readTiffOf(tiffFile<std::int16_t>(form, 1, 2, {-1000, 3, 2000, 4})).samples,
                  (std::vector<float>{-1000, 2000}));
    }
}

TEST(Tiff, HeightsAreNotInverted) {
    TiffForm form;
    form.photometric = PHOTOMETRIC_MINISWHITE;
    EXPECT_EQ(readTiffOf(tiffFile<std::uint8_t>(form, 3, 1, {0, 1, 255})).samples, (std::vector<float>{0, 1, 255}));
}

TEST(Tiff, ReadsTheFirstPage) {
    const TempFolder folder;
    const auto path = folder.write("pages.tif", tiffFile<std::uint8_t>({}, 2, 1, {5, 6}));
    TIFF* tiff = TIFFOpen(path.c_str(), "a");
    ASSERT_TRUE(tiff);
    setTiffFields<std::uint8_t>(tiff, {}, 1, 1);
    const std::uint8_t value = 9;
    EXPECT_EQ(TIFFWriteEncodedStrip(tiff, 0, const_cast<std::uint8_t*>(&value), 1), 1);
    TIFFClose(tiff);
    EXPECT_EQ(readRawMap(path).samples, (std::vector<float>{5, 6}));
}

TEST(Tiff, ReadsAPaletteOfGreys) {
    const std::vector<std::uint8_t> entries{0, 1, 2, 1};
    for (const int unit : {257, 1}) {  // 16-bit colours, and the 8-bit ones that some writers store
        TiffForm form;
        form.photometric = PHOTOMETRIC_PALETTE;
        form.grey = {std::uint16_t(9 * unit), std::uint16_t(200 * unit), std::uint16_t(7 * unit)};
        const TempFolder folder;
        const RawMap map = readRawMap(folder.write("map.tif", tiffFile(form, 2, 2, entries)));
        EXPECT_EQ(map.samples, (std::vector<float>{9, 200, 7, 200}));
        EXPECT_EQ(map.full_scale, 255.0);
        EXPECT_EQ(map.type, "8-bit TIFF with a palette");
    }
}

TEST(Tiff, RefusesOtherKinds) {
    TiffForm form;
    const std::vector<std::uint8_t> bytes(64, 1);
    form.photometric = PHOTOMETRIC_MASK;
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, bytes)), "photometric interpretation 4"));
    form.photometric = PHOTOMETRIC_PALETTE;
    form.red = {0, 65535};
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, bytes)), "entry 1 is R 65535, G 0, B 0"));
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, std::vector<std::uint16_t>(4))), "of 16 bits a texel"));
    form.red = {};
    form.photometric = PHOTOMETRIC_RGB;
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, bytes)), "1 samples a texel"));
    form.photometric = PHOTOMETRIC_MINISBLACK;
    form.samples = 5;
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, bytes)), "5 samples a texel"));
    form.samples = 1;
    form.orientation = ORIENTATION_BOTLEFT;
    EXPECT_TRUE(holds(refusalOf(tiffFile(form, 2, 2, bytes)), "orientation"));
    const std::string depths = "expected 8 or 16 bits";
    EXPECT_TRUE(holds(refusalOf(tiffFile<double>({}, 2, 2, std::vector<double>(4))), depths));
    EXPECT_TRUE(holds(refusalOf(tiffFile<std::uint32_t>({}, 2, 2, std::vector<std::uint32_t>(4))), depths));
    form = {};
    form.format = SAMPLEFORMAT_IEEEFP;
    EXPECT_TRUE(holds(refusalOf(tiffFile<std::uint16_t>(form, 2, 2, std::vector<std::uint16_t>(4))), depths));
}

/// The bytes of a little-endian number.
std::string little(std::uint64_t value, int count) {
    std::string bytes;
    for (int k = 0; k < count; ++k) bytes += char(value >> 8 * k);
    return bytes;
}

struct Entry {
    int tag, type, count;
    std::uint32_t value;
};

/// A little-endian TIFF of these entries, then `data`, which begins at 14 + 12 entries.
std::string handMade(const std::vector<Entry>& entries, const std::string& data) {
    std::string file = "II" + little(42, 2) + little(8, 4) + little(entries.size(), 2);
    for (const Entry& e : entries)
        file += little(std::uint64_t(e.tag), 2) + little(std::uint64_t(e.type), 2) + little(std::uint64_t(e.count), 4) +
                little(e.value, 4);
    return file + little(0, 4) + data;
}

constexpr int kShort = 3, kLong = 4;

/// 8-bit grey of one strip that holds `data`.
std::vector<Entry> greyEntries(std::uint32_t width, std::uint32_t height, std::uint32_t bytes,
                               std::uint32_t packing = 1) {
    return {{256, kLong, 1, width}, {257, kLong, 1, height},      {258, kShort, 1, 8},     {259, kShort, 1, packing},
            {262, kShort, 1, 1},    {273, kLong, 1, 14 + 12 * 8}, {278, kLong, 1, height}, {279, kLong, 1, bytes}};
}

TEST(Tiff, ReadsAHandMadeFile) {
    const RawMap map = readTiffOf(handMade(greyEntries(3, 2, 6), {1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(map.width, 3);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(Tiff, RefusesSizesTheDataCannotFill) {
    const std::string data = "123456";
    const auto refusal = [&](std::uint32_t width, std::uint32_t height, std::uint32_t bytes,
                             std::uint32_t packing = 1) {
        return refusalOf(handMade(greyEntries(width, height, bytes, packing), data));
    };
    constexpr std::uint32_t kDeflate = 8, kZstd = 50000;
    EXPECT_TRUE(holds(refusal(0, 1, 6), "map.tif: TIFF: "));
    EXPECT_TRUE(holds(refusal((1u << 20) + 1, 1, 6), "1048577x1"));
    EXPECT_TRUE(holds(refusal(0xffffffffu, 1, 6), "4294967295x1"));
    EXPECT_TRUE(holds(refusal(1u << 20, 1u << 12, 6), "texels"));
    EXPECT_TRUE(holds(refusal(1u << 20, 1u << 11, 6), "cannot hold"));
    EXPECT_TRUE(holds(refusal(1u << 20, 1u << 11, 6, kDeflate), "cannot hold"));
    EXPECT_TRUE(holds(refusal(1u << 20, 1u << 11, 6, kZstd), "cannot hold"));
    EXPECT_TRUE(holds(refusal(1u << 10, 1u << 10, 6, 7), "for 1048576 bytes of texels"));
    EXPECT_TRUE(holds(refusal(3, 3, 6), "strip 0"));
    EXPECT_TRUE(holds(refusal(3, 2, 0, kDeflate), "row 0 cannot be decoded: "));
    EXPECT_TRUE(holds(refusal(3, 2, 0xffffffffu, kDeflate), "strip 0"));
    EXPECT_TRUE(holds(refusal(3, 2, 6, kDeflate), "row 0 cannot be decoded: "));
    EXPECT_TRUE(holds(refusal(3, 2, 6, 12345), "compression 12345"));
}

TEST(Tiff, RefusesHugeTiles) {
    std::vector<Entry> entries{{256, kLong, 1, 1},        {257, kLong, 1, 1},           {258, kShort, 1, 8},
                               {259, kShort, 1, 8},       {262, kShort, 1, 1},          {322, kLong, 1, 1u << 20},
                               {323, kLong, 1, 1u << 20}, {324, kLong, 1, 14 + 12 * 9}, {325, kLong, 1, 6}};
    EXPECT_TRUE(holds(refusalOf(handMade(entries, "123456")), "tile 0"));
    entries[5].value = entries[6].value = 0xfffffff0u;
    EXPECT_TRUE(holds(refusalOf(handMade(entries, "123456")), "TIFF: "));
    entries[5].value = entries[6].value = 0;
    EXPECT_TRUE(holds(refusalOf(handMade(entries, "123456")), "TIFF: "));
}

TEST(Tiff, RefusesMalformedHeaders) {
    const std::string offset = "the first directory is at byte";
    EXPECT_TRUE(holds(refusalOf("II" + little(42, 2) + little(8, 4)), offset));
    EXPECT_TRUE(holds(refusalOf("II" + little(42, 2) + little(0xffffffffu, 4)), offset));
    EXPECT_TRUE(holds(refusalOf("II" + little(42, 2) + little(8, 4) + little(0, 2)), "has 0 entries"));
    EXPECT_TRUE(holds(refusalOf("II" + little(42, 2) + little(8, 4) + little(2, 2)), "ends after"));
    EXPECT_TRUE(holds(refusalOf("II" + little(43, 2) + little(4, 4) + little(16, 8)), "expected offsets of 8 bytes"));
    EXPECT_TRUE(holds(refusalOf("II" + little(43, 2) + little(8, 4) + little(16, 8) + little(1ull << 60, 8)),
                      "has 1152921504606846976 entries"));
    std::vector<Entry> entries = greyEntries(3, 2, 6);
    entries[5].count = 1000;
    EXPECT_TRUE(holds(refusalOf(handMade(entries, "123456")), "tag 273 has 1000 values of 4 bytes"));
    EXPECT_TRUE(holds(refusalOf(handMade({{256, kLong, 1, 3}}, "123456")), "TIFF: "));
}

}  // namespace
}  // namespace dsphere::test
