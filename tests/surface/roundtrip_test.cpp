// One ramp through every format: the same heights, and so the same surface, bit for bit.

#include <gtest/gtest.h>

#include "image/greymap.h"
#include "surface/heightmap.h"
#include "tests/image/encoders.h"
#include "tests/image/exrwriter.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

std::string plainPgm(int width, int height, const std::vector<unsigned>& samples) {
    std::string text = "P2 " + std::to_string(width) + " " + std::to_string(height) + " 65535\n";
    for (const unsigned sample : samples) text += std::to_string(sample) + "\n";
    return text;
}

template <typename Sample>
std::vector<Sample> threefold(const std::vector<Sample>& grey) {
    std::vector<Sample> rgb;
    for (const Sample sample : grey) rgb.insert(rgb.end(), 3, sample);
    return rgb;
}

template <typename Sample>
void addTiffs(Files& files, int width, int height, const std::vector<Sample>& samples) {
    TiffForm form;
    for (const char* mode : {"wl", "wb", "w8"}) {
        form.mode = mode;
        form.compression = COMPRESSION_ADOBE_DEFLATE;
        form.rows_per_strip = 37;
        form.tile_width = form.tile_height = 0;
        files.emplace_back("strips.tif", tiffFile<Sample>(form, width, height, samples));
        form.compression = COMPRESSION_LZW;
        form.rows_per_strip = height;
        files.emplace_back("onestrip.tif", tiffFile<Sample>(form, width, height, samples));
        form.tile_width = form.tile_height = 48;
        files.emplace_back("tiles.tif", tiffFile<Sample>(form, width, height, samples));
    }
    form = {.samples = 3, .photometric = PHOTOMETRIC_RGB};
    files.emplace_back("rgb.tif", tiffFile<Sample>(form, width, height, threefold(samples)));
    form.planar = PLANARCONFIG_SEPARATE;
    files.emplace_back("planes.tif", tiffFile<Sample>(form, width, height, threefold(samples)));
}

void addFloats(Files& files, int width, int height, const std::vector<float>& samples) {
    files.emplace_back("little.pfm", pfmFile(width, height, samples, true));
    files.emplace_back("big.pfm", pfmFile(width, height, samples, false));
    files.emplace_back("rgb.pfm", pfmFile(width, height, threefold(samples), true));
    const Box window{0, 0, width, height};
    files.emplace_back("lines.exr", exrFile<float>(window, {{"Y", samples}}));
    files.emplace_back("tiles.exr", exrFile<float>(window, {{"height", samples}}, 32));
    files.emplace_back("rgb.exr", exrFile<float>(window, {{"R", samples}, {"G", samples}, {"B", samples}}));
    const GtxHeader header{-90.0, -180.0, 180.0 / (height - 1), 360.0 / width, height, width};
    files.emplace_back("globe.gtx", gtxFile(header, samples));
}

/// Every file must give these samples, and r the same as from the first one.
void expectSame(const Files& files, const std::vector<float>& samples, double full_scale) {
    const TempFolder folder;
    DisplacedSphere shape;
    shape.max_displacement = 10.0;
    shape.height_max = full_scale;
    shape.registration = Registration::Texel;
    std::optional<Relief> first;
    for (const auto& [name, bytes] : files) {
        SCOPED_TRACE(name);
        shape.map_path = folder.write(name, bytes).string();
        const Heightmap map = loadHeightmap(shape);
        ASSERT_EQ(map.samples.size(), samples.size());
        EXPECT_EQ(std::memcmp(map.samples.data(), samples.data(), 4 * samples.size()), 0);
        const Relief relief = makeRelief(shape, map, {});
        if (!first) first = relief;
        EXPECT_EQ(relief.base, first->base);
        EXPECT_EQ(relief.scale, first->scale);
    }
}

// 256x256: all values of 16 bits, which a float holds exactly.
TEST(RoundTrip, SixteenBitRamp) {
    const std::vector<unsigned> values = ramp(65536);
    const std::vector<float> samples(values.begin(), values.end());
    Files files{{"grey.png", pngFile(256, 256, 16, PngColour::Grey, values)},
                {"rgb.png", pngFile(256, 256, 16, PngColour::Rgb, threefold(values))},
                {"grey.pgm", pnmFile(256, 256, 65535, values)},
                {"rgb.ppm", pnmFile(256, 256, 65535, threefold(values))},
                {"plain.pgm", plainPgm(256, 256, values)}};
    addTiffs(files, 256, 256, std::vector<std::uint16_t>(values.begin(), values.end()));
    addTiffs(files, 256, 256, samples);
    addFloats(files, 256, 256, samples);
    expectSame(files, samples, 65535.0);
}

TEST(RoundTrip, FloatRamp) {
    std::vector<float> samples = floatRamp(120 * 61);
    for (float& sample : samples) sample = std::ldexp(sample, -2);  // the poles' sums stay finite
    Files files;
    addTiffs(files, 120, 61, samples);
    addFloats(files, 120, 61, samples);
    expectSame(files, samples, 1e39);
}

// What the program itself writes.
TEST(RoundTrip, GeneratedFormats) {
    const TempFolder folder;
    for (const char* name : {"map.png", "map.pgm", "map.tif", "map.tiff"}) {
        SCOPED_TRACE(name);
        const auto row = [](int j, std::span<std::uint16_t> out) {
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::uint16_t(256 * j + int(i));
        };
        writeGreyMap(folder.path() / name, 256, 256, row, [](double) { return true; });
        const RawMap map = readRawMap(folder.path() / name);
        for (std::size_t k = 0; k < 65536; ++k) ASSERT_EQ(map.samples[k], float(k));
    }
}

}  // namespace
}  // namespace dsphere::test
