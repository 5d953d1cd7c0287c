// The share of each pixel that shapes cover: in every EXR, and in a PNG on demand.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <png.h>

#include <algorithm>
#include <cmath>

namespace dsphere::test {
namespace {

class AlphaTest : public CliTest {
  protected:
    AlphaTest() {
        folder_.write("sky.pbrt", planet() + "LightSource \"infinite\" \"rgb L\" [.2 .3 .4]\n");
        std::string soft = planet();
        soft.insert(soft.find("Sampler"), "PixelFilter \"gaussian\" \"float xradius\" 2 \"float yradius\" 2\n");
        folder_.write("soft.pbrt", soft);
    }

    void render(std::vector<std::string> words) {
        words.insert(words.begin(), "render");
        Outcome outcome = run(words);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    std::vector<float> alphaOf(const std::string& scene, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {scene, "-o", "a.exr"});
        render(options);
        return readExr(path("a.exr")).at("A").floats();
    }
    /// The bytes of a PNG's pixels as they are stored.
    std::vector<png_byte> rgbaOf(const std::string& name) {
        png_image image = {};
        image.version = PNG_IMAGE_VERSION;
        EXPECT_TRUE(png_image_begin_read_from_file(&image, path(name).c_str()));
        EXPECT_TRUE(image.format & PNG_FORMAT_FLAG_ALPHA) << name;
        image.format = PNG_FORMAT_RGBA;
        std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
        EXPECT_TRUE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr));
        return bytes;
    }
};

// With one sample a pixel, alpha is whether its ray hits; with many, shares in between appear along the limb alone.
TEST_F(AlphaTest, IsTheShareOfSamplesThatHit) {
    render({"planet.pbrt", "-o", "ids.exr", "--aov", "id", "--spp", "0"});
    const Image ids = readExr(path("ids.exr"));
    const std::vector<float> alpha = alphaOf("planet.pbrt", {"--spp", "64"});
    int covered = 0, empty = 0, between = 0, agreeing = 0;
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        EXPECT_EQ(alpha[i] * 64.0f, std::round(alpha[i] * 64.0f)) << "pixel " << i;
        ++(alpha[i] == 1.0f ? covered : alpha[i] == 0.0f ? empty : between);
        agreeing += (alpha[i] >= 0.5f) == (ids.at("id").floats()[i] > 0.0f);
    }
    EXPECT_GT(covered, 500);
    EXPECT_GT(empty, 500);
    EXPECT_GT(between, 50);
    EXPECT_GT(agreeing, int(alpha.size()) - between) << "where a pixel is covered or empty its centre is";
}

TEST_F(AlphaTest, IsFilteredAsColourIs) {
    const auto between = [](const std::vector<float>& alpha) {
        return std::ranges::count_if(alpha, [](float a) { return a > 0.0f && a < 1.0f; });
    };
    EXPECT_GT(between(alphaOf("soft.pbrt", {"--spp", "64"})), 2 * between(alphaOf("planet.pbrt", {"--spp", "64"})));
}

// A sphere that shines with radiance 1 before nothing: its colour is what it covers, under negative weights too.
TEST_F(AlphaTest, IsWeightedAsColourIs) {
    for (const std::string filter : {"gaussian", "mitchell", "sinc"}) {
        folder_.write("lamp.pbrt",
                      "LookAt 0 0 4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
                      "PixelFilter \"" +
                          filter +
                          "\" WorldBegin\n"
                          "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] Shape \"sphere\"\n");
        render({"lamp.pbrt", "-o", "lamp.exr", "--spp", "64"});
        const Image picture = readExr(path("lamp.exr"));
        EXPECT_EQ(picture.at("A").floats(), picture.at("R").floats()) << filter;
        const bool overshoots = std::ranges::max(picture.at("A").floats()) > 1.0f;  // at edges
        EXPECT_EQ(overshoots, filter != "gaussian") << filter;
        render({"lamp.pbrt", "-o", "lamp.png", "--spp", "64", "--alpha"});
        // The mean of 64 weights is 1 to within some percent; what is above 1 is cut and does not wrap around.
        EXPECT_GE(int(rgbaOf("lamp.png")[4 * (32 * 16 + 16) + 3]), 245) << filter;
    }
}

TEST_F(AlphaTest, ADistantLightIsBehindWhatIsEmpty) {
    const std::vector<float> alpha = alphaOf("sky.pbrt"), plain = alphaOf("planet.pbrt");
    EXPECT_EQ(alpha, plain) << "a sky covers nothing";
    render({"sky.pbrt", "-o", "shown.exr"});
    render({"sky.pbrt", "-o", "hidden.exr", "--alpha"});
    const Image shown = readExr(path("shown.exr")), hidden = readExr(path("hidden.exr"));
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        const float sky = 0.4f * (1.0f - alpha[i]);
        EXPECT_NEAR(shown.at("B").floats()[i], hidden.at("B").floats()[i] + sky, 1e-6) << "pixel " << i;
        if (alpha[i] == 0.0f) {
            EXPECT_EQ(hidden.at("B").floats()[i], 0.0f);
        }
    }
}

// PNG's colours are not multiplied by alpha: at the limb they are as bright as the planet, not darker.
TEST_F(AlphaTest, PngsHoldStraightAlpha) {
    render({"sky.pbrt", "-o", "a.png", "--alpha"});
    render({"sky.pbrt", "-o", "a.exr", "--alpha"});
    const std::vector<png_byte> pixels = rgbaOf("a.png");
    const Image image = readExr(path("a.exr"));
    const auto encoded = [](double x) {
        return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(std::min(x, 1.0), 1.0 / 2.4) - 0.055);
    };
    int partial = 0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        const double alpha = double(image.at("A").floats()[i]);
        partial += alpha > 0.0 && alpha < 1.0;
        EXPECT_NEAR(pixels[4 * i + 3], 255.0 * alpha, 0.51);
        const double green = alpha > 0.0 ? double(image.at("G").floats()[i]) / alpha : 0.0;
        EXPECT_NEAR(pixels[4 * i + 1], encoded(green), 0.51) << "pixel " << i;
    }
    EXPECT_GT(partial, 20);
    render({"sky.pbrt", "-o", "b.png"});
    png_image plain = {};
    plain.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&plain, path("b.png").c_str()));
    EXPECT_FALSE(plain.format & PNG_FORMAT_FLAG_ALPHA) << "without --alpha a PNG has three channels";
    png_image_free(&plain);
}

TEST_F(AlphaTest, ResumingKeepsItBitForBit) {
    for (const char* before : {"2", "3"}) {
        render({"sky.pbrt", "-o", "part.exr", "--spp", before});
        render({"sky.pbrt", "-o", "resumed.exr", "--spp", "7", "--resume", "part.exr"});
        render({"sky.pbrt", "-o", "whole.exr", "--spp", "7"});
        EXPECT_EQ(readExr(path("resumed.exr")).at("A").floats(), readExr(path("whole.exr")).at("A").floats()) << before;
    }
    expectFailure(run({"render", "sky.pbrt", "-o", "b.exr", "--spp", "9", "--resume", "whole.exr", "--alpha"}), 3,
                  "--alpha");
}

// Versions before alpha wrote none, and integers as such.
TEST_F(AlphaTest, APictureWithoutAlphaGoesOnWithoutIt) {
    render({"planet.pbrt", "-o", "old.exr", "--spp", "2", "--aov", "id"});
    Image image = readExr(path("old.exr"));
    std::erase_if(image.channels, [](const Channel& channel) { return channel.name == "A" || channel.name == "id"; });
    image.addUint("id").uints().assign(image.pixelCount(), 0xffffffffu);
    writeExr(path("old.exr"), image, readExrMetadata(path("old.exr")));
    ASSERT_FALSE(readExr(path("old.exr")).at("id").isFloat());
    render({"planet.pbrt", "-o", "new.exr", "--spp", "4", "--resume", "old.exr"});
    const Image resumed = readExr(path("new.exr"));
    EXPECT_EQ(resumed.find("A"), nullptr);
    render({"planet.pbrt", "-o", "whole.exr", "--spp", "4"});
    EXPECT_EQ(resumed.at("G").floats(), readExr(path("whole.exr")).at("G").floats());
}

}  // namespace
}  // namespace dsphere::test
