// Many frames by one process: each is the picture that a process of its own makes.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/cli/pictures.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

class FramesTest : public CliTest {
  protected:
    Outcome frames(Words options) {
        options.insert(options.begin(), {"render", "planet.pbrt"});
        return run(options);
    }
    void render(Words options) {
        const Outcome outcome = frames(std::move(options));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    std::string bytes(const std::string& name) const { return readBytes(path(name)); }
    std::string planetFrom(const std::string& eye) const {
        std::string text = planet();
        return text.replace(text.find("0 0 4"), 5, eye);
    }
};

TEST_F(FramesTest, EqualThePicturesOfAProcessEach) {
    folder_.write("fly.csv",
                  "frame,eye_x,eye_y,eye_z,fov,sun_lon,sun_lat,exaggeration,exposure\n"
                  "0,0,0,4,40,80,5,1,0\n"
                  "2,1,1,3,50,100,10,1,0.5\n"
                  "4,2,0,3,,,,2,\n");
    render({"--path", "fly.csv", "--frames", "0-4", "-o", "f%02d.png"});
    for (const char* k : {"0", "1", "2", "3", "4"}) {
        render({"--path", "fly.csv", "--frames", k, "-o", "one%d.png"});
        const std::string one = std::string("one") + k + ".png", frame = std::string("f0") + k + ".png";
        EXPECT_EQ(bytes(one), bytes(frame)) << k;
    }
    EXPECT_NE(bytes("f02.png"), bytes("f03.png"));
    EXPECT_NE(bytes("f03.png"), bytes("f04.png"));
}

TEST_F(FramesTest, EqualThePicturesOfAProcessEachOnTheHost) {
    folder_.write("fly.csv",
                  "frame,eye_x,eye_y,eye_z,sun_lon,sun_lat,exaggeration\n"
                  "0,0,0,4,80,5,1\n"
                  "2,1,1,3,100,10,2\n");
    const Words on_host = {"--device", "host", "--path", "fly.csv"};
    const auto withFrames = [&](const std::string& numbers, const std::string& name) {
        Words options = on_host;
        options.insert(options.end(), {"--frames", numbers, "-o", name});
        render(options);
    };
    withFrames("0-2", "f%d.png");
    for (const char* k : {"0", "1", "2"}) {
        withFrames(k, "one%d.png");
        EXPECT_EQ(bytes(std::string("one") + k + ".png"), bytes(std::string("f") + k + ".png")) << k;
    }
    EXPECT_NE(bytes("f0.png"), bytes("f1.png"));
    EXPECT_NE(bytes("f1.png"), bytes("f2.png"));
}

TEST_F(FramesTest, EqualThePictureOfASceneThatSaysTheSame) {
    folder_.write("fly.csv", "frame,eye_x,eye_y,eye_z,exaggeration\n3,0,0,4,1\n5,1,1,3,1.5\n");
    render({"--path", "fly.csv", "--frames", "3-5:2", "-o", "f%d.exr", "--aov", "all"});
    EXPECT_FALSE(exists("f4.exr"));
    folder_.write("planet.pbrt", planetFrom("1 1 3"));
    render({"-o", "one.exr", "--aov", "all", "--exaggeration", "1.5"});
    const Image one = readExr(path("one.exr")), frame = readExr(path("f5.exr"));
    expectSameChannels(one, frame);
}

TEST_F(FramesTest, ATurntableComesAroundAndGoesThroughOtherReliefs) {
    folder_.write("planet.pbrt", planet() +
                                     "Translate 0 1.2 0\nShape \"displacedsphere\" "
                                     "\"string displacementmap\" \"map.pgm\" \"float maxdispl\" 5\n");
    render({"--turntable", "4", "-o", "t%d.png"});
    EXPECT_TRUE(exists("t3.png"));
    EXPECT_FALSE(exists("t4.png"));
    render({"--turntable", "4", "--frames", "4", "-o", "t%d.png"});
    EXPECT_EQ(bytes("t0.png"), bytes("t4.png"));
    EXPECT_NE(bytes("t0.png"), bytes("t1.png"));
    // Without displacement both spheres have one relief, else two.
    folder_.write("flat.csv", "exaggeration\n1\n0\n1\n");
    render({"--path", "flat.csv", "--frames", "0-2", "-o", "x%d.png"});
    render({"-o", "flat.png", "--exaggeration", "0"});
    EXPECT_EQ(bytes("x0.png"), bytes("t0.png"));
    EXPECT_EQ(bytes("x1.png"), bytes("flat.png"));
    EXPECT_EQ(bytes("x2.png"), bytes("t0.png"));
}

TEST_F(FramesTest, SkipsWhatIsThere) {
    folder_.write("t1.png", "kept");
    const Outcome outcome = frames({"--turntable", "3", "-o", "t%d.png", "--skip-existing", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("frames"), 2);
    EXPECT_EQ(json.at("skipped"), 1);
    EXPECT_EQ(bytes("t1.png"), "kept");
    EXPECT_EQ(nlohmann::json::parse(frames({"--turntable", "3", "-o", "t%d.png", "--skip-existing", "--json"}).out)
                  .at("frames"),
              0);
    render({"--turntable", "3", "-o", "t%d.png"});
    EXPECT_NE(bytes("t1.png"), "kept");
}

TEST_F(FramesTest, NoFrameReplacesAnInput) {
    folder_.write("f3.png", "exposure\n1\n");
    expectFailure(frames({"--path", "f3.png", "--frames", "0-3", "-o", "f%d.png"}), 2,
                  "f3.png: a frame would replace f3.png, which is --path of this run");
    std::filesystem::create_symlink("map.pgm", path("t2.png"));
    const std::string map = bytes("map.pgm");
    expectFailure(frames({"--turntable", "3", "-o", "t%d.png"}), 2, "t2.png: a frame would replace");
    EXPECT_EQ(bytes("map.pgm"), map);
    EXPECT_FALSE(exists("f0.png") || exists("t0.png")) << "something was rendered";
    render({"--turntable", "3", "-o", "t%d.png", "--skip-existing"});
    EXPECT_EQ(bytes("map.pgm"), map);
}

TEST_F(FramesTest, AnEyeUnderTheGroundIsToldOnce) {
    folder_.write("low.csv", "frame,lat,lon,alt\n0,0,0,1\n1,0,0,0.001\n3,0,0,0.001\n");
    folder_.write("planet.pbrt", planet("\"float maxdispl\" 10 \"float midlevel\" -0.5"));
    const Outcome outcome = frames({"--path", "low.csv", "--frames", "0-3", "-o", "f%d.png"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(holds(outcome.err, "dsphere: warning: frame 1: planet.pbrt:"));
    EXPECT_TRUE(holds(outcome.err, "the eye lies inside this shape"));
    EXPECT_TRUE(holds(outcome.err, "dsphere: warning: other frames with warnings: 2"));
    EXPECT_FALSE(holds(outcome.err, "frame 0:"));
}

TEST_F(FramesTest, MoveACameraThatOptionsPlace) {
    const Words place = {"--lookat-latlon", "10,20,1.5", "--heading", "30", "--spp", "1"};
    const auto with = [&place](Words options) {
        options.insert(options.end(), place.begin(), place.end());
        return options;
    };
    render(with({"--turntable", "2", "-o", "t%d.png"}));
    render(with({"-o", "one.png"}));
    EXPECT_EQ(bytes("t0.png"), bytes("one.png"));
    EXPECT_NE(bytes("t1.png"), bytes("one.png"));
}

TEST_F(FramesTest, AnInterruptionLeavesWholeFrames) {
    Launch launch{.arguments = {"render", "planet.pbrt", "--frames", "0-9999", "-o", "f%d.png", "--spp", "64",
                                "--progress", "always"}};
    launch.signal = SIGINT;
    const Outcome outcome = run(launch);
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "go on by the same command with --skip-existing"));
    std::size_t whole = 0;
    while (exists("f" + std::to_string(whole) + ".png")) readPngPicture(path("f" + std::to_string(whole++) + ".png"));
    EXPECT_EQ(folder_.entries(), 2 + whole) << "a temporary was left";
}

TEST_F(FramesTest, WrongOptionsAreToldFirst) {
    folder_.write("fly.csv", "frame,fov\n0,40\n9,wide\n");
    folder_.write("light.csv", "exposure\n1\n");
    const auto fails = [&](Words options, int code, const std::string& part) {
        expectFailure(frames(std::move(options)), code, part);
    };
    fails({"--frames", "0-3", "-o", "f.png"}, 2, "the outfile f.png has no place for the frame's number");
    fails({"--frames", "0-3"}, 2, "the outfile film.exr has no place for the frame's number");
    fails({"--frames", "0-3", "-o", "f%s.png"}, 2, "has a % without its d");
    fails({"--frames", "0-3", "-o", "f%d-%d.png"}, 2, "has more than one %");
    fails({"--frames", "0-3", "-o", "%d/f.png"}, 2, "has the number in a folder's name");
    fails({"--frames", "3-0", "-o", "f%d.png"}, 2, "0 comes before 3");
    for (const char* bad : {"x", "1-", "-1", "1-2:", "1-2:0", "1-2x", "1--2", "1-99999999999"})
        fails({"--frames=" + std::string(bad), "-o", "f%d.png"}, 2, "is not A-B or A-B:STEP");
    fails({"--path", "light.csv", "-o", "f%d.png"}, 2, "--path needs --frames A-B");
    fails({"--path", "light.csv", "--turntable", "3", "-o", "f%d.png"}, 2, "exclude each other");
    fails({"--turntable", "-3", "-o", "f%d.png"}, 2, "--turntable: -3 is outside");
    fails({"--turntable", "3", "-o", "f%d.png", "--write-partial"}, 2, "--frames excludes --resume");
    fails({"--turntable", "3", "-o", "no/f%d.png"}, 1, "the folder no does not exist");
    fails({"--path", "fly.csv", "--frames", "0-3", "-o", "f%d.png"}, 3, "fly.csv:3: column fov: expected a number");
    fails({"--path", "light.csv", "--frames", "0-3", "-o", "f%d.exr"}, 2, "an EXR holds light as it is");
    EXPECT_EQ(folder_.entries(), 4u) << "something was rendered";
}

}  // namespace
}  // namespace dsphere::test
