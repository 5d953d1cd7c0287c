#include "bench/contender.h"
#include "bench/method.h"
#include "bench/pixelorder.h"
#include "bench/suite.h"
#include "bench/views.h"
#include "scene/parser.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace dsphere::bench {
namespace {

using test::expectError;

Suite suiteOf(int width, const std::string& view) {
    Suite suite;
    suite.widths = {width};
    suite.percents = {5.0};
    suite.views = {view};
    return suite;
}

TEST(Suite, EveryMapUnderEveryDisplacementFromEveryView) {
    Suite suite;
    suite.widths = {16, 32};
    suite.percents = {5.0, 50.0};
    std::vector<Source> sources = suiteSources(suite);
    ASSERT_EQ(sources.size(), 4u);
    EXPECT_EQ(sources[0].views, 3);
    Workload last = sources[3].make();
    EXPECT_EQ(last.map, "fractal 32x16");
    EXPECT_EQ(last.percent, 50.0);
    EXPECT_EQ(last.views.size(), 3u);
    EXPECT_EQ(last.scene.lights.size(), 1u);
}

TEST(Suite, MapsAreTheSameEveryTime) {
    EXPECT_EQ(suiteMap(64).samples, suiteMap(64).samples);
    EXPECT_EQ(suiteMap(64).samples, test::fractalMap(64, 32).samples);
}

TEST(Suite, RefusesWhatItDoesNotKnow) {
    expectError(ExitCode::Usage, "'top'", [] { suiteSources(suiteOf(16, "top")); });
    for (int width : {0, -2, 33, 16386})
        expectError(ExitCode::Usage, "--maps", [&] { suiteSources(suiteOf(width, "limb")); });
    EXPECT_EQ(suiteSources(suiteOf(16, "limb"))[0].views, 1);
}

class SceneTest : public testing::Test {
  protected:
    Scene scene(const std::string& world) {
        test::writePgm16(folder_.path() / "map.pgm", test::fractalMap(64, 32));
        return parseScene("LookAt 0 0 4  0 0 0  0 1 0\nWorldBegin\n" + world, "a.pbrt", folder_.path());
    }
    test::TempFolder folder_;
};

TEST_F(SceneTest, TheFirstDisplacedSphereAndDistantLight) {
    Workload workload =
        sceneWorkload(scene("LightSource \"point\" \"point3 from\" [9 9 9]\n"
                            "LightSource \"distant\" \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]\n"
                            "Shape \"sphere\"\n"
                            "Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" \"float maxdispl\" 7\n"));
    ASSERT_EQ(workload.scene.shapes.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<DisplacedSphere>(workload.scene.shapes[0].geometry));
    ASSERT_EQ(workload.scene.lights.size(), 1u);
    EXPECT_EQ(std::get<DistantLight>(workload.scene.lights[0]).direction, dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(workload.percent, 7.0);
    EXPECT_EQ(workload.width, 64);
    ASSERT_EQ(workload.views.size(), 1u);
    double radius = std::get<Sphere>(smoothScene(workload).shapes[0].geometry).radius;
    EXPECT_GT(radius, workload.maps.reliefs[0].least_radius);
    EXPECT_LT(radius, workload.maps.reliefs[0].greatest_radius);
}

TEST_F(SceneTest, WithoutADisplacedSphereThereIsNothingToMeasure) {
    expectError(ExitCode::InvalidInput, "displacedsphere", [&] { sceneWorkload(scene("Shape \"sphere\"\n")); });
}

TEST(Methods, NamesAreUniqueAndFamiliesStayTogether) {
    std::set<std::string> names, families;
    std::string last;
    for (const Method& method : allMethods()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_TRUE(method.family == last || families.insert(method.family).second) << method.family;
        last = method.family;
        EXPECT_EQ(method.name.rfind(method.family, 0), 0u) << "reports tell the setting from the name";
    }
    EXPECT_EQ(families.contains("grid"), haveEmbree());
}

TEST(Methods, AreChosenByNameOrFamily) {
    EXPECT_EQ(chooseMethods({}).size(), allMethods().size());
    std::vector<Method> chosen = chooseMethods({"naive", "exact"});
    EXPECT_EQ(chosen.front().name, "exact") << "their own order";
    EXPECT_GT(chosen.size(), 2u);
    EXPECT_EQ(chooseMethods({"naive 3e-6"}).size(), 1u);
    expectError(ExitCode::Usage, "'exakt'", [] { chooseMethods({"exakt"}); });
}

TEST(PixelOrder, HoldsEveryPixelOnceInBlocks) {
    for (auto [width, height] : {std::pair(8, 8), std::pair(7, 5), std::pair(1, 9)}) {
        std::vector<std::uint32_t> order = packetOrder(width, height);
        std::set<std::uint32_t> seen(order.begin(), order.end());
        EXPECT_EQ(seen.size(), std::size_t(width * height));
        EXPECT_EQ(*seen.rbegin(), std::uint32_t(width * height - 1));
        EXPECT_EQ(order.size(), seen.size());
    }
    std::vector<std::uint32_t> order = packetOrder(8, 8);
    for (std::size_t k = 0; k < std::size_t(kPacketSize); ++k) EXPECT_TRUE(order[k] % 8 < 4 && order[k] / 8 < 4);
}

}  // namespace
}  // namespace dsphere::bench
