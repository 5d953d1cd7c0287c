#include "image/picture.h"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <limits>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

/// A crop of 6x4 pixels at (3, 2) of a 20x10 picture.
Image croppedImage() {
    Image image;
    image.data = {3, 2, 9, 6};
    image.display = {0, 0, 20, 10};
    image.addFloat("P.X").floats() = floatRamp(image.pixelCount());
    image.addFloat("t").floats().front() = std::numeric_limits<float>::infinity();
    std::vector<std::uint32_t>& ids = image.addUint("id").uints();
    for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = 0xffffffffu - std::uint32_t(k);
    return image;
}

/// One row of greys.
Image greyRow(const std::vector<float>& values) {
    Image image;
    image.data = image.display = {0, 0, int(values.size()), 1};
    for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats() = values;
    return image;
}

TEST(Exr, KeepsChannelsAndWindows) {
    const TempFolder folder;
    const Image written = croppedImage();
    writeExr(folder.path() / "a.exr", written, {});
    const Image read = readExr(folder.path() / "a.exr");
    EXPECT_EQ(read.data, written.data);
    EXPECT_EQ(read.display, written.display);
    ASSERT_EQ(read.channels.size(), 3u);
    for (const Channel& channel : written.channels) EXPECT_EQ(read.at(channel.name).pixels, channel.pixels);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, IntegersAreWrittenAsFloatsWhereThoseHoldThem) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 3, 1};
    image.addUint("held").uints() = {0, 1u << 24, 0x80000000u};
    image.addUint("lost").uints() = {0, 1, (1u << 24) + 1};
    writeExr(folder.path() / "a.exr", image, {});
    const Image read = readExr(folder.path() / "a.exr");
    EXPECT_EQ(read.at("held").floats(), (std::vector<float>{0.0f, 16777216.0f, 2147483648.0f}));
    EXPECT_EQ(read.at("lost").uints(), image.at("lost").uints());
}

TEST(Exr, FirstRowIsOnTop) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 1, 3};
    image.addFloat("Y").floats() = {1, 2, 3};
    writeExr(folder.path() / "a.exr", image, {});
    const Imf::InputFile file((folder.path() / "a.exr").c_str());
    EXPECT_EQ(file.header().lineOrder(), Imf::INCREASING_Y);
    EXPECT_EQ(readExr(folder.path() / "a.exr").at("Y").floats(), (std::vector<float>{1, 2, 3}));
}

TEST(Exr, KeepsMetadata) {
    const TempFolder folder;
    std::array<float, 16> matrix;
    for (std::size_t k = 0; k < 16; ++k) matrix[k] = float(k);
    writeExr(
        folder.path() / "a.exr", croppedImage(),
        {{"software", "dsphere"}, {"samplesPerPixel", 16}, {"renderTimeSeconds", 0.5f}, {"worldToCamera", matrix}});
    const Imf::InputFile file((folder.path() / "a.exr").c_str());
    const Imf::Header& header = file.header();
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("software").value(), "dsphere");
    EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("samplesPerPixel").value(), 16);
    EXPECT_EQ(header.typedAttribute<Imf::FloatAttribute>("renderTimeSeconds").value(), 0.5f);
    const Imath::M44f& read = header.typedAttribute<Imf::M44fAttribute>("worldToCamera").value();
    for (int k = 0; k < 16; ++k) EXPECT_EQ(read[k / 4][k % 4], float(k));
}

/// A file of one channel with 2x2 pixels, as another program writes it.
std::filesystem::path foreignExr(const TempFolder& folder, const Imf::Channel& channel, const Imf::Slice& slice) {
    const std::filesystem::path path = folder.path() / "foreign.exr";
    Imf::Header header(2, 2);
    header.channels().insert("Y", channel);
    Imf::FrameBuffer buffer;
    buffer.insert("Y", slice);
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(2);
    return path;
}

TEST(Exr, WidensHalves) {
    const TempFolder folder;
    std::array<half, 4> halves{half(0.1f), half(-2.0f), half(65504.0f), half(0.0f)};
    const auto path = foreignExr(folder, Imf::Channel(Imf::HALF),
                                 Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data()), 2, 4));
    EXPECT_EQ(readExr(path).at("Y").floats(), (std::vector<float>{float(half(0.1f)), -2.0f, 65504.0f, 0.0f}));
}

TEST(Exr, RefusesSubsampledChannels) {
    const TempFolder folder;
    float value = 1.0f;
    const auto path = foreignExr(folder, Imf::Channel(Imf::FLOAT, 2, 2),
                                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&value), 4, 4, 2, 2));
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { readExr(path); }), "channel Y is subsampled"));
}

TEST(Exr, ReadingRefusesWhatIsNone) {
    const TempFolder folder;
    const auto refusal = [&](const std::filesystem::path& path) {
        return messageOf(ExitCode::InvalidInput, [&] { readExr(path); });
    };
    EXPECT_TRUE(holds(refusal(folder.path() / "missing.exr"), "missing.exr"));
    EXPECT_TRUE(holds(refusal(folder.write("text.exr", "no picture at all")), "text.exr"));
    EXPECT_TRUE(holds(refusal(folder.path()), folder.path().string()));
}

TEST(Png, IsSrgb) {
    const TempFolder folder;
    const float nan = std::nanf("");
    writePng(folder.path() / "a.png",
             greyRow({0.0f, 0.5f, 1.0f, 2.0f, -1.0f, nan, std::numeric_limits<float>::infinity(),
                      -std::numeric_limits<float>::infinity(), 0.001f, 0.0031308f, 0.2158605f}));
    const RawMap map = readRawMap(folder.path() / "a.png");
    EXPECT_EQ(map.type, "8-bit colour PNG");
    EXPECT_EQ(map.samples, (std::vector<float>{0, 188, 255, 255, 0, 0, 255, 0, 3, 10, 128}));
}

// Of a picture in double: floats about the place where each level begins, and a sweep of all orders of magnitude.
TEST(Png, EveryValueGetsTheNearestLevel) {
    const TempFolder folder;
    std::vector<float> values;
    for (int level = 1; level < 256; ++level) {
        const double encoded = (level - 0.5) / 255.0;
        const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        float value = std::nextafter(std::nextafter(float(linear), 0.0f), 0.0f);
        for (int step = 0; step < 5; ++step, value = std::nextafter(value, 1.0f)) values.push_back(value);
    }
    for (float value = 1e-30f; value < 1.0f; value *= 1.003f) values.push_back(value);
    writePng(folder.path() / "a.png", greyRow(values));
    const RawMap map = readRawMap(folder.path() / "a.png");
    ASSERT_EQ(map.samples.size(), values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double linear = values[k];
        const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        EXPECT_EQ(map.samples[k], std::floor(255.0 * encoded + 0.5)) << values[k];
    }
}

TEST(Png, ExposureIsInStops) {
    const TempFolder folder;
    writePng(folder.path() / "a.png", greyRow({0.25f, 1.0f, 0.0f}), {1.0});
    EXPECT_EQ(readRawMap(folder.path() / "a.png").samples, (std::vector<float>{188, 255, 0}));
    writePng(folder.path() / "a.png", greyRow({0.25f, 1.0f, 0.0f}), {-1.0});
    EXPECT_EQ(readRawMap(folder.path() / "a.png").samples, (std::vector<float>{99, 188, 0}));
}

TEST(Png, ToneCurvesGoBeforeSrgb) {
    const TempFolder folder;
    const float nan = std::nanf(""), most = std::numeric_limits<float>::max();
    const Image image = greyRow({0.0f, 0.18f, 1.0f, 8.0f, -1.0f, nan, std::numeric_limits<float>::infinity(), most});
    const auto codes = [&](const Tone& tone) {
        writePng(folder.path() / "a.png", image, tone);
        return readRawMap(folder.path() / "a.png").samples;
    };
    // sRGB of 0.1525, 1/2 and 8/9; of 0.2670, 0.8038 and 1.0036, cut.
    EXPECT_EQ(codes({0.0, ToneCurve::Reinhard}), (std::vector<float>{0, 109, 188, 242, 0, 0, 255, 255}));
    EXPECT_EQ(codes({0.0, ToneCurve::Aces}), (std::vector<float>{0, 141, 232, 255, 0, 0, 255, 255}));
    EXPECT_EQ(codes({3.0, ToneCurve::Reinhard})[2], 242.0f) << "exposure comes first";
}

TEST(Png, KeepsColoursAndRowsApart) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 1, 3};
    image.addFloat("B").floats() = {1, 0, 0};
    image.addFloat("R").floats() = {0, 0.5f, 0};
    image.addFloat("G").floats() = {0, 0, 0};
    image.addUint("id");
    writePng(folder.path() / "a.png", image);
    EXPECT_EQ(readRawMap(folder.path() / "a.png").samples, (std::vector<float>{85, float(188.0 / 3.0), 0}));
}

// On the way into a PNG colours are divided by alpha; no light is where nothing is covered.
TEST(Png, AlphaIsStraight) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 4, 1};
    for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats() = {0.5f, 0.25f, 0.0f, 0.3f};
    image.addFloat("A").floats() = {1.0f, 0.5f, 0.0f, 0.0f};
    writePng(folder.path() / "a.png", image);
    const Image read = readPngPicture(folder.path() / "a.png");  // on black
    const std::vector<float>& green = read.at("G").floats();
    EXPECT_NEAR(green[0], 0.5f, 0.003f);
    EXPECT_NEAR(green[1], 0.25f, 0.003f);
    EXPECT_EQ(green[2], 0.0f);
    EXPECT_EQ(green[3], 0.0f);
}

TEST(Picture, ExtensionChooses) {
    const TempFolder folder;
    const Image image = greyRow({0.5f});
    writePicture(folder.path() / "a.EXR", image, {});
    EXPECT_EQ(readExr(folder.path() / "a.EXR").at("R").floats(), (std::vector<float>{0.5f}));
    writePicture(folder.path() / "a.png", image, {}, {-100.0});
    EXPECT_EQ(readRawMap(folder.path() / "a.png").samples, (std::vector<float>{0}));
    for (const char* name : {"a.jpg", "a", "exr"})
        EXPECT_TRUE(holds(messageOf(ExitCode::Usage, [&] { writePicture(folder.path() / name, image, {}); }), name));
    EXPECT_EQ(folder.entries(), 2u);
}

/// Each file of the process may grow to `bytes` only, as on a full disk.
class FileLimit {
  public:
    explicit FileLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST(Picture, AFailedWriteLeavesTheOldTarget) {
    const TempFolder folder;
    Image image;
    image.data = image.display = {0, 0, 64, 64};
    for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats() = floatRamp(64 * 64);
    for (const char* name : {"a.exr", "a.png"}) {
        const std::filesystem::path path = folder.write(name, "the old picture");
        // In the header and in the pixels.
        for (const rlim_t limit : {10, 500}) {
            std::string message;
            {
                const FileLimit full(limit);
                message = messageOf(ExitCode::Failure, [&] { writePicture(path, image, {}); });
            }
            EXPECT_TRUE(holds(message, name));
            EXPECT_TRUE(holds(message, "File too large"));
        }
        EXPECT_EQ(readBytes(path), "the old picture");
    }
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(Picture, AFailureNamesTheReason) {
    const TempFolder folder;
    const Image image = greyRow({0.5f});
    for (const char* extension : {".exr", ".png"}) {
        const auto below = folder.path() / "none" / ("a" + std::string(extension));
        EXPECT_TRUE(holds(messageOf(ExitCode::Failure, [&] { writePicture(below, image, {}); }), "No such file"));
        const auto taken = folder.path() / ("taken" + std::string(extension));
        std::filesystem::create_directory(taken);
        EXPECT_TRUE(holds(messageOf(ExitCode::Failure, [&] { writePicture(taken, image, {}); }), "not a regular file"));
    }
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(Picture, ReplacesAnOldTarget) {
    const TempFolder folder;
    const std::filesystem::path path = folder.write("a.exr", "the old picture");
    writeExr(path, greyRow({0.5f}), {});
    EXPECT_EQ(readExr(path).at("G").floats(), (std::vector<float>{0.5f}));
    EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace dsphere::test
