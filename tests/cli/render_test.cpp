// What `render` writes, and where.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace dsphere::test {
namespace {

class RenderTest : public CliTest {
  protected:
    /// Renders the planet into `name` with further options and reads the picture back.
    Image render(const std::string& name, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"render", "planet.pbrt", "-o", name});
        Outcome outcome = run(options);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return readExr(path(name));
    }

    static double meanDifference(const Image& a, const Image& b) {
        const auto& x = a.at("R").floats();
        const auto& y = b.at("R").floats();
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += std::abs(double(x[i]) - y[i]);
        return sum / double(x.size());
    }
};

TEST_F(RenderTest, WritesTheFilmsOwnFile) {
    Outcome outcome = run({"render", "planet.pbrt"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "standard output is for data";
    for (const char* part : {"picture  ", "film.exr", "device   ", "time     ", "million camera rays a second"})
        EXPECT_TRUE(holds(outcome.err, part));
    Image image = readExr(path("film.exr"));
    EXPECT_EQ(image.data, (Box{0, 0, kWidth, kHeight}));
    EXPECT_EQ(image.channels.size(), 4u) << "R, G, B and A";
}

TEST_F(RenderTest, OutfileGoesBeforeTheFilmsFile) {
    EXPECT_EQ(run({"render", "planet.pbrt", "--outfile", "mine.exr"}).code, 0);
    EXPECT_TRUE(exists("mine.exr"));
    EXPECT_FALSE(exists("film.exr"));
}

TEST_F(RenderTest, ReplacesAnOldPicture) {
    folder_.write("old.exr", "old");
    render("old.exr");
    EXPECT_EQ(folder_.entries(), 3u) << "a temporary was left";
}

TEST_F(RenderTest, WritesPng) {
    EXPECT_EQ(run({"render", "planet.pbrt", "-o", "a.png"}).code, 0);
    EXPECT_EQ(readBytes(path("a.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST_F(RenderTest, ExposureBrightensAPng) {
    EXPECT_EQ(run({"render", "planet.pbrt", "-o", "a.png"}).code, 0);
    EXPECT_EQ(run({"render", "planet.pbrt", "-o", "b.png", "--exposure", "1"}).code, 0);
    EXPECT_NE(readBytes(path("a.png")), readBytes(path("b.png")));
}

TEST_F(RenderTest, SceneFromStandardInput) {
    render("file.exr");
    Launch launch{.arguments = {"render", "-", "-o", "stdin.exr"}};
    launch.input = planet();
    Outcome outcome = run(launch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readExr(path("stdin.exr")).at("R").floats(), readExr(path("file.exr")).at("R").floats());
}

TEST_F(RenderTest, MapIsFoundBesideTheScene) {
    Launch launch{.arguments = {"render", path("planet.pbrt").string(), "--quick"}};
    launch.folder = cache_.path();
    launch.environment = {"XDG_CACHE_HOME=" + cache_.path().string()};
    EXPECT_EQ(test::launch(launch).code, 0);
    EXPECT_TRUE(std::filesystem::exists(cache_.path() / "film.exr")) << "the film's name is used as written";
}

TEST_F(RenderTest, Resolution) {
    EXPECT_EQ(render("a.exr", {"--resolution", "30,20"}).data, (Box{0, 0, 30, 20}));
    EXPECT_EQ(render("b.exr", {"--quick"}).data, (Box{0, 0, kWidth / 4, kHeight / 4}));
}

TEST_F(RenderTest, CropIsAPartOfTheWholePicture) {
    Image whole = render("whole.exr", {"--aov", "all"});
    Image crop = render("crop.exr", {"--aov", "all", "--cropwindow", "0.3,0.8,0.25,0.6"});
    EXPECT_EQ(crop.display, (Box{0, 0, kWidth, kHeight}));
    ASSERT_EQ(crop.data, (Box{20, 12, 52, 29}));  // pbrt: from ceil(x0 width) to before ceil(x1 width)
    for (const Channel& channel : crop.channels)
        for (int y = crop.data.y0; y < crop.data.y1; ++y)
            for (int x = crop.data.x0; x < crop.data.x1; ++x) {
                auto i = std::size_t((y - crop.data.y0) * crop.data.width() + x - crop.data.x0);
                auto k = std::size_t(y * kWidth + x);
                const Channel& same = whole.at(channel.name);
                ASSERT_EQ(channel.floats()[i], same.floats()[k]) << channel.name << " at " << x << ", " << y;
            }
}

TEST_F(RenderTest, SeedDecidesTheSamples) {
    Image first = render("a.exr", {"--seed", "7"}), again = render("b.exr", {"--seed", "7"});
    Image other = render("c.exr", {"--seed", "8"});
    for (const char* name : {"R", "G", "B"}) EXPECT_EQ(first.at(name).floats(), again.at(name).floats());
    EXPECT_NE(first.at("R").floats(), other.at("R").floats());
    EXPECT_LT(meanDifference(first, other), 0.01);
}

TEST_F(RenderTest, MoreSamplesChangeOnlyTheNoise) {
    Image one = render("a.exr", {"--spp", "1"}), four = render("b.exr", {"--spp", "4"});
    Image many = render("c.exr", {"--spp", "256"}), others = render("d.exr", {"--spp", "256", "--seed", "3"});
    EXPECT_LT(meanDifference(four, many), meanDifference(one, many));
    EXPECT_LT(meanDifference(many, others), 0.2 * meanDifference(one, many));
}

TEST_F(RenderTest, AovsDoNotChangeTheColour) {
    EXPECT_EQ(render("a.exr").at("G").floats(), render("b.exr", {"--aov", "t,N"}).at("G").floats());
}

TEST_F(RenderTest, JsonIsAllOfStandardOutput) {
    Outcome outcome = run({"render", "planet.pbrt", "--json", "--spp", "3"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    nlohmann::json json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("picture"), "film.exr");
    EXPECT_FALSE(json.at("device").get<std::string>().empty());
    EXPECT_FALSE(json.at("driver").get<std::string>().empty());
    EXPECT_EQ(json.at("camera_rays").get<int>(), 3 * kWidth * kHeight);
    EXPECT_GT(json.at("device_seconds").get<double>(), 0.0);
    EXPECT_GE(json.at("seconds").get<double>(), json.at("device_seconds").get<double>());
    EXPECT_NEAR(json.at("camera_rays_per_second").get<double>() * json.at("device_seconds").get<double>(),
                3.0 * kWidth * kHeight, 1.0);
    EXPECT_GE(json.at("map_bytes").get<int>(), 64 * 32 * 4);
    EXPECT_EQ(json.at("image_bytes"), 0) << "the scene has no image";
    EXPECT_EQ(json.at("maps"), nlohmann::json::parse(R"([{"path":"map.pgm","nodata_texels":0}])"));
    EXPECT_LE(json.at("retried_pixels").get<int>(), 3 * kWidth * kHeight / 50) << "few need full precision";
    EXPECT_EQ(json.at("given_up_pixels"), 0);
    EXPECT_EQ(json.at("tiles_read"), 0) << "the map is held in memory";
    EXPECT_EQ(json.at("non_finite_pixels"), 0);
    EXPECT_EQ(json.size(), 14u) << "a field that this test does not know: " << outcome.out;
}

TEST_F(RenderTest, QuietSaysNothing) {
    Outcome outcome = run({"render", "planet.pbrt", "--quiet"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(exists("film.exr"));
}

TEST_F(RenderTest, VerboseSaysMore) {
    EXPECT_TRUE(holds(run({"render", "planet.pbrt", "--verbose"}).err, "maps     "));
}

TEST_F(RenderTest, EveryMarcherRenders) {
    for (const char* marcher : {"naive", "naive-shell", "lipschitz"})
        EXPECT_EQ(run({"render", "planet.pbrt", "--quick", "--marcher", marcher}).code, 0) << marcher;
}

TEST_F(RenderTest, DetailIsExactByDefault) {
    EXPECT_EQ(run({"render", "planet.pbrt", "--aov", "t", "-o", "plain.exr"}).code, 0);
    EXPECT_EQ(run({"render", "planet.pbrt", "--aov", "t", "--detail", "exact", "-o", "exact.exr"}).code, 0);
    EXPECT_EQ(run({"render", "planet.pbrt", "--aov", "t", "--detail", "0.5", "-o", "half.exr"}).code, 0);
    EXPECT_EQ(run({"diff", "plain.exr", "exact.exr", "--threshold", "0"}).code, 0);
}

TEST_F(RenderTest, ValidationIsClean) {
    Outcome outcome = run({"render", "planet.pbrt", "--validation", "--aov", "all"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("VUID"), std::string::npos) << outcome.err;
}

// Lavapipe's images end at 2 GiB: the picture would take four layers of a GB.
TEST_F(RenderTest, APictureThatTheDeviceCannotHoldIsRenderedInParts) {
    expectFailure(run({"render", "planet.pbrt", "-o", "a.exr", "--device", "cpu", "--resolution", "16000,16000"}), 1,
                  "render it in parts: --tile I/N and dsphere merge, or --cropwindow");
    EXPECT_FALSE(exists("a.exr"));
}

}  // namespace
}  // namespace dsphere::test
