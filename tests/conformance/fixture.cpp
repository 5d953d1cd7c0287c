#include "tests/conformance/fixture.h"

#include "gpu/device.h"
#include "tests/support/keepdriver.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"

#include <cstdlib>

namespace dsphere::conformance {

namespace {

struct OwnDevice {
    test::TempFolder cache;
    gpu::Device device;

    OwnDevice() : device(options(cache)) {}

    static gpu::DeviceOptions options(const test::TempFolder& cache) {
        setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
        return {.selector = test::testDevice(), .validation = true};
    }
};

std::string describe(const verify::Report& report) {
    std::string text = "\n" + report.table();
    for (const verify::Fault& fault : report.faults)
        text += "ray " + std::to_string(fault.ray) + ": " + fault.what + "\n";
    return text;
}

}  // namespace

gpu::Device& device() {
    static OwnDevice own;
    return own.device;
}

void Conformance::TearDown() {
    for (const std::string& message : device().validationMessages()) ADD_FAILURE() << message;
}

verify::Report probe(const World& world, const Queries& queries) {
    verify::Report report = verify::verifyRays(device(), world.scene, world.maps, queries);
    EXPECT_GE(report.rays, kLeastRays);
    return report;
}

verify::Outcome picture(const World& world) {
    verify::Outcome outcome = verify::verifyScene(device(), world.scene, world.maps, {}, {});
    EXPECT_GE(outcome.report.rays, kLeastRays);
    return outcome;
}

void expectContract(const verify::Report& report) {
    std::vector<std::string> violations = report.violations();
    for (const std::string& line : violations) ADD_FAILURE() << line;
    EXPECT_TRUE(violations.empty()) << describe(report);
}

void expectContractButTangents(verify::Report report) {
    report.tangent = report.tangent_shadows = 0;
    expectContract(report);
}

void expectContractButNormals(verify::Report report) {
    report.normal_degrees.clear();
    expectContract(report);
}

}  // namespace dsphere::conformance
