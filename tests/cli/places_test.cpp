// Maps that say where they lie, in scenes and in place of one.

#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = DSPHERE_SOURCE_DIR "/tests/data/cases";

class Places : public CliTest {
  protected:
    void copy(const std::string& name) { fs::copy_file(kCases / name, path(fs::path(name).filename().string())); }

    nlohmann::json info(const std::string& name) {
        const Outcome outcome = run({"info", name, "--json"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }
};

TEST_F(Places, TagsMakeTheSamePicture) {
    for (const char* map : {"truth.tif", "nodata.tif", "lon0360.tif"}) copy(std::string("scenes/") + map);
    for (const char* scene : {"02-geotiff-truth", "02-geotiff-nodata", "02-geotiff-lon0360"}) {
        copy(std::string("scenes/") + scene + ".pbrt");
        const Outcome outcome = run({"render", std::string(scene) + ".pbrt", "--device", "cpu"});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    const std::string truth = readBytes(path("02-geotiff-truth-out.png"));
    EXPECT_GT(truth.size(), 1000u);
    EXPECT_TRUE(truth == readBytes(path("02-geotiff-lon0360-out.png")));
    const Outcome outcome =
        run({"diff", "02-geotiff-truth-out.png", "02-geotiff-nodata-out.png", "--threshold", "0.002"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Places, InfoTellsWhatTheFileSays) {
    copy("maps/scale_offset.tif");
    copy("maps/nodata_int16.tif");
    const nlohmann::json scaled = info("scale_offset.tif");
    EXPECT_EQ(scaled["scale"], 0.5);
    EXPECT_EQ(scaled["offset"], 1737400.0);
    EXPECT_EQ(scaled["radius"], 1737400.0);
    EXPECT_EQ(scaled["unit"], "m");
    EXPECT_EQ(scaled["height_range"], (nlohmann::json{-3063.5, 8189.0}));
    EXPECT_EQ(scaled["projection"], "geographic");
    EXPECT_EQ(scaled["extent"]["west"], -180.0);
    EXPECT_EQ(scaled["sources"]["scale"], "tag");
    EXPECT_EQ(scaled["sources"]["unit"], "default");
    const nlohmann::json holes = info("nodata_int16.tif");
    EXPECT_EQ(holes["unknown_texels"], 462);
    EXPECT_EQ(holes["non_finite_texels"], 0);
    EXPECT_EQ(holes["least"]["value"], -7659.0);
}

TEST_F(Places, WhatTheSceneSaysWins) {
    copy("maps/lon_0_360.tif");
    const std::string shape =
        "WorldBegin Shape \"displacedsphere\" \"string displacementmap\" \"lon_0_360.tif\" \"float heightscale\" 1e-6 ";
    folder_.write("plain.pbrt", shape);
    folder_.write("said.pbrt",
                  shape + "\"float lonorigin\" 20 \"string registration\" \"gridline\" \"integer band\" 1");
    const nlohmann::json plain = info("plain.pbrt")["maps"][0], said = info("said.pbrt")["maps"][0];
    EXPECT_EQ(plain["longitude_origin"], 0.0);
    EXPECT_EQ(plain["sources"]["longitude_origin"], "tag");
    EXPECT_EQ(said["longitude_origin"], 20.0);
    EXPECT_EQ(said["sources"]["longitude_origin"], "scene");
    EXPECT_EQ(said["registration"], "gridline");
    EXPECT_EQ(said["sources"]["registration"], "scene");
}

TEST_F(Places, AMapThatKnowsItsRadiusIsDrawnInProportion) {
    copy("maps/south_up.tif");
    const Outcome outcome =
        run({"render", "south_up.tif", "-o", "out.png", "--device", "cpu", "--resolution", "64,36"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // 28131 m are 0.83 % of 3396190 m: five times that is less than 5 %, ten times more.
    EXPECT_TRUE(holds(outcome.err, "dsphere: note: "));
    EXPECT_TRUE(holds(outcome.err, "on a sphere of 3396190 m heights are drawn 5 times as high as they are"));
}

TEST_F(Places, WithoutGdalMapsWithAPlaceAreRefused) {
    copy("maps/lon_0_360.tif");
    copy("maps/grid.asc");
    for (const char* map : {"lon_0_360.tif", "grid.asc"})
        expectFailure(run(Launch{.arguments = {"info", map}, .environment = {"DSPHERE_GDAL=/no/such/libgdal.so"}}), 3,
                      "which cannot be loaded");
    EXPECT_EQ(run(Launch{.arguments = {"info", "map.pgm"}, .environment = {"DSPHERE_GDAL=/no/such/libgdal.so"}}).code,
              0);
}

TEST_F(Places, PiecesAreRefusedAndImportIsNamed) {
    copy("maps/regional.tif");
    copy("maps/web_mercator.tif");
    expectFailure(run({"render", "regional.tif", "-o", "out.png"}), 3, "`dsphere import`");
    expectFailure(run({"render", "web_mercator.tif", "-o", "out.png"}), 3, "`dsphere import`");
    EXPECT_FALSE(exists("out.png"));
}

TEST_F(Places, ImportMakesAMapThatRenders) {
    copy("maps/regional.tif");
    copy("maps/web_mercator.tif");
    const Outcome made = run({"import", "globe.tif", "web_mercator.tif", "regional.tif", "--json"});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(nlohmann::json::parse(made.out)["width"], 576);
    EXPECT_EQ(run({"render", "globe.tif", "-o", "out.png", "--device", "cpu", "--resolution", "64,36"}).code, 0);
    EXPECT_NEAR(info("globe.tif")["greatest"]["value"].get<double>(), 20472.0, 50.0) << "between texels";
    const Outcome again = run({"import", "regional.tif", "web_mercator.tif", "regional.tif"});
    expectFailure(again, 2, "would replace regional.tif");
}

TEST_F(Places, BakedHeightsAreTheMap) {
    copy("maps/scale_offset.tif");
    const Outcome made = run({"bake", "scale_offset.tif", "-o", "height.tif", "--quantities", "height", "--quiet"});
    EXPECT_EQ(made.code, 0) << made.err;
    const nlohmann::json map = info("scale_offset.tif"), baked = info("height.tif");
    for (const char* key : {"radius", "unit", "extent", "longitude_origin", "registration", "height_range"})
        EXPECT_EQ(baked[key], map[key]) << key;
    const Outcome both =
        run({"bake", "scale_offset.tif", "-o", "two.tif", "--quantities", "slope,lit", "--sun", "0,3"});
    EXPECT_EQ(both.code, 0) << both.err;
    expectFailure(run(Launch{.arguments = {"bake", "map.pgm", "-o", "a.tif", "--quantities", "slope"},
                             .environment = {"DSPHERE_GDAL=/no/such/libgdal.so"}}),
                  3, "cannot be loaded");
    EXPECT_FALSE(exists("a.tif"));
}

TEST_F(Places, ABakeThatIsStoppedLeavesNothing) {
    const std::size_t before = folder_.entries();
    const Outcome outcome = run(Launch{.arguments = {"bake", "map.pgm", "-o", "out.tif", "--quantities", "sky",
                                                     "--resolution", "4096,2048", "--progress", "always"},
                                       .signal = SIGINT});
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(folder_.entries(), before);
}

TEST_F(Places, AnImportThatIsStoppedLeavesWhatThereWas) {
    copy("maps/web_mercator.tif");
    folder_.write("out.tif", "what there was");
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
        const Outcome outcome = run(Launch{.arguments = {"import", "out.tif", "web_mercator.tif", "--resolution",
                                                         "16384,8192", "--progress", "always"},
                                           .signal = signal});
        EXPECT_EQ(outcome.code, signal == SIGKILL ? -SIGKILL : 128 + signal) << outcome.err;
        EXPECT_EQ(readBytes(path("out.tif")), "what there was");
    }
}

}  // namespace
}  // namespace dsphere::test
