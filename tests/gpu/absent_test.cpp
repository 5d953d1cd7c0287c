// Machines without driver, loader or validation layer, each played by a child process with its own environment.

#include <cstdio>
#include <fstream>

#include "tests/gpu/fixture.h"
#include "tests/support/keepdriver.h"

namespace dsphere::gpu {
namespace {

/// Ends the process with the exit code of the error that `action` throws; its message goes to stderr.
template <typename Action>
[[noreturn]] void exitWithError(Action action) {
    try {
        action();
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        std::_Exit(int(error.code()));
    }
    std::_Exit(0);
}

/// "threadsafe" death tests start the program anew, so that the loader reads the environment set here.
class AbsentDeathTest : public CacheTest {
  protected:
    AbsentDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
    ScopedVariable more_drivers_{"VK_ADD_DRIVER_FILES", nullptr};
    ScopedVariable more_layers_{"VK_ADD_LAYER_PATH", nullptr};
    ScopedVariable loader_talk_{"VK_LOADER_DEBUG", nullptr};
};

TEST_F(AbsentDeathTest, NoDriver) {
    const std::string missing = (cache_.path() / "missing.json").string();
    const ScopedVariable files("VK_DRIVER_FILES", missing.c_str()), older_name("VK_ICD_FILENAMES", missing.c_str());
    EXPECT_EXIT(exitWithError([] { Device(); }), testing::ExitedWithCode(4), "no Vulkan device: .*no driver");
    EXPECT_EXIT(exitWithError([] { listDevices(); }), testing::ExitedWithCode(4), "no Vulkan device: .*no driver");
    EXPECT_EXIT(exitWithError([] { Device({.selector = "", .validation = true}); }), testing::ExitedWithCode(4),
                "no Vulkan device: .*no driver");
}

TEST_F(AbsentDeathTest, NoLoader) {
    // Empty files stop the search for the library before the real one.
    for (const char* name : {"libvulkan.so.1", "libvulkan.so"}) std::ofstream(cache_.path() / name).flush();
    const ScopedVariable path("LD_LIBRARY_PATH", cache_.path().c_str());
    EXPECT_EXIT(exitWithError([] { Device(); }), testing::ExitedWithCode(4), "loader .*is not installed");
    EXPECT_EXIT(exitWithError([] { listDevices(); }), testing::ExitedWithCode(4), "loader .*is not installed");
}

TEST_F(AbsentDeathTest, NoValidationLayer) {
    const ScopedVariable path("VK_LAYER_PATH", cache_.path().c_str());
    EXPECT_EXIT(exitWithError([] { Device({.selector = "", .validation = true}); }), testing::ExitedWithCode(1),
                "VK_LAYER_KHRONOS_validation is not installed");
    EXPECT_EXIT(exitWithError([] { Device(); }), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace dsphere::gpu
