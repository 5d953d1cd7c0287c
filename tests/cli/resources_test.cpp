// What a run needs and may lose on the way: the device, memory, threads.

#include "image/picture.h"
#include "tests/cli/fixture.h"

namespace dsphere::test {
namespace {

class ResourcesTest : public CliTest {
  protected:
    Outcome runInjected(std::vector<std::string> words, const std::string& what) {
        Launch launch{.arguments = std::move(words)};
        launch.environment = {"VK_LAYER_PATH=" DSPHERE_INJECT_LAYER, "VK_INSTANCE_LAYERS=VK_LAYER_DSPHERE_inject",
                              what};
        return run(launch);
    }
    void expectDeviceLost(std::vector<std::string> words, int wait) {
        Outcome outcome =
            runInjected(std::move(words), "DSPHERE_INJECT=vkWaitForFences:" + std::to_string(wait) + ":-4");
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

// Films of 0.6 and 3 MB go to a device that gives 560,000 bytes at once, a band of rows after the other, from nothing
// and from samples of before: the same picture. What no halving helps is an error.
TEST_F(ResourcesTest, AFilmThatTheDeviceHasNoMemoryForIsDoneInBands) {
    using Words = std::vector<std::string>;
    const auto words = [](const std::string& output, const std::string& size, const Words& more) {
        Words all = {"render", "planet.pbrt", "-o", output, "--resolution", size, "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const std::string size = "300,180", most = "DSPHERE_INJECT_MOST=560000";
    EXPECT_EQ(run(words("whole.exr", size, {"--spp", "3", "--aov", "all"})).code, 0);
    EXPECT_EQ(runInjected(words("some.exr", size, {"--spp", "2"}), most).code, 0);
    const Words on = {"--spp", "3", "--aov", "all", "--resume", "some.exr"};
    const Outcome banded = runInjected(words("banded.exr", size, on), most);
    EXPECT_EQ(banded.code, 0) << banded.err;
    const Image whole = readExr(path("whole.exr")), parts = readExr(path("banded.exr"));
    ASSERT_EQ(parts.channels.size(), whole.channels.size());
    for (const Channel& channel : whole.channels)
        EXPECT_TRUE(parts.at(channel.name).pixels == channel.pixels) << channel.name;

    const Words wide = words("none.exr", "9000,48", {"--spp", "1"});
    expectFailure(runInjected(wide, most), 1,
                  "vkAllocateMemory: VK_ERROR_OUT_OF_DEVICE_MEMORY); 16 rows of the picture are too many already");
    expectFailure(runInjected(wide, "DSPHERE_INJECT_MOST=500000"), 1, "--mem-limit SIZE, of less than 8 bytes");
    EXPECT_FALSE(exists("none.exr"));
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
