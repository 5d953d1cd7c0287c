// Scenes, maps, outputs and devices that are not what they should be: exit codes 1, 3 and 4.

#include "tests/cli/fixture.h"

#include <unistd.h>

namespace dsphere::test {
namespace {

class InputTest : public CliTest {
  protected:
    void expectInvalid(const std::string& scene, const std::string& part) {
        folder_.write("bad.pbrt", scene);
        std::size_t entries = folder_.entries();
        expectFailure(run({"render", "bad.pbrt", "-o", "bad.exr"}), 3, part);
        expectFailure(run({"verify", "bad.pbrt"}), 3, part);
        EXPECT_EQ(folder_.entries(), entries) << "a file was made";
    }
};

TEST_F(InputTest, SceneThatIsMissing) {
    expectFailure(run({"render", "none.pbrt"}), 3, "none.pbrt");
}

TEST_F(InputTest, MalformedSceneNamesFileLineAndColumn) {
    expectInvalid(planet() + "Shape \"cone\"\n", "bad.pbrt:11:7: ");
    expectInvalid(planet() + "Shape \"cone\"\n", "displacedsphere");
    expectInvalid("WorldBegin\nShape \"sphere\" \"float radius\" [1\n", "bad.pbrt:");
    expectInvalid("", "bad.pbrt:1:1: ");
}

TEST_F(InputTest, MalformedSceneFromStandardInput) {
    Launch launch{.arguments = {"render", "-"}};
    launch.input = "WorldBegin\nShape \"cone\"\n";
    expectFailure(run(launch), 3, ":2:7: ");
}

TEST_F(InputTest, MapThatIsMissing) {
    std::filesystem::remove(path("map.pgm"));
    expectInvalid(planet(), "bad.pbrt:8:");
    expectInvalid(planet(), "map.pgm");
}

TEST_F(InputTest, MapThatIsTruncated) {
    std::filesystem::resize_file(path("map.pgm"), 100);
    expectInvalid(planet(), "map.pgm");
}

TEST_F(InputTest, MapThatIsNoPicture) {
    folder_.write("map.pgm", "Not a picture at all.");
    expectInvalid(planet(), "map.pgm");
}

TEST_F(InputTest, SurfaceThatReachesTheCentre) {
    expectInvalid(planet("\"float maxdispl\" -200"), "bad.pbrt:8:1: ");
    expectInvalid(planet("\"float maxdispl\" -200"), "latitude");
}

TEST_F(InputTest, OutputFolderThatIsMissing) {
    expectFailure(run({"render", "planet.pbrt", "-o", "none/a.exr"}), 1, "none");
    expectFailure(run({"verify", "planet.pbrt", "-o", "none/a"}), 1, "none");
}

TEST_F(InputTest, OutputThatIsAFolder) {
    std::filesystem::create_directory(path("a.exr"));
    expectFailure(run({"render", "planet.pbrt", "-o", "a.exr"}), 1, "not a regular file");
}

TEST_F(InputTest, OutputFolderThatRefuses) {
    // Root may write anywhere but among the kernel's files.
    std::string folder = "/proc";
    if (geteuid() != 0) {
        folder = path("closed").string();
        std::filesystem::create_directory(folder);
        std::filesystem::permissions(folder, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    }
    expectFailure(run({"render", "planet.pbrt", "--quick", "--quiet", "-o", folder + "/a.exr"}), 1, folder);
}

TEST_F(InputTest, DeviceThatIsMissing) {
    expectFailure(run({"render", "planet.pbrt", "--device", "nonsense"}), 4, "nonsense");
    expectFailure(run({"render", "planet.pbrt", "--device", "97"}), 4, "this machine has");
    expectFailure(run({"verify", "planet.pbrt", "--device", "nonsense"}), 4, "nonsense");
    EXPECT_FALSE(exists("film.exr"));
}

TEST_F(InputTest, DriverThatIsMissing) {
    std::string missing = path("missing.json").string();
    for (const Launch& launch : {Launch{.arguments = {"render", "planet.pbrt"}}, Launch{.arguments = {"devices"}}}) {
        Launch without = launch;
        without.environment = {"VK_DRIVER_FILES=" + missing, "VK_ICD_FILENAMES=" + missing, "VK_ADD_DRIVER_FILES="};
        Outcome outcome = run(without);
        EXPECT_EQ(outcome.code, 4) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(holds(outcome.err, "no Vulkan device"));
        EXPECT_TRUE(holds(outcome.err, "--device host"));
    }
    EXPECT_FALSE(exists("film.exr"));
}

TEST_F(InputTest, TheHostTakesNoDriver) {
    std::string missing = path("missing.json").string();
    for (const char* device : {"host", "Host-Double"})
        for (const char* command : {"render", "verify"}) {
            Launch launch{.arguments = {command, "planet.pbrt", "--device", device}};
            launch.environment = {"VK_DRIVER_FILES=" + missing, "VK_ICD_FILENAMES=" + missing, "VK_ADD_DRIVER_FILES="};
            Outcome outcome = run(launch);
            EXPECT_EQ(outcome.code, 0) << command << ' ' << device << outcome.out << outcome.err;
        }
    EXPECT_TRUE(exists("film.exr"));
    expectFailure(run({"verify", "planet.pbrt", "--device", "host", "--validation"}), 2, "--validation");
    expectFailure(run({"bake", "planet.pbrt", "-o", "slope.exr", "--quantities", "slope", "--device", "host"}), 2,
                  "needs a Vulkan device");
}

TEST_F(InputTest, SelftestNamesEveryScene) {
    const Outcome outcome = run({"selftest", "--device", "host"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "images, mirror and panel"));
    EXPECT_TRUE(holds(outcome.out, "All 9 scenes hold."));
}

}  // namespace
}  // namespace dsphere::test
