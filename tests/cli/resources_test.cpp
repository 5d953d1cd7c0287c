// What a run needs and may lose on the way: the device, memory, threads.

#include "tests/cli/fixture.h"

namespace dsphere::test {
namespace {

class ResourcesTest : public CliTest {
  protected:
    void expectDeviceLost(std::vector<std::string> words, int wait) {
        Launch launch{.arguments = std::move(words)};
        launch.environment = {"VK_LAYER_PATH=" DSPHERE_INJECT_LAYER, "VK_INSTANCE_LAYERS=VK_LAYER_DSPHERE_inject",
                              "DSPHERE_INJECT=vkWaitForFences:" + std::to_string(wait) + ":-4"};
        Outcome outcome = run(launch);
        EXPECT_EQ(outcome.code, 1) << "at wait " << wait << ": " << outcome.err;
        EXPECT_TRUE(holds(outcome.err, "VK_ERROR_DEVICE_LOST")) << "at wait " << wait;
    }
};

// Whatever the device still works on must outlive the message; other threads may be compiling.
TEST_F(ResourcesTest, ADeviceLostAtAnyWaitIsAnError) {
    for (int wait = 1; wait <= 20; ++wait) expectDeviceLost({"render", "map.pgm", "-o", "a.exr", "--quiet"}, wait);
    EXPECT_FALSE(exists("a.exr"));
    for (int wait : {1, 5, 9, 13}) expectDeviceLost({"verify", "planet.pbrt", "--quiet"}, wait);
}

// With less and less address space the message changes, but no signal ends the program.
TEST_F(ResourcesTest, LittleMemoryIsAnError) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer takes terabytes of addresses";
#endif
    for (rlim_t mebibytes : {150, 250, 350, 450, 600, 800, 1000}) {
        Launch launch{.arguments = {"render", "map.pgm", "-o", "a.exr", "--spp", "1", "--quiet"}};
        launch.limits = {{RLIMIT_AS, mebibytes << 20}};
        Outcome outcome = run(launch);
        EXPECT_TRUE(outcome.code == 1 || outcome.code == 4) << mebibytes << " MiB: " << outcome.code << outcome.err;
        EXPECT_EQ(outcome.err.rfind("dsphere: error: ", 0), 0u) << mebibytes << " MiB: " << outcome.err;
        EXPECT_NE(outcome.err.find(outcome.code == 4 ? "address space" : "memory"), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(exists("a.exr"));
}

TEST_F(ResourcesTest, ASmallStackIsEnoughWithoutADevice) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's guards around locals take more stack";
#endif
    for (const std::string command : {"info", "generate"}) {
        Launch launch{.arguments = {"info", "planet.pbrt"}};
        if (command == "generate") launch.arguments = {"generate", "terraces", "-o", "made.pgm", "--size", "8,4"};
        launch.limits = {{RLIMIT_STACK, 64 << 10}};
        Outcome outcome = run(launch);
        EXPECT_EQ(outcome.code, 0) << command << ": " << outcome.err;
    }
}

}  // namespace
}  // namespace dsphere::test
