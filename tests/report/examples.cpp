#include "tests/report/examples.h"

namespace dsphere::test {

namespace {

using namespace report;

MethodResult method(const std::string& name, const std::string& family, double rate, double error) {
    MethodResult result;
    result.method = name;
    result.family = family;
    result.primary.device = {rate, 0.9 * rate, 1.1 * rate, 5};
    result.primary.wall = {0.8 * rate, 0.7 * rate, 0.9 * rate, 5};
    result.shadow.device = {0.5 * rate, 0.4 * rate, 0.6 * rate, 5};
    result.shadow.wall = result.shadow.device;
    result.shadow_rays = 1234;
    result.fetches_per_hit = 12.5;
    result.setup_seconds = {0.25, 0.2, 0.3, 3};
    result.memory_bytes = 5u << 20;
    if (error == 0.0) return result;
    Accuracy accuracy;
    accuracy.rays = 100;
    accuracy.hits = 40;
    accuracy.wrong_verdicts = 2;
    accuracy.tangent = 1;
    accuracy.shadow_rays = 30;
    accuracy.distance_median = 0.1 * error;
    accuracy.distance_999 = error;
    accuracy.distance_greatest = 2.0 * error;
    accuracy.pixels_999 = 1e3 * error;
    result.accuracy = accuracy;
    return result;
}

}  // namespace

Results exampleResults() {
    Results results;
    results.environment = {"1.2.3", "abc<def", "2026-01-02T03:04:05Z", "A \"CPU\" & more", 2, 1.5, "device", "driver",
                           0.25,    ""};
    results.repeats = 5;
    results.samples = 100;
    MethodResult skipped;
    skipped.method = skipped.family = "triangles";
    skipped.skipped = "needs some 7.5 GB of memory";
    for (const char* view : {"whole planet", "limb"})
        results.views.push_back(
            {"map, \"one\" <1>",
             1024,
             512,
             5.0,
             view,
             64,
             48,
             0.25,
             {method("exact", "exact", 1e7, 4e-8), method("grid", "grid", 2e7, 1e-4),
              method("grid 1/2", "grid", 3e7, 4e-4), method("smooth", "smooth", 5e7, 0.0), skipped}});
    return results;
}

}  // namespace dsphere::test
