#include "report/baseline.h"
#include "tests/report/examples.h"

#include <gtest/gtest.h>

namespace dsphere::report {
namespace {

using test::exampleResults;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Baseline, TheSameRunHasNoChange) {
    std::string text = changes(exampleResults(), exampleResults());
    EXPECT_TRUE(holds(text, "+0.0 %"));
    EXPECT_FALSE(holds(text, "* \n") || holds(text, "% *")) << text;
    EXPECT_FALSE(holds(text, "another"));
    EXPECT_FALSE(holds(text, "triangles")) << "a method that was not run has no change";
}

TEST(Baseline, ChangesBeyondTheSpreadHaveAStar) {
    Results now = exampleResults();
    now.views[0].methods[0].primary.device = {2e7, 1.8e7, 2.2e7, 5};   // 1e7 (0.9..1.1) before
    now.views[0].methods[0].shadow.device = {5.5e6, 4.5e6, 6.5e6, 5};  // 5e6 (4..6) before
    std::string text = changes(now, exampleResults());
    EXPECT_TRUE(holds(text, "+100.0 % *")) << text;
    EXPECT_TRUE(holds(text, "+10.0 %  ")) << text;
}

TEST(Baseline, ErrorsAndMachinesAreCompared) {
    Results now = exampleResults();
    now.environment.device = "another one";
    now.views[1].methods[1].accuracy->distance_999 = 2e-4;
    now.views[1].methods[1].accuracy->later_roots = 3;
    std::string text = changes(now, exampleResults());
    EXPECT_TRUE(holds(text, "another device: device then, another one now")) << text;
    EXPECT_TRUE(holds(text, "0.0001 -> 0.0002")) << text;
    EXPECT_TRUE(holds(text, "2 -> 5")) << text;
}

TEST(Baseline, OtherViewsAreNotCompared) {
    Results now = exampleResults();
    for (ViewResult& view : now.views) view.width *= 2;
    EXPECT_TRUE(holds(changes(now, exampleResults()), "no view and method in common"));
}

}  // namespace
}  // namespace dsphere::report
