#include <gtest/gtest.h>

#include <cmath>

#include "image/picture.h"
#include "tests/support/expecterror.h"
#include "tests/support/pngwriter.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

double fromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

TEST(PngPicture, IsLinear) {
    const TempFolder folder;
    const Image image =
        readPngPicture(folder.write("a.png", pngFile(2, 1, 8, PngColour::Rgb, {0, 10, 255, 128, 64, 200})));
    EXPECT_EQ(image.data, (Box{0, 0, 2, 1}));
    const unsigned stored[2][3] = {{0, 10, 255}, {128, 64, 200}};
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_FLOAT_EQ(image.at(names[c]).floats()[k], float(fromSrgb(stored[k][c] / 255.0)));
}

TEST(PngPicture, GreyAlphaAndSixteenBits) {
    const TempFolder folder;
    const Image grey = readPngPicture(folder.write("g.png", pngFile(1, 1, 8, PngColour::Grey, {128})));
    EXPECT_FLOAT_EQ(grey.at("B").floats()[0], float(fromSrgb(128 / 255.0)));
    const Image clear = readPngPicture(folder.write("t.png", pngFile(1, 1, 8, PngColour::Rgba, {200, 200, 200, 0})));
    EXPECT_EQ(clear.at("R").floats()[0], 0.0f);
    const Image wide = readPngPicture(folder.write("w.png", pngFile(1, 1, 16, PngColour::Rgb, {0, 32768, 65535})));
    EXPECT_FLOAT_EQ(wide.at("G").floats()[0], float(fromSrgb(32768 / 65535.0)));
    EXPECT_EQ(wide.at("B").floats()[0], 1.0f);
}

TEST(PngPicture, TheTransparentColourIsBlackAndHalfAlphaIsHalf) {
    const TempFolder folder;
    const std::string key = pngChunk("tRNS", {0, 9});
    for (int depth : {8, 16}) {
        const Image image = readPngPicture(folder.write("k.png", pngFile(2, 1, depth, PngColour::Grey, {9, 8}, key)));
        EXPECT_EQ(image.at("R").floats()[0], 0.0f) << depth;
        EXPECT_GT(image.at("R").floats()[1], 0.0f) << depth;
    }
    const Image half = readPngPicture(folder.write("h.png", pngFile(1, 1, 16, PngColour::GreyAlpha, {65535, 32768})));
    EXPECT_FLOAT_EQ(half.at("G").floats()[0], float(32768 / 65535.0));
}

TEST(PngPicture, GoesThereAndBack) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 4, 2};
    for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats() = {0, .1f, .2f, .3f, .4f, .5f, .7f, 1};
    writePng(folder.path() / "a.png", image);
    const Image once = readPicture(folder.path() / "a.png");
    writePng(folder.path() / "b.png", once);
    EXPECT_EQ(readBytes(folder.path() / "a.png"), readBytes(folder.path() / "b.png"));
}

TEST(PngPicture, EveryTruncationIsRefused) {
    const TempFolder folder;
    const std::string whole = pngFile(4, 3, 8, PngColour::Grey, std::vector<unsigned>(12, 9));
    for (std::size_t size = 0; size + 12 < whole.size(); ++size)
        messageOf(ExitCode::InvalidInput, [&] { readPngPicture(folder.write("a.png", whole.substr(0, size))); });
}

TEST(PngPicture, AbsurdSizesAreRefusedUnallocated) {
    const TempFolder folder;
    std::string bytes = "\x89PNG\r\n\x1a\n" +
                        pngChunk("IHDR", big32(1000000) + big32(1000000) + std::string("\x08\x02\0\0\0", 5)) +
                        pngChunk("IDAT", zlibStored("x")) + pngChunk("IEND", "");
    messageOf(ExitCode::InvalidInput, [&] { readPngPicture(folder.write("a.png", bytes)); });
}

TEST(Picture, ReadingGoesByTheExtension) {
    EXPECT_TRUE(holds(messageOf(ExitCode::Usage, [] { readPicture("a.jpg"); }), ".exr or .png"));
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [] { readPicture("missing.png"); }), "missing.png"));
}

}  // namespace
}  // namespace dsphere::test
