// The whole run on a small suite: what it measures, never how fast.

#include "base/error.h"
#include "bench/devicecontender.h"
#include "bench/environment.h"
#include "bench/suite.h"
#include "gpu/device.h"
#include "tests/support/expecterror.h"
#include "tests/support/keepdriver.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace dsphere::bench {
namespace {

class MeasureTest : public testing::Test {
  protected:
    MeasureTest() : device_(options(cache_)) {
        plan_.methods = allMethods();
        plan_.repeats = 2;
        plan_.setups = 1;
        plan_.samples = 1000;
        suite_ = {.widths = {512}, .percents = {5.0}, .views = {"whole", "horizon"}, .width = 96, .height = 54};
    }
    void TearDown() override {
        for (const std::string& message : device_.validationMessages()) ADD_FAILURE() << message;
    }

    static gpu::DeviceOptions options(const test::TempFolder& cache) {
        setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
        return {.selector = test::testDevice(), .validation = true};
    }

    test::TempFolder cache_;
    gpu::Device device_;
    Plan plan_;
    Suite suite_;
};

TEST_F(MeasureTest, EveryMethodOnEveryView) {
    std::vector<report::ViewResult> views = measure(device_, suiteSources(suite_), plan_, {});
    ASSERT_EQ(views.size(), 2u);
    for (const report::ViewResult& view : views) {
        ASSERT_EQ(view.methods.size(), plan_.methods.size());
        EXPECT_GT(view.hit_share, 0.2);
        for (const report::MethodResult& method : view.methods) {
            SCOPED_TRACE(view.view + ", " + method.method);
            EXPECT_EQ(method.skipped, "");
            EXPECT_EQ(method.primary.device.count, 2);
            EXPECT_GT(method.primary.device.least, 0.0);
            EXPECT_EQ(method.primary.wall.count, 2);
            EXPECT_GT(method.memory_bytes, 96u * 54u * 4u - 1u);
            EXPECT_EQ(method.setup_seconds.measured(), &view == &views[0]);
            EXPECT_EQ(method.shadow_rays > 100u, method.family != "iterated");
            EXPECT_EQ(method.accuracy.has_value(), method.family != "smooth");
            EXPECT_EQ(method.accuracy ? method.accuracy->rays : 1000u, 1000u);
        }
    }
}

TEST_F(MeasureTest, ExactAndLipschitzHaveNoFaults) {
    plan_.methods = chooseMethods({"exact", "lipschitz"});
    suite_.percents = {15.0};
    for (const report::ViewResult& view : measure(device_, suiteSources(suite_), plan_, {}))
        for (const report::MethodResult& method : view.methods) {
            SCOPED_TRACE(view.view + ", " + method.method);
            EXPECT_EQ(method.accuracy->later_roots, 0u);
            EXPECT_EQ(method.accuracy->runaways, 0u);
            EXPECT_GT(method.fetches_per_hit, 1.0);
            if (method.method != "exact") continue;
            EXPECT_EQ(method.accuracy->wrong_verdicts + method.accuracy->wrong_shadows, 0u);
            EXPECT_LE(method.accuracy->distance_999, 3e-7);
        }
}

TEST_F(MeasureTest, ANaiveThresholdIsTheErrorItLeaves) {
    plan_.methods = chooseMethods({"naive"});
    suite_.views = {"whole"};
    report::ViewResult view = measure(device_, suiteSources(suite_), plan_, {}).at(0);
    double last = 1.0;
    for (const report::MethodResult& method : view.methods) {
        EXPECT_LT(method.accuracy->distance_median, last) << method.method;
        last = method.accuracy->distance_median;
    }
    EXPECT_LT(last, 3e-6);
}

TEST_F(MeasureTest, StopsWhenToldTo) {
    int calls = 0;
    test::expectError(ExitCode::Interrupted, "interrupted",
                      [&] { measure(device_, suiteSources(suite_), plan_, [&](double) { return ++calls < 5; }); });
}

TEST_F(MeasureTest, ProgressGrowsToOne) {
    plan_.methods = chooseMethods({"exact"});
    double last = 0.0;
    measure(device_, suiteSources(suite_), plan_, [&](double share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0);
        last = share;
        return true;
    });
    EXPECT_GT(last, 0.8);
}

// From another view the same picture as from a scene packed for it.
TEST_F(MeasureTest, AMovedCameraSeesWhatAFreshOneDoes) {
    Workload workload = suiteSources(suite_)[0].make();
    DeviceView moved(device_, workload.scene, workload.maps, workload.views[0]);
    moved.renderer().renderPlanes(kVerifyPlanes, {});
    moved.look(workload.views[1]);
    DeviceView fresh(device_, workload.scene, workload.maps, workload.views[1]);
    Image a = moved.renderer().renderPlanes(kVerifyPlanes, {}), b = fresh.renderer().renderPlanes(kVerifyPlanes, {});
    for (const Channel& channel : a.channels) EXPECT_EQ(channel.pixels, b.at(channel.name).pixels) << channel.name;
}

TEST_F(MeasureTest, TheEnvironmentIsDescribed) {
    report::Environment environment = describeEnvironment(device_, 0.5, systemLoad());
    EXPECT_EQ(environment.device, device_.info().name);
    EXPECT_GT(environment.cores, 0);
    EXPECT_GE(environment.load, 0.0);
    for (const std::string& text :
         {environment.version, environment.commit, environment.date, environment.cpu, environment.driver})
        EXPECT_FALSE(text.empty());
    EXPECT_EQ(environment.embree.empty(), !haveEmbree());
}

}  // namespace
}  // namespace dsphere::bench
