// A heightmap given in place of a scene.

#include "image/picture.h"
#include "image/rawmap.h"
#include "tests/cli/fixture.h"
#include "tests/image/encoders.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace dsphere::test {
namespace {

using nlohmann::json;

class HeightmapTest : public CliTest {
  protected:
    Image renderAll(const std::string& name) {
        Outcome outcome = run({"render", name, "--resolution", "320,180", "--spp", "1", "--aov", "all", "-o", "a.exr"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return readExr(path("a.exr"));
    }
};

// Values from 1000 to 3000 of 65535: the lowest texel lies at radius 1, the highest at 1.05.
TEST_F(HeightmapTest, SpansItsOwnRange) {
    RawMap map = constantMap(64, 32, 0.0f);
    for (int k = 0; k < 64 * 32; ++k) map.samples[std::size_t(k)] = k % 64 < 32 ? 1000.0f : 3000.0f;
    writePgm16(path("range.pgm"), map);
    Image image = renderAll("range.pgm");
    float least = 2.0f, greatest = 0.0f;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        if (image.at("id").floats()[i] == 0.0f) continue;
        float x = image.at("P.X").floats()[i], y = image.at("P.Y").floats()[i], z = image.at("P.Z").floats()[i];
        least = std::min(least, std::sqrt(x * x + y * y + z * z));
        greatest = std::max(greatest, std::sqrt(x * x + y * y + z * z));
        EXPECT_EQ(image.at("Albedo.R").floats()[i], 0.5f);
    }
    EXPECT_NEAR(least, 1.0f, 1e-6f);
    EXPECT_NEAR(greatest, 1.05f, 1e-6f);
}

// It fills the picture's height but for a margin, and u, which grows eastward, grows to the right.
TEST_F(HeightmapTest, IsFramedWithEastToTheRight) {
    writePgm16(path("flat.pgm"), constantMap(8, 4, 7.0f));
    Image image = renderAll("flat.pgm");
    const auto& id = image.at("id").floats();
    for (int x = 0; x < 320; ++x) EXPECT_EQ(id[std::size_t(x)] + id[std::size_t(179 * 320 + x)], 0.0f) << x;
    int high = 0;
    for (int y = 0; y < 180; ++y) high += id[std::size_t(y * 320 + 160)] != 0.0f;
    EXPECT_GT(high, 140);
    const auto& u = image.at("u").floats();
    EXPECT_GT(u[90 * 320 + 180], u[90 * 320 + 140]);
    EXPECT_GT(u[90 * 320 + 140], 0.4f);
    EXPECT_GT(image.at("R").floats()[90 * 320 + 160], 0.2f) << "the sun shines on what is seen";
}

TEST_F(HeightmapTest, ContentDecidesWhateverTheName) {
    std::filesystem::copy_file(path("map.pgm"), path("odd.pbrt"));
    folder_.write("scene.txt", planet());
    EXPECT_EQ(run({"render", "odd.pbrt", "--quick", "-o", "a.exr"}).code, 0);
    EXPECT_EQ(run({"render", "scene.txt", "--quick", "-o", "b.exr"}).code, 0);
    EXPECT_EQ(json::parse(run({"info", "odd.pbrt", "--json"}).out)["type"], "16-bit PGM");
    EXPECT_TRUE(json::parse(run({"info", "scene.txt", "--json"}).out).contains("camera"));
}

TEST_F(HeightmapTest, VerifiesAndTakesTheOptionsOfScenes) {
    Outcome outcome = run({"verify", "map.pgm", "--resolution", "200,150", "--exaggeration", "2", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json report = json::parse(outcome.out);
    EXPECT_EQ(report["scene"], "map.pgm");
    EXPECT_GT(report["hits"], 5000);
}

TEST_F(HeightmapTest, UnknownTexelsAreFilledAndCounted) {
    std::vector<float> samples = {1.0f, NAN, 2.0f, 4.0f, 3.0f, 2.0f, NAN, 4.0f};
    folder_.write("gaps.pfm", pfmFile(4, 2, samples, true));
    Outcome outcome = run({"render", "gaps.pfm", "--quick", "--json", "-o", "a.exr"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "nodata   2 of 8 texels of gaps.pfm"));
    EXPECT_EQ(json::parse(outcome.out)["maps"][0]["nodata_texels"], 2);
}

TEST_F(HeightmapTest, WhatIsNoHeightIsWarnedOf) {
    folder_.write("endless.pfm", pfmFile(2, 1, {1.0f, std::numeric_limits<float>::infinity()}, true));
    folder_.write("endless.pbrt", "WorldBegin\nShape \"displacedsphere\" \"string displacementmap\" \"endless.pfm\"\n");
    Outcome outcome = run({"render", "endless.pbrt", "--quick", "-o", "a.exr"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err,
                      "dsphere: warning: endless.pfm: 1 of 2 texels hold no number that could be a height, "
                      "the first inf at column 1, row 0: they count as unknown"));
    folder_.write("colours.ppm", pnmFile(2, 1, 255, {1, 2, 4, 90, 7, 7}));
    EXPECT_TRUE(holds(run({"render", "colours.ppm", "--quick", "-o", "a.exr"}).err,
                      "dsphere: warning: colours.ppm: its red, green and blue channels differ"));
}

TEST_F(HeightmapTest, AScenesNodataIsCounted) {
    folder_.write("map.pgm", pnmFile(4, 2, 65535, {1, 9, 2, 9, 3, 4, 5, 6}));
    folder_.write("gaps.pbrt", planet("\"float nodata\" 9"));
    EXPECT_EQ(json::parse(run({"info", "gaps.pbrt", "--json"}).out)["maps"][0]["nodata_texels"], 2);
    EXPECT_TRUE(holds(run({"render", "gaps.pbrt", "--quick"}).err, "nodata   2 of 8 texels of map.pgm"));
    EXPECT_EQ(run({"render", "gaps.pbrt", "--quick", "--quiet"}).err, "");
}

// Mesa's images end at 16384. Wider maps are cut into tiles, but under a wide blur.
TEST_F(HeightmapTest, WiderThanTheDevicesImages) {
    std::string samples;
    for (int j = 0; j < 256; ++j)
        for (int i = 0; i < 16385; ++i) samples += char(128 + (i * 7 / 900 + j * 3 / 20) % 64);
    folder_.write("wide.pgm", "P5\n16385 256\n255\n" + samples);
    for (const char* filter : {"bilinear", "bspline"}) {
        const Outcome outcome = run({"verify", "wide.pgm", "--maxdispl", "5", "--sample", "2000", "--json", "--device",
                                     "cpu", "--filter", filter});
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
    expectFailure(run({"render", "wide.pgm", "--quick", "--device", "cpu", "--blur", "9"}), 3,
                  "error: wide.pgm: a map of 16385x256 texels takes an image of 16385x258, but those of llvmpipe");
}

TEST_F(HeightmapTest, Errors) {
    expectFailure(run({"render", "missing.png"}), 3, "error: missing.png: cannot be read: No such file");
    folder_.write("cut.pgm", "P5\n64 32\n65535\nxx");
    expectFailure(run({"render", "cut.pgm"}), 3, "error: cut.pgm: 16-bit PGM of 64x32 texels: truncated");
    folder_.write("text.png", "not a picture");
    expectFailure(run({"verify", "text.png"}), 3, "error: text.png: unknown format");
    folder_.write("noise.bin", std::string("\x01\x02\x03\x04\x00", 5));
    expectFailure(run({"render", "noise.bin"}), 3, "error: noise.bin: unknown format: it begins with the bytes 01 02");
    folder_.write("photo.jpg", std::string("\xff\xd8\xff\xe0", 4));
    expectFailure(run({"render", "photo.jpg"}), 3, "JPEG image, which loses heights");
    writePgm16(path("steep.pgm"), fractalMap(64, 32));
    expectFailure(run({"render", "steep.pgm", "--exaggeration", "-30"}), 3, "error: steep.pgm: the displaced radius");
}

}  // namespace
}  // namespace dsphere::test
