// Materials, lights and meshes of the scene language by the real program.

#include "tests/cli/fixture.h"
#include "tests/image/encoders.h"

#include <nlohmann/json.hpp>

namespace dsphere::test {
namespace {

using nlohmann::json;

class LanguageTest : public CliTest {
  protected:
    /// The planet's scene with more options, of which an Integrator replaces its own, and a longer world.
    static std::string with(const std::string& options, const std::string& world) {
        static const std::string kOwn = "Integrator \"directlighting\"";
        std::string scene = planet() + world;
        if (options.find("Integrator") != std::string::npos) scene.replace(scene.find(kOwn), kOwn.size(), "");
        return scene.insert(scene.find("WorldBegin"), options + "\n");
    }
};

TEST_F(LanguageTest, InfoTellsOfEverything) {
    folder_.write("sky.pfm", pfmFile(2, 1, {1, 2}, true));
    folder_.write("all.pbrt", with("Integrator \"path\" \"integer maxdepth\" 2\nPixelFilter \"gaussian\"",
                                   "LightSource \"infinite\" \"string filename\" \"sky.pfm\"\n"
                                   "Texture \"c\" \"color\" \"checkerboard\"\n"
                                   "Material \"plastic\" \"texture Kd\" \"c\"\n"
                                   "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\n"
                                   "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\n"
                                   "Material \"conductor\"\nShape \"disk\"\nMaterial \"mirror\"\nShape \"sphere\"\n"));
    Outcome outcome = run({"info", "all.pbrt", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    json j = json::parse(outcome.out);
    EXPECT_EQ(j["integrator"], json::parse(R"({"type":"path","max_depth":2,"regularize":false})"));
    EXPECT_EQ(j["pixel_filter"], json::parse(R"({"type":"gaussian","radius":[1.5,1.5],"falloff":2.0})"));
    ASSERT_EQ(j["shapes"].size(), 5u);
    EXPECT_EQ(j["shapes"][0]["material"], json::parse(R"({"type":"matte","Kd":[0.5,0.5,0.5],"sigma":0.0})"));
    EXPECT_EQ(j["shapes"][2]["type"], "trianglemesh");
    EXPECT_EQ(j["shapes"][2]["triangles"], 1);
    EXPECT_EQ(j["shapes"][2]["material"]["Kd"]["even"], json::parse("[1.0,1.0,1.0]"));
    EXPECT_EQ(j["shapes"][3]["material"]["type"], "conductor");
    EXPECT_EQ(j["shapes"][4]["material"]["type"], "mirror");
    ASSERT_EQ(j["lights"].size(), 4u);
    EXPECT_EQ(j["lights"][1], json::parse(R"({"type":"infinite","L":[1.0,1.0,1.0],"image":0})"));
    EXPECT_EQ(j["lights"][2], json::parse(R"({"type":"area","shape":3,"L":[1.0,2.0,3.0],"two_sided":false})"));
    EXPECT_EQ(j["images"].size(), 1u);
    EXPECT_EQ(run({"info", "all.pbrt"}).code, 0);
}

TEST_F(LanguageTest, MistakesAreNamedByTheirPlace) {
    folder_.write("sky.pfm", pfmFile(2, 2, {1, 2, 3, 4}, true));
    struct Mistake {
        const char *options, *world, *says;
    };
    for (const Mistake& mistake : {
             Mistake{"Integrator \"bdpt\"", "", "bad.pbrt:6:12: unknown integrator \"bdpt\""},
             {"PixelFilter \"lanczos\"", "", "bad.pbrt:6:13: unknown pixel filter \"lanczos\""},
             {"", "Material \"glass\"", "bad.pbrt:12:10: unknown material \"glass\""},
             {"", "LightSource \"infinite\" \"string filename\" \"sky.pfm\"",
              "bad.pbrt:12:42: sky.pfm: the image is square"},
             {"", "LightSource \"infinite\" \"string mapname\" \"none.exr\"", "bad.pbrt:12:41: none.exr"},
             {"", "AreaLightSource \"diffuse\"\nShape \"displacedsphere\"", "bad.pbrt:13:1: an AreaLightSource"},
         }) {
        folder_.write("bad.pbrt", with(mistake.options, mistake.world));
        expectFailure(run({"render", "bad.pbrt"}), 3, mistake.says);
        expectFailure(run({"info", "bad.pbrt"}), 3, mistake.says);
    }
    EXPECT_FALSE(exists("film.exr"));
}

}  // namespace
}  // namespace dsphere::test
