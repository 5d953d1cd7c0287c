// Standard streams that are full, closed or broken, and pictures on standard output.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

/// Commands that say something on standard output.
const Words kTalking[] = {{"info", "planet.pbrt"},
                          {"info", "map.pgm", "--json"},
                          {"render", "planet.pbrt", "--json", "--spp", "1"},
                          {"verify", "planet.pbrt", "--sample", "10"},
                          {"verify", "planet.pbrt", "--sample", "10", "--json"},
                          {"diff", "a.exr", "a.exr"},
                          {"generate", "terraces", "-o", "made.png", "--size", "8,4", "--json"},
                          {"devices"},
                          {"devices", "--json"},
                          {"--help"},
                          {"render", "--help"},
                          {"--version"}};

class StreamsTest : public CliTest {
  protected:
    StreamsTest() {
        Image image;
        image.data = image.display = {0, 0, 8, 4};
        for (const char* name : {"R", "G", "B"}) image.addFloat(name);
        writeExr(path("a.exr"), image, {});
    }
};

TEST_F(StreamsTest, WhatDoesNotArriveIsAnError) {
    for (const Words& words : kTalking)
        for (const std::string to : {"/dev/full", kClosed}) {
            Launch launch{.arguments = words};
            launch.out_to = to;
            Outcome outcome = run(launch);
            EXPECT_EQ(outcome.code, 1) << testing::PrintToString(words) << " to " << to << ": " << outcome.err;
            EXPECT_TRUE(holds(outcome.err, "dsphere: error: standard output: cannot be written: "));
        }
    EXPECT_TRUE(exists("film.exr")) << "the picture is written all the same";
}

TEST_F(StreamsTest, StandardErrorMayBeFullOrClosed) {
    for (const std::string to : {"/dev/full", kClosed})
        for (const Words& words : {Words{"render", "planet.pbrt", "-o", "b.exr", "--progress", "always"},
                                   Words{"verify", "planet.pbrt", "--sample", "10", "--progress", "always"},
                                   Words{"generate", "moon", "-o", "moon.pgm", "--size", "64,32"}}) {
            Launch launch{.arguments = words};
            launch.err_to = to;
            EXPECT_EQ(run(launch).code, 0) << testing::PrintToString(words) << " to " << to;
        }
    EXPECT_EQ(readExr(path("b.exr")).data, (Box{0, 0, kWidth, kHeight}));
    Launch failing{.arguments = {"render", "missing.pbrt"}};
    failing.err_to = "/dev/full";
    EXPECT_EQ(run(failing).code, 3);
}

TEST_F(StreamsTest, AnyStreamMayBeClosed) {
    Launch launch{.arguments = {"render", "planet.pbrt", "-o", "b.exr"}};
    launch.out_to = launch.err_to = kClosed;
    EXPECT_EQ(run(launch).code, 0);
    EXPECT_EQ(readExr(path("b.exr")).data, (Box{0, 0, kWidth, kHeight})) << "no message lies within the picture";
}

TEST_F(StreamsTest, PicturesGoToStandardOutput) {
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "a.png"}).code, 0);
    Outcome png = run({"render", "planet.pbrt", "-o", "-"});
    EXPECT_EQ(png.code, 0) << png.err;
    EXPECT_EQ(png.out, readBytes(path("a.png")));
    EXPECT_TRUE(holds(png.err, "picture  standard output"));
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "b.exr", "--reproducible", "--aov", "all"}).code, 0);
    Outcome exr = run({"render", "planet.pbrt", "-o", "-", "--format", "exr", "--reproducible", "--aov", "all"});
    EXPECT_EQ(exr.code, 0) << exr.err;
    EXPECT_EQ(exr.out, readBytes(path("b.exr")));
    Launch launch{.arguments = {"render", "planet.pbrt", "-o", "-"}};
    launch.out_to = "/dev/full";
    Outcome full = run(launch);
    EXPECT_EQ(full.code, 1);
    EXPECT_TRUE(holds(full.err, "standard output: cannot be written: No space left on device"));
}

TEST_F(StreamsTest, NothingElseMayGoThere) {
    expectFailure(run({"render", "planet.pbrt", "-o", "-", "--json"}), 2, "both write to standard output");
    expectFailure(run({"render", "planet.pbrt", "-o", "a.png", "--format", "png"}), 2, "--format is for -o -");
    expectFailure(run({"render", "planet.pbrt", "-o", "-", "--aov", "t"}), 2, "a PNG cannot hold --aov outputs");
    EXPECT_FALSE(exists("-"));
}

TEST_F(StreamsTest, ReproducibleFilesAreEqual) {
    for (const char* name : {"one.exr", "two.exr"})
        ASSERT_EQ(run({"render", "planet.pbrt", "-o", name, "--reproducible"}).code, 0);
    EXPECT_EQ(readBytes(path("one.exr")), readBytes(path("two.exr")));
    const Metadata metadata = readExrMetadata(path("one.exr"));
    for (const char* name : {"device", "driver", "renderTimeSeconds"}) EXPECT_FALSE(metadata.contains(name)) << name;
    for (const char* name : {"seed", "software", "samplesPerPixel"}) EXPECT_TRUE(metadata.contains(name)) << name;
    expectFailure(run({"render", "planet.pbrt", "-o", "b.exr", "--spp", "9", "--resume", "one.exr"}), 3,
                  "--resume one.exr: it was written with --reproducible");
}

TEST_F(StreamsTest, NamesThatAreNoUtf8) {
    const std::string name = "caf\xe9.pbrt";
    folder_.write(name, planet());
    Outcome info = run({"info", name, "--json"});
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(nlohmann::json::parse(info.out).at("scene"), "caf\ufffd.pbrt");
    Outcome render = run({"render", name, "--json", "-o", "\xff.exr", "--spp", "1"});
    ASSERT_EQ(render.code, 0) << render.err;
    EXPECT_EQ(nlohmann::json::parse(render.out).at("picture"), "\ufffd.exr");
    EXPECT_TRUE(exists("\xff.exr"));
}

// As a disk that is full: an error, the old picture, nothing left behind.
TEST_F(StreamsTest, AFileSizeLimitIsAnError) {
    folder_.write("old.exr", "old");
    const std::size_t entries = folder_.entries();
    Launch launch{.arguments = {"render", "planet.pbrt", "-o", "old.exr", "--aov", "all"}};
    launch.limits = {{RLIMIT_FSIZE, 2000}};
    expectFailure(run(launch), 1, "old.exr: cannot be written: File too large");
    EXPECT_EQ(readBytes(path("old.exr")), "old");
    EXPECT_EQ(folder_.entries(), entries);
}

}  // namespace
}  // namespace dsphere::test
