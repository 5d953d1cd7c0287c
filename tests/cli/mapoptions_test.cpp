// What a scene file would say of a map, as options for a map in place of a scene.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

class MapOptionsTest : public CliTest {
  protected:
    Image render(Words words) {
        words.insert(words.begin(), "render");
        words.insert(words.end(), {"-o", "a.exr", "--resolution", "64,48", "--spp", "1"});
        Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return readExr(path("a.exr"));
    }
    /// The scene that `render map.pgm` shows, with these parameters of its Shape.
    static std::string sceneOf(const std::string& parameters) {
        return "Scale -1 1 1\n"
               "LookAt 0.6 1.05 3.19   0 0 0   0 1 0\n"
               "Camera \"perspective\" \"float fov\" 39.5\n"
               "Integrator \"directlighting\"\n"
               "WorldBegin\n"
               "LightSource \"distant\" \"point3 from\" [-2 1.5 2.2] \"point3 to\" [0 0 0] \"rgb L\" [4.5 4.5 4.5]\n"
               "Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" " +
               parameters + "\n";
    }
    void expectSame(const Words& options, const std::string& parameters) {
        Words words = {"map.pgm"};
        words.insert(words.end(), options.begin(), options.end());
        const Image by_option = render(words);
        folder_.write("said.pbrt", sceneOf(parameters));
        const Image by_scene = render({"said.pbrt"});
        for (const char* name : {"R", "G", "B", "A"})
            EXPECT_EQ(by_option.at(name).floats(), by_scene.at(name).floats()) << parameters;
    }
    nlohmann::json info(const Words& options) {
        Words words = {"info", "map.pgm", "--json"};
        words.insert(words.end(), options.begin(), options.end());
        Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }
};

TEST_F(MapOptionsTest, SayWhatASceneFileSays) {
    const std::string range = "\"float heightmin\" 10000 \"float heightmax\" 60000";
    const Words own = {"--heightmin", "10000", "--heightmax", "60000"};
    const auto with = [&](Words more) {
        more.insert(more.end(), own.begin(), own.end());
        return more;
    };
    expectSame(with({"--maxdispl", "12"}), range + " \"float maxdispl\" 12");
    expectSame(with({"--lonorigin", "30"}), range + " \"float maxdispl\" 5 \"float lonorigin\" 30");
    expectSame(with({"--registration", "gridline"}),
               range + " \"float maxdispl\" 5 \"string registration\" \"gridline\"");
    expectSame(with({"--midlevel", "0.5"}), range + " \"float maxdispl\" 5 \"float midlevel\" 0.5");
    expectSame(with({"--filter", "bspline"}), range + " \"float maxdispl\" 5 \"string filter\" \"bspline\"");
    expectSame(with({"--blur", "2"}), range + " \"float maxdispl\" 5 \"float blur\" 2");
    expectSame({"--heightscale", "1e-6", "--midlevel", "20000"}, "\"float heightscale\" 1e-6 \"float midlevel\" 20000");
}

// The whole view grows with the planet.
TEST_F(MapOptionsTest, AnotherRadiusIsSeenTheSame) {
    const Image small = render({"map.pgm"}), large = render({"map.pgm", "--radius", "1048576"});
    EXPECT_EQ(small.at("A").floats(), large.at("A").floats());
    double greatest = 0.0;
    for (std::size_t i = 0; i < small.pixelCount(); ++i)
        greatest = std::max(greatest, std::abs(double(small.at("G").floats()[i]) - double(large.at("G").floats()[i])));
    EXPECT_LT(greatest, 0.01);
    EXPECT_NEAR(info({"--radius", "3396", "--heightscale", "0.001"}).at("shown").at("radius"), 3396.0, 0.0);
}

TEST_F(MapOptionsTest, InfoTellsWhatIsShown) {
    EXPECT_FALSE(info({}).contains("shown"));
    const nlohmann::json plain = info({"--midlevel", "0"});
    EXPECT_EQ(plain.at("shown").at("map").at("nodata_texels"), 0);
    const double least = plain.at("least").at("value");
    const nlohmann::json json =
        info({"--nodata", fmt::format("{}", least), "--lonorigin", "0", "--registration", "gridline"});
    EXPECT_GE(json.at("shown").at("map").at("nodata_texels"), 1);
    EXPECT_EQ(json.at("shown").at("map").at("longitude_origin"), 0.0);
    EXPECT_EQ(json.at("shown").at("map").at("registration"), "gridline");
    EXPECT_GT(json.at("shown").at("map").at("least"), least);
}

TEST_F(MapOptionsTest, VerifyTakesThem) {
    Outcome outcome = run({"verify", "map.pgm", "--radius", "1737400", "--heightscale", "2", "--midlevel", "30000",
                           "--filter", "bspline", "--resolution", "32,24"});
    EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "The contract holds."));
}

TEST_F(MapOptionsTest, WrongOnesAreUsageErrors) {
    const std::vector<std::pair<Words, std::string>> cases = {
        {{"--nodata", "x"}, "--nodata: 'x' is not a number"},
        {{"--nodata", "inf"}, "--nodata: 'inf' is not a finite number"},
        {{"--lonorigin", "361"}, "--lonorigin: 361 is not in [-360, 360]"},
        {{"--lonorigin", "nan"}, "--lonorigin: 'nan' is not a finite number"},
        {{"--radius", "0"}, "--radius: 0 is not greater than 0"},
        {{"--blur", "1001"}, "--blur: 1001 is not in [0, 1000]"},
        {{"--band", "0"}, "--band"},
        {{"--registration", "pixel"}, "--registration: 'pixel' is not one of texel|gridline"},
        {{"--filter", "linear"}, "--filter: 'linear' is not one of bilinear|bspline"},
        {{"--maxdispl", "3", "--heightscale", "1"}, "--maxdispl and --heightscale exclude each other"},
        {{"--heightmin", "3", "--heightmax", "3"}, "--heightmin equals --heightmax"}};
    for (const char* command : {"render", "verify", "info"})
        for (const auto& [options, part] : cases) {
            Words words = {command, "map.pgm"};
            words.insert(words.end(), options.begin(), options.end());
            expectFailure(run(words), 2, part);
        }
    for (const char* command : {"render", "verify", "info", "bench"})
        expectFailure(run({command, "planet.pbrt", "--nodata", "nan"}), 2,
                      "--nodata is for a map in place of a scene; planet.pbrt says it itself, as nodata of its Shape");
}

}  // namespace
}  // namespace dsphere::test
