// Long renders: what an interruption leaves, and how a render goes on.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/cli/pictures.h"

#include <csignal>

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

class ResumeTest : public CliTest {
  protected:
    void render(Words options) {
        options.insert(options.begin(), {"render", "planet.pbrt"});
        Outcome outcome = run(options);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    Outcome resume(Words options) {
        options.insert(options.begin(), {"render", "planet.pbrt", "-o", "b.exr", "--resume", "a.exr"});
        return run(options);
    }
    int samplesOf(const std::string& name) const {
        return std::get<int>(readExrMetadata(path(name)).at("samplesPerPixel"));
    }
    void expectSamePicture(const std::string& a, const std::string& b) const {
        const Image one = readExr(path(a)), other = readExr(path(b));
        EXPECT_EQ(one.data, other.data);
        expectSameChannels(one, other);
    }
    /// Stops a render of hours at its first line of progress.
    Outcome interrupt(int signal, Words options) {
        options.insert(options.begin(),
                       {"render", "planet.pbrt", "--resolution", "320,240", "--spp", "60000", "--progress", "always"});
        Launch launch{.arguments = options};
        launch.signal = signal;
        return run(launch);
    }
};

// Of powers of two the means are enough; others take the sums along.
TEST_F(ResumeTest, GoesOnBitForBit) {
    render({"-o", "whole.exr", "--spp", "7", "--seed", "3"});
    for (const char* first : {"1", "3", "4"}) {
        render({"-o", "a.exr", "--spp", first, "--seed", "3"});
        Outcome outcome = resume({"--spp", "7", "--seed", "3"});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        expectSamePicture("whole.exr", "b.exr");
        EXPECT_EQ(samplesOf("b.exr"), 7);
    }
}

TEST_F(ResumeTest, InPlaceWithFurtherPlanesAndACrop) {
    const Words same = {"--cropwindow", "0.1,0.8,0.2,1", "--aov", "all", "--clamp", "0.9"};
    auto with = [&](Words more) {
        more.insert(more.end(), same.begin(), same.end());
        return more;
    };
    render(with({"-o", "whole.exr", "--spp", "8"}));
    render(with({"-o", "a.exr", "--spp", "2"}));
    render(with({"-o", "a.exr", "--spp", "3", "--resume", "a.exr"}));
    render(with({"-o", "a.exr", "--spp", "8", "--resume", "a.exr"}));
    expectSamePicture("whole.exr", "a.exr");
}

TEST_F(ResumeTest, RefusesWhatIsNotTheSame) {
    render({"-o", "a.exr", "--spp", "4"});
    expectFailure(resume({"--spp", "8", "--seed", "1"}), 3, "--resume a.exr: the seed is another: 0, now 1");
    expectFailure(resume({"--spp", "8", "--resolution", "32,24"}), 3, "other pixels: 64x48 of 64x48, now 32x24");
    expectFailure(resume({"--spp", "8", "--cropwindow", "0,.5,0,1"}), 3, "other pixels");
    expectFailure(resume({"--spp", "8", "--exaggeration", "2"}), 3, "another scene, other maps or images");
    expectFailure(resume({"--spp", "8", "--marcher", "naive"}), 3, "another scene");
    expectFailure(resume({"--spp", "8", "--clamp", "1"}), 3, "another scene");
    expectFailure(resume({"--spp", "4"}), 2, "--resume a.exr: it has 4 samples already");
    expectFailure(resume({"--spp", "2"}), 2, "it has 4 samples already");
    expectFailure(resume({"--spp", "0", "--aov", "t"}), 2, "--resume needs --spp above 0");
    folder_.write("planet.pbrt", planet("\"float maxdispl\" 11"));
    expectFailure(resume({"--spp", "8"}), 3, "another scene");
    folder_.write("planet.pbrt", planet());
    writePgm16(path("map.pgm"), fractalMap(64, 32, 9));
    expectFailure(resume({"--spp", "8"}), 3, "other maps or images");
    EXPECT_FALSE(exists("b.exr"));
}

TEST_F(ResumeTest, RefusesOtherFiles) {
    expectFailure(resume({}), 3, "a.exr");
    folder_.write("a.exr", "no picture");
    expectFailure(resume({}), 3, "a.exr: cannot be read as EXR");
    Image image;
    image.data = image.display = {0, 0, kWidth, kHeight};
    for (const char* name : {"R", "G", "B"}) image.addFloat(name);
    writeExr(path("a.exr"), image, {});
    expectFailure(resume({}), 3, "--resume a.exr: it is no picture of render's: its header lacks software");
    EXPECT_FALSE(exists("b.exr"));
}

TEST_F(ResumeTest, AnInterruptionLeavesAPartThatGoesOn) {
    Outcome outcome = interrupt(SIGINT, {"-o", "a.exr", "--write-partial"});
    ASSERT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(holds(outcome.err, "completing the sample in progress"));
    EXPECT_TRUE(holds(outcome.err, "of 60000 samples a pixel; go on by the same command with --resume a.exr"));
    EXPECT_EQ(folder_.entries(), 3u) << "a temporary was left";
    const int done = samplesOf("a.exr");
    EXPECT_TRUE(holds(outcome.err, "interrupted; wrote a.exr with " + std::to_string(done) + " of 60000"));
    ASSERT_GE(done, 1);
    const std::string wanted = std::to_string(done + 2);
    render({"-o", "whole.exr", "--resolution", "320,240", "--spp", wanted});
    ASSERT_EQ(resume({"--resolution", "320,240", "--spp", wanted}).code, 0);
    expectSamePicture("whole.exr", "b.exr");
}

TEST_F(ResumeTest, TerminationAndPngs) {
    Outcome outcome = interrupt(SIGTERM, {"-o", "a.png", "--write-partial"});
    EXPECT_EQ(outcome.code, 143) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "a .png cannot be gone on with"));
    EXPECT_EQ(readPngPicture(path("a.png")).data, (Box{0, 0, 320, 240}));
    EXPECT_EQ(folder_.entries(), 3u);
}

TEST_F(ResumeTest, WithoutWritePartialNothingIsWritten) {
    render({"-o", "a.exr", "--spp", "1", "--resolution", "320,240"});
    const std::string before = readBytes(path("a.exr"));
    Outcome outcome = interrupt(SIGINT, {"-o", "a.exr", "--resume", "a.exr"});
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "dsphere: error: interrupted"));
    EXPECT_EQ(readBytes(path("a.exr")), before);
    EXPECT_EQ(folder_.entries(), 3u);
}

TEST_F(ResumeTest, ToneAndClampAreChecked) {
    expectFailure(run({"render", "planet.pbrt", "--tone", "aces"}), 2, "--tone is for .png");
    expectFailure(run({"render", "planet.pbrt", "--tone", "filmic"}), 2, "linear|aces|reinhard");
    expectFailure(run({"render", "planet.pbrt", "--clamp", "-1"}), 2, "--clamp: -1 is not a number of 0 or more");
    expectFailure(run({"render", "planet.pbrt", "--clamp", "nan"}), 2, "--clamp");
    render({"-o", "a.png"});
    render({"-o", "b.png", "--tone", "linear"});
    EXPECT_EQ(readBytes(path("a.png")), readBytes(path("b.png")));
    for (const char* curve : {"aces", "reinhard"}) {
        render({"-o", "b.png", "--tone", curve});
        EXPECT_NE(readBytes(path("a.png")), readBytes(path("b.png"))) << curve;
    }
}

}  // namespace
}  // namespace dsphere::test
