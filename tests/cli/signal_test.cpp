// Ctrl-C and SIGTERM in the middle of a long render.

#include "tests/cli/fixture.h"

#include <sys/stat.h>

#include <csignal>

namespace dsphere::test {
namespace {

class SignalTest : public CliTest {
  protected:
    void expectStopped(int signal, int code) {
        folder_.write("old.exr", "old");
        // Hours of work: the signal comes at the first progress line.
        Launch launch{.arguments = {"render", "planet.pbrt", "-o", "old.exr", "--progress", "always", "--resolution",
                                    "4096,3072", "--spp", "60000"}};
        launch.signal = signal;
        Outcome outcome = run(launch);
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(holds(outcome.err, "interrupted"));
        EXPECT_EQ(readBytes(path("old.exr")), "old") << "the old picture was touched";
        EXPECT_EQ(folder_.entries(), 3u) << "a file was left behind";
    }
};

TEST_F(SignalTest, InterruptIs130) {
    expectStopped(SIGINT, 130);
}

TEST_F(SignalTest, TerminationIs143) {
    expectStopped(SIGTERM, 143);
}

// Nobody polls while a file of a pipe that nobody writes to is opened.
TEST_F(SignalTest, EndsWhatWaitsForever) {
    ASSERT_EQ(mkfifo(path("pipe.pbrt").c_str(), 0600), 0);
    Launch launch{.arguments = {"info", "pipe.pbrt"}};
    launch.signal = SIGINT;
    launch.signal_after_ms = 100;
    const int code = run(launch).code;
    EXPECT_TRUE(code == 130 || code == 3) << code << ": a pipe may be refused before";
}

TEST_F(SignalTest, InterruptEndsVerify) {
    Launch launch{.arguments = {"verify", "planet.pbrt", "--progress", "always", "--resolution", "1600,1200"}};
    launch.signal = SIGINT;
    EXPECT_EQ(run(launch).code, 130);
    EXPECT_EQ(folder_.entries(), 2u);
}

}  // namespace
}  // namespace dsphere::test
