// dsphere info, dsphere generate and the completions.

#include "image/rawmap.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

namespace dsphere::test {
namespace {

using nlohmann::json;

class InfoTest : public CliTest {
  protected:
    json info(const std::string& file) {
        Outcome outcome = run({"info", file, "--json"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return json::parse(outcome.out);
    }
};

TEST_F(InfoTest, OfAMap) {
    RawMap map = constantMap(8, 4, 0.0f);
    map.samples = std::vector<float>(32, 100.0f);
    map.samples[13] = 40.0f;   // column 5, row 1
    map.samples[16] = 160.0f;  // column 0, row 2
    writePgm16(path("small.pgm"), map);
    json j = info("small.pgm");
    EXPECT_EQ(j["type"], "16-bit PGM");
    EXPECT_EQ(j["width"], 8);
    EXPECT_EQ(j["height"], 4);
    EXPECT_EQ(j["least"], json::parse(R"({"value":40.0,"column":5,"row":1,"latitude":22.5,"longitude":67.5})"));
    EXPECT_EQ(j["greatest"], json::parse(R"({"value":160.0,"column":0,"row":2,"latitude":-22.5,"longitude":-157.5})"));
    EXPECT_EQ(j["mean"], 100.0);
    EXPECT_EQ(j["non_finite_texels"], 0);
    EXPECT_EQ(j["registration"], "texel");
    EXPECT_EQ(j["longitude_origin"], -180.0);
    // Refined to 512 columns; a cube face's finest level, then half as many cells down to one.
    EXPECT_EQ(j["bounds"]["bytes"], 36 * j["bounds"]["side"].get<int>() * j["bounds"]["side"].get<int>());
    EXPECT_EQ(1 << (j["bounds"]["levels"].get<int>() - 1), j["bounds"]["side"]);
}

TEST_F(InfoTest, CountsWhatIsNotFinite) {
    std::string bytes = "Pf\n4 2\n-1.0\n";
    for (float value : {1.0f, 2.0f, NAN, 3.0f, INFINITY, 6.0f, -INFINITY, 4.0f})
        bytes.append(reinterpret_cast<const char*>(&value), 4);
    folder_.write("odd.pfm", bytes);
    json j = info("odd.pfm");
    EXPECT_EQ(j["non_finite_texels"], 3);
    EXPECT_EQ(j["least"]["value"], 1.0);
    EXPECT_EQ(j["greatest"]["value"], 6.0);
    EXPECT_DOUBLE_EQ(j["mean"], 16.0 / 5);
}

// The same number as a render says it put on the device.
TEST_F(InfoTest, OfAScene) {
    json j = info("planet.pbrt");
    EXPECT_EQ(j["film"]["resolution"], json::parse("[64,48]"));
    EXPECT_NEAR(j["camera"]["position"][2].get<double>(), 4.0, 1e-12);
    EXPECT_NEAR(j["camera"]["direction"][2].get<double>(), -1.0, 1e-12);
    ASSERT_EQ(j["shapes"].size(), 2u);
    EXPECT_EQ(j["shapes"][0]["type"], "displacedsphere");
    EXPECT_EQ(j["shapes"][0]["map"], 0);
    double radius = j["shapes"][0]["greatest_radius"];
    EXPECT_GT(radius, 1.0);
    EXPECT_LE(radius, 1.1);
    EXPECT_DOUBLE_EQ(j["shapes"][0]["displacement"][1].get<double>(), radius - 1.0);
    EXPECT_EQ(j["shapes"][1]["type"], "sphere");
    EXPECT_NEAR(j["shapes"][1]["centre"][0].get<double>(), 1.5, 1e-12);
    ASSERT_EQ(j["maps"].size(), 1u);
    EXPECT_EQ(j["maps"][0]["width"], 64);
    EXPECT_EQ(j["lights"][0]["type"], "distant");
    Outcome render = run({"render", "planet.pbrt", "--json", "--quiet"});
    ASSERT_EQ(render.code, 0) << render.err;
    EXPECT_EQ(j["maps"][0]["device_bytes"], json::parse(render.out)["map_bytes"]);
}

// A spline's node is four floats, and a bilinear map with smooth normals has both.
TEST_F(InfoTest, BytesOfCurvedSurfacesAreThoseOfARender) {
    std::uint64_t bilinear = info("planet.pbrt")["maps"][0]["device_bytes"];
    for (const auto& [parameter, ratio] :
         {std::pair<std::string, int>{"\"string filter\" \"bspline\"", 4}, {"\"bool smoothnormals\" true", 5}}) {
        SCOPED_TRACE(parameter);
        folder_.write("curved.pbrt", planet("\"float maxdispl\" 10 " + parameter));
        std::uint64_t bytes = info("curved.pbrt")["maps"][0]["device_bytes"];
        EXPECT_GT(bytes, bilinear + 4 * 512 * 256 * (ratio - 1));
        Outcome render = run({"render", "curved.pbrt", "--json", "--quiet"});
        ASSERT_EQ(render.code, 0) << render.err;
        EXPECT_EQ(bytes, json::parse(render.out)["map_bytes"]);
    }
}

TEST_F(InfoTest, TextAndStandardInput) {
    Outcome outcome = run(Launch{.arguments = {"info", "-"}, .input = planet()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "greatest radius"));
    EXPECT_TRUE(holds(outcome.out, "resolution            64 48\n"));
}

TEST_F(InfoTest, Errors) {
    expectFailure(run({"info"}), 2, "file is required");
    expectFailure(run({"info", "missing.png"}), 3, "missing.png");
    expectFailure(run({"info", "missing.pbrt"}), 3, "missing.pbrt");
    folder_.write("bad.pbrt", "Nonsense 3\n");
    expectFailure(run({"info", "bad.pbrt"}), 3, "bad.pbrt:1:1");
}

TEST_F(CliTest, GeneratedMapsRender) {
    for (const char* kind : {"moon", "fractal", "terraces", "spikes", "checkerboard", "random"}) {
        Outcome outcome = run({"generate", kind, "-o", "map.pgm", "--size", "65,33", "--seed", "4"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out + outcome.err, "");
        EXPECT_EQ(readRawMap(path("map.pgm")).width, 65);
    }
    EXPECT_EQ(run({"render", "planet.pbrt", "--quick"}).code, 0);
}

TEST_F(CliTest, GenerateSaysWhatItMade) {
    Outcome outcome = run({"generate", "terraces", "-o", "map.png", "--size", "32,16", "--seed", "9", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json j = json::parse(outcome.out);
    EXPECT_EQ(j["map"], "map.png");
    EXPECT_EQ(j["kind"], "terraces");
    EXPECT_EQ(j["width"], 32);
    EXPECT_EQ(j["height"], 16);
    EXPECT_EQ(j["seed"], 9);
    EXPECT_EQ(j["bytes"], std::filesystem::file_size(path("map.png")));
}

TEST_F(CliTest, GenerateRefuses) {
    std::size_t entries = folder_.entries();
    expectFailure(run({"generate"}), 2, "required");
    expectFailure(run({"generate", "mars", "-o", "a.png"}), 2, "moon|fractal");
    expectFailure(run({"generate", "moon"}), 2, "--outfile");
    expectFailure(run({"generate", "moon", "-o", "a.jpg"}), 2, ".png, .pgm");
    expectFailure(run({"generate", "moon", "-o", "a.png", "--size", "0,4"}), 2, "--size");
    expectFailure(run({"generate", "moon", "-o", "a.png", "--size", "4"}), 2, "--size");
    expectFailure(run({"generate", "moon", "-o", "a.png", "--seed", "-1"}), 2, "--seed");
    expectFailure(run({"generate", "moon", "-o", "no/a.png"}), 1, "no");
    EXPECT_EQ(folder_.entries(), entries);
}

/// What bash would offer for the last of the words.
std::set<std::string> completions(const std::string& words, int last) {
    std::string script = "source " DSPHERE_SOURCE_DIR "/completions/dsphere.bash; COMP_WORDS=(" DSPHERE_PROGRAM " " +
                         words + "); COMP_CWORD=" + std::to_string(last) +
                         "; _dsphere 2>/dev/null; printf \"%s\\\\n\" \"${COMPREPLY[@]}\"";
    std::FILE* pipe = popen(("bash -c '" + script + "'").c_str(), "r");
    std::string text;
    std::array<char, 4096> part;
    for (std::size_t n; pipe && (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) text.append(part.data(), n);
    if (pipe) pclose(pipe);
    std::istringstream lines(text);
    std::set<std::string> offered;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) offered.insert(line);
    return offered;
}

using Offered = std::set<std::string>;

TEST(Completion, OfCommandsOptionsAndWords) {
    EXPECT_EQ(completions("re", 1), Offered{"render"});
    EXPECT_EQ(completions("\"\"", 1).count("generate"), 1u);
    EXPECT_EQ(completions("render --outf", 2), Offered{"--outfile"});
    EXPECT_EQ(completions("render --marcher \"\"", 3).count("exact"), 1u);
    EXPECT_EQ(completions("diff --metric f", 3), Offered{"flip"});
    EXPECT_EQ(completions("generate m", 2), Offered{"moon"});
    EXPECT_EQ(completions("render sce", 2), Offered{});
}

}  // namespace
}  // namespace dsphere::test
