// Hostile input: whatever the bytes, a reader returns a map or throws Error (InvalidInput), within the memory that the
// file's own length justifies.

#include <gtest/gtest.h>

#include <random>

#include "image/picture.h"
#include "image/rawcolour.h"
#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/image/exrwriter.h"
#include "tests/image/jpegwriter.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

struct Sample {
    std::string name, bytes;
};

TiffForm deflated(const std::string& mode) {
    TiffForm form;
    form.mode = mode;
    form.compression = COMPRESSION_ADOBE_DEFLATE;
    return form;
}

TiffForm colourTiles() {
    TiffForm form;
    form.samples = 3;
    form.photometric = PHOTOMETRIC_RGB;
    form.planar = PLANARCONFIG_SEPARATE;
    form.compression = COMPRESSION_LZW;
    form.tile_width = form.tile_height = 16;
    return form;
}

std::vector<Sample> smallFiles() {
    const std::string palette = pngChunk("PLTE", {0, 0, 0, 10, 10, 10, 7, 7, 7});
    return {
        {"grey16.png", pngFile(4, 2, 16, PngColour::Grey, ramp(8))},
        {"rgb8.png", pngFile(2, 2, 8, PngColour::Rgb, ramp(12))},
        {"palette.png", pngFile(3, 1, 2, PngColour::Palette, {2, 1, 0}, palette)},
        {"alpha16.png", pngFile(2, 2, 16, PngColour::GreyAlpha, ramp(8))},
        {"key8.png", pngFile(2, 2, 8, PngColour::Rgb, ramp(12), pngChunk("tRNS", {0, 3, 0, 4, 0, 5}))},
        {"grey8.pgm", pnmFile(4, 3, 255, ramp(12))},
        {"grey16.pgm", pnmFile(4, 3, 1000, ramp(12))},
        {"rgb8.ppm", pnmFile(2, 2, 255, ramp(12))},
        {"rgb16.ppm", pnmFile(2, 2, 65535, ramp(12))},
        {"plain.pgm", "P2 # map\n3 2 9\n1 2 3\n4 5 6"},
        {"plain.ppm", "P3\n2 1 255\n10 20 30\n40 50 6"},
        {"grey.pfm", pfmFile(3, 2, floatRamp(6), true)},
        {"rgb.pfm", pfmFile(2, 2, floatRamp(12), false)},
        {"globe.gtx", gtxFile({}, floatRamp(40))},
        {"strips.tif", tiffFile<std::uint16_t>({}, 5, 8, std::vector<std::uint16_t>(40, 258))},
        {"float.tif", tiffFile<float>(deflated("wb"), 5, 8, floatRamp(40))},
        {"rgb.tif", tiffFile<std::uint8_t>(colourTiles(), 5, 3, std::vector<std::uint8_t>(45, 7))},
        {"big.tif", tiffFile<float>(deflated("w8"), 5, 8, floatRamp(40))},
        {"lines.exr", exrFile<float>({1, 2, 6, 10}, {{"Y", floatRamp(40)}})},
        {"tiles.exr", exrFile<half>({0, 0, 20, 3}, {{"Y", std::vector<half>(60, half(0.3f))}}, 16)},
    };
}

TEST(HostileMap, EveryTruncationIsRefused) {
    const TempFolder folder;
    for (const Sample& sample : smallFiles()) {
        const std::filesystem::path whole = folder.write(sample.name, sample.bytes);
        EXPECT_NO_THROW(readRawMap(whole)) << sample.name;
        for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
            SCOPED_TRACE(sample.name + " cut to " + std::to_string(length));
            const auto cut = folder.write(sample.name, sample.bytes.substr(0, length));
            const std::string message = messageOf(ExitCode::InvalidInput, [&] { readRawMap(cut); });
            EXPECT_TRUE(holds(message, sample.name));
        }
    }
}

std::vector<Sample> colourFiles() {
    std::vector<Sample> files;
    for (Sample& sample : smallFiles())
        if (!sample.name.ends_with(".gtx")) files.push_back(std::move(sample));
    std::vector<std::uint8_t> noise(3 * 19 * 13);
    std::mt19937 random(7);
    for (std::uint8_t& code : noise) code = std::uint8_t(random());
    files.push_back({"rgb.jpg", jpegFile(19, 13, noise, {})});
    files.push_back({"progressive.jpg", jpegFile(19, 13, noise, {.progressive = true})});
    files.push_back({"grey.jpg", jpegFile(8, 8, std::vector<std::uint8_t>(64, 5), {.channels = 1})});
    files.push_back(
        {"rgb.exr", exrFile<float>({0, 0, 3, 2}, {{"R", floatRamp(6)}, {"G", floatRamp(6)}, {"B", floatRamp(6)}})});
    return files;
}

TEST(HostileColour, EveryTruncationIsRefused) {
    const TempFolder folder;
    for (const Sample& sample : colourFiles()) {
        const std::filesystem::path whole = folder.write(sample.name, sample.bytes);
        EXPECT_NO_THROW(readRawColour(whole)) << sample.name;
        for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
            SCOPED_TRACE(sample.name + " cut to " + std::to_string(length));
            const auto cut = folder.write(sample.name, sample.bytes.substr(0, length));
            const std::string message = messageOf(ExitCode::InvalidInput, [&] { readRawColour(cut); });
            EXPECT_TRUE(holds(message, sample.name));
        }
    }
}

/// Makes the checksums of all whole chunks right, so that damage reaches the decoder.
void repairPng(std::string& bytes) {
    const auto big = [&](std::size_t at) {
        std::uint32_t n = 0;
        for (std::size_t k = 0; k < 4; ++k) n = n << 8 | std::uint8_t(bytes[at + k]);
        return n;
    };
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = big(at);
        if (length > bytes.size() - at - 12) return;
        bytes.replace(at + 8 + length, 4, big32(pngCrc(bytes.substr(at + 4, length + 4))));
        at += length + 12;
    }
}

/// A map that came out of damaged bytes must still be whole.
void readDamaged(const std::filesystem::path& path) {
    try {
        const RawMap map = readRawMap(path);
        EXPECT_EQ(map.samples.size(), std::size_t(map.width) * std::size_t(map.height));
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(ExitCode::InvalidInput));
        EXPECT_STRNE(error.what(), "");
    }
}

TEST(HostileMap, DamagedBytesNeverCrash) {
    const TempFolder folder;
    std::mt19937 random(1);
    for (const Sample& sample : smallFiles()) {
        SCOPED_TRACE(sample.name);
        for (int round = 0; round < 400; ++round) {
            std::string bytes = sample.bytes;
            for (int flips = 1 + round % 4; flips > 0; --flips) bytes[random() % bytes.size()] = char(random());
            if (sample.name.ends_with(".png")) repairPng(bytes);
            readDamaged(folder.write(sample.name, bytes));
        }
    }
}

TEST(HostileColour, DamagedBytesNeverCrash) {
    const TempFolder folder;
    std::mt19937 random(2);
    for (const Sample& sample : colourFiles()) {
        SCOPED_TRACE(sample.name);
        for (int round = 0; round < 400; ++round) {
            std::string bytes = sample.bytes;
            for (int flips = 1 + round % 4; flips > 0; --flips) bytes[random() % bytes.size()] = char(random());
            if (sample.name.ends_with(".png")) repairPng(bytes);
            const auto path = folder.write(sample.name, bytes);
            try {
                const RawColour image = readRawColour(path);
                EXPECT_EQ(image.srgb.size() + image.linear.size(),
                          3 * std::size_t(image.width) * std::size_t(image.height));
            } catch (const Error& error) {
                EXPECT_EQ(int(error.code()), int(ExitCode::InvalidInput));
            }
        }
    }
}

Image smallImage() {
    Image image;
    image.data = image.display = {0, 0, 5, 4};
    for (float& value : image.addFloat("R").floats()) value = 0.25f;
    for (std::uint32_t& value : image.addUint("id").uints()) value = 3;
    return image;
}

TEST(HostileExr, EveryTruncationIsRefused) {
    const TempFolder folder;
    const std::filesystem::path path = folder.path() / "small.exr";
    writeExr(path, smallImage(), {});
    const std::string bytes = readBytes(path);
    EXPECT_NO_THROW(readExr(path));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        SCOPED_TRACE(length);
        const auto cut = folder.write("small.exr", bytes.substr(0, length));
        EXPECT_NE(messageOf(ExitCode::InvalidInput, [&] { readExr(cut); }), "");
    }
}

}  // namespace
}  // namespace dsphere::test
