// Colour images: the same texels out of every format, worked out by hand.

#include <gtest/gtest.h>

#include <jpeglib.h>

#include <array>

#include "base/srgb.h"
#include "image/rawcolour.h"
#include "tests/image/encoders.h"
#include "tests/image/exrwriter.h"
#include "tests/image/jpegwriter.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawColour read(const std::string& name, const std::string& bytes) {
    const TempFolder folder;
    return readRawColour(folder.write(name, bytes));
}

using Codes = std::vector<std::uint8_t>;
using Light = std::vector<float>;

// Two texels: orange over teal.
const std::vector<unsigned> kTwo{255, 128, 0, 1, 100, 200};
const Codes kTwoCodes{255, 128, 0, 1, 100, 200};

TEST(Colour, EightBitsStayCodes) {
    const std::string tiff = tiffFile<std::uint8_t>({.samples = 3, .photometric = PHOTOMETRIC_RGB}, 1, 2, kTwoCodes);
    const RawColour images[] = {read("a.png", pngFile(1, 2, 8, PngColour::Rgb, kTwo)),
                                read("a.ppm", pnmFile(1, 2, 255, kTwo)),
                                read("b.ppm", "P3 1 2 255  255 128 0  1 100 200\n"), read("a.tif", tiff)};
    for (const RawColour& image : images) {
        EXPECT_EQ(image.width, 1) << image.type;
        EXPECT_EQ(image.height, 2) << image.type;
        EXPECT_EQ(image.srgb, kTwoCodes) << image.type;
        EXPECT_TRUE(image.linear.empty()) << image.type;
    }
}

TEST(Colour, GreyHasThreeEqualChannels) {
    const Codes both{7, 7, 7, 200, 200, 200};
    EXPECT_EQ(read("a.png", pngFile(2, 1, 8, PngColour::Grey, {7, 200})).srgb, both);
    EXPECT_EQ(read("a.png", pngFile(2, 1, 8, PngColour::GreyAlpha, {7, 0, 200, 9})).srgb, both);
    EXPECT_EQ(read("a.pgm", pnmFile(2, 1, 255, {7, 200})).srgb, both);
    EXPECT_EQ(read("a.tif", tiffFile<std::uint8_t>({}, 2, 1, {7, 200})).srgb, both);
    EXPECT_EQ(read("a.pfm", pfmFile(2, 1, {0.25f, -3.0f}, true)).linear, (Light{.25f, .25f, .25f, -3, -3, -3}));
}

TEST(Colour, AlphaIsLeftOut) {
    EXPECT_EQ(read("a.png", pngFile(1, 1, 8, PngColour::Rgba, {1, 2, 3, 4})).srgb, (Codes{1, 2, 3}));
    const TiffForm form{.samples = 4, .photometric = PHOTOMETRIC_RGB};
    EXPECT_EQ(read("a.tif", tiffFile<std::uint8_t>(form, 1, 1, {1, 2, 3, 4})).srgb, (Codes{1, 2, 3}));
}

// IEC 61966-2-1 by hand: the code 0.02 is below the knee, 0.02 / 12.92; of the code 0.5, ((0.5 + 0.055) / 1.055)^2.4.
TEST(Colour, TheDecodingIsSrgbs) {
    EXPECT_DOUBLE_EQ(linearFromSrgb(0.02), 0.02 / 12.92);
    EXPECT_NEAR(linearFromSrgb(0.5), 0.21404114048223255, 1e-15);
    EXPECT_EQ(linearFromSrgb(1.0), 1.0);
}

TEST(Colour, OtherIntegersAreDecoded) {
    const std::vector<unsigned> samples{65535, 32768, 0, 1000, 50, 9999};
    const std::vector<std::uint16_t> words(samples.begin(), samples.end());
    Light light;
    for (const unsigned sample : samples) light.push_back(float(linearFromSrgb(sample / 65535.0)));
    const TiffForm form{.samples = 3, .photometric = PHOTOMETRIC_RGB};
    EXPECT_EQ(read("a.png", pngFile(1, 2, 16, PngColour::Rgb, samples)).linear, light);
    EXPECT_EQ(read("a.ppm", pnmFile(1, 2, 65535, samples)).linear, light);
    EXPECT_EQ(read("a.tif", tiffFile<std::uint16_t>(form, 1, 2, words)).linear, light);
    EXPECT_EQ(read("a.ppm", pnmFile(1, 1, 9, {0, 9, 3})).linear, (Light{0, 1, float(linearFromSrgb(3 / 9.0))}));
}

TEST(Colour, FloatsAreLight) {
    const Light light{0.5f, 2.0f, -1.0f, 1e-20f, 0.0f, 7.0f};
    const Light red{0.5f, 1e-20f}, green{2.0f, 0.0f}, blue{-1.0f, 7.0f};
    TiffForm form{.samples = 3, .photometric = PHOTOMETRIC_RGB};
    EXPECT_EQ(read("a.pfm", pfmFile(1, 2, light, false)).linear, light);
    EXPECT_EQ(read("a.tif", tiffFile<float>(form, 1, 2, light)).linear, light);
    form.planar = PLANARCONFIG_SEPARATE;
    EXPECT_EQ(read("a.tif", tiffFile<float>(form, 1, 2, light)).linear, light);
    EXPECT_EQ(read("a.exr", exrFile<float>({0, 0, 1, 2}, {{"R", red}, {"G", green}, {"B", blue}})).linear, light);
    EXPECT_EQ(read("a.exr", exrFile<float>({0, 0, 1, 2}, {{"Y", red}})).linear,
              (Light{0.5f, 0.5f, 0.5f, 1e-20f, 1e-20f, 1e-20f}));
}

// Tiles wider and higher than what is left of the image.
TEST(Colour, TiledTiff) {
    TiffForm form{.samples = 3, .photometric = PHOTOMETRIC_RGB};
    form.tile_width = form.tile_height = 16;
    Codes codes(3 * 21 * 5);
    for (std::size_t k = 0; k < codes.size(); ++k) codes[k] = std::uint8_t(k);
    EXPECT_EQ(read("a.tif", tiffFile<std::uint8_t>(form, 21, 5, codes)).srgb, codes);
}

// A block of one colour has no detail to lose: white, black and greys come back exactly, colours within a step or two.
TEST(Colour, JpegOfFlatBlocks) {
    for (const bool progressive : {false, true}) {
        Codes codes(3 * 16 * 8);
        for (std::size_t k = 0; k < codes.size(); ++k) codes[k] = k / 3 % 16 < 8 ? kTwoCodes[k % 3] : 255;
        const RawColour image = read("a.jpg", jpegFile(16, 8, codes, {.progressive = progressive}));
        ASSERT_EQ(image.srgb.size(), codes.size());
        EXPECT_EQ(image.type, "8-bit JPEG");
        for (std::size_t k = 0; k < codes.size(); ++k) EXPECT_NEAR(image.srgb[k], codes[k], 2) << k;
        EXPECT_EQ(image.srgb[3 * 15], 255);
    }
    EXPECT_EQ(read("a.jpg", jpegFile(8, 8, Codes(64, 77), {.channels = 1})).srgb, Codes(192, 77));
}

std::string refusal(const std::string& name, const std::string& bytes) {
    return messageOf(ExitCode::InvalidInput, [&] { read(name, bytes); });
}

TEST(Colour, ExrLayersOfAnyName) {
    const Light one{1}, two{2}, three{3};
    const ExrPlanes<float> layer{{"View.R", one}, {"View.G", two}, {"View.B", three}, {"View.A", one}};
    const RawColour image = read("a.exr", exrFile<float>({0, 0, 1, 1}, layer));
    EXPECT_EQ(image.linear, (Light{1, 2, 3}));
    EXPECT_EQ(image.type, "colour EXR with alpha, layer View");
    // A render with further outputs: the colours without a layer are the picture.
    ExrPlanes<float> render = layer;
    for (const char* name : {"R", "G", "B", "Z"}) render.push_back({name, two});
    EXPECT_EQ(read("a.exr", exrFile<float>({0, 0, 1, 1}, render)).linear, (Light{2, 2, 2}));
    ExrPlanes<float> two_layers = layer;
    for (const char* name : {"Sky.R", "Sky.G", "Sky.B"}) two_layers.push_back({name, two});
    EXPECT_TRUE(holds(refusal("a.exr", exrFile<float>({0, 0, 1, 1}, two_layers)),
                      "several of its channels could be colours: Sky.R Sky.G Sky.B, View.R View.G View.B"));
}

TEST(Colour, Refusals) {
    EXPECT_TRUE(holds(refusal("a.jpg", ""), "is empty"));
    EXPECT_TRUE(holds(refusal("a.jpg", "GIF89a"), "47 49 46 38, expected a JPEG, PNG"));
    EXPECT_TRUE(holds(refusal("a.exr", exrFile<float>({0, 0, 1, 1}, {{"U", Light{1}}, {"V", Light{1}}})),
                      "could be heights: U, V; expected Y, or R, G and B"));
    EXPECT_TRUE(holds(refusal("a.tif", tiffFile<std::int16_t>({}, 1, 1, {1})), "unsigned"));
    EXPECT_TRUE(holds(refusal("a.jpg", jpegFile(8, 8, Codes(256, 9), {.channels = 4})), "CMYK"));
    EXPECT_TRUE(holds(refusal("a.jpg", jpegFile(8, 8, Codes(192, 9), {.arithmetic = true})), "arithmetic"));
}

// stb_image has no reason for a block of deflate's type 3, and would tell that of an earlier failure.
TEST(Colour, APngThatFailsTellsItsOwnReason) {
    const std::string header = big32(1) + big32(1) + std::string{8, 0, 0, 0, 0};
    const auto png = [&](const std::string& data) {
        return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", data) + pngChunk("IEND", "");
    };
    EXPECT_TRUE(holds(refusal("a.png", png("no zlib stream")), "cannot be decoded: bad zlib header"));
    EXPECT_TRUE(holds(refusal("a.png", png("\x78\x01\x07")), "cannot be decoded: its compressed data are damaged"));
}

// The height and width of a frame header, at the bytes after ff c0: a small file that promises a large image.
TEST(Colour, AJpegOfAbsurdSize) {
    std::string bytes = jpegFile(8, 8, Codes(192, 9), {});
    const std::size_t frame = bytes.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    bytes.replace(frame + 5, 4, "\x75\x30\x75\x30");
    EXPECT_TRUE(holds(refusal("a.jpg", bytes), "30000x30000 texels cannot lie"));
}

}  // namespace
}  // namespace dsphere::test
