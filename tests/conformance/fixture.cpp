#include "tests/conformance/fixture.h"

#include "gpu/device.h"
#include "host/hostprobe.h"
#include "host/hostrenderer.h"
#include "render/renderer.h"
#include "tests/support/keepdriver.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"

#include <cstdlib>
#include <optional>

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

std::optional<host::Precision> hostPrecision() {
    if (test::testDevice() == "host") return host::Precision::Float;
    if (test::testDevice() == "host-double") return host::Precision::Double;
    return {};
}

std::string describe(const verify::Report& report) {
    std::string text = "\n" + report.table();
    for (const verify::Fault& fault : report.faults)
        text += "ray " + std::to_string(fault.ray) + ": " + fault.what + "\n";
    return text;
}

}  // namespace

bool onHost() {
    return hostPrecision().has_value();
}

gpu::Device& device() {
    static OwnDevice own;
    return own.device;
}

std::unique_ptr<RayProbe> makeProbe(const PackedScene& packed) {
    if (const auto precision = hostPrecision()) return std::make_unique<host::HostProbe>(packed, *precision);
    return std::make_unique<Probe>(device(), packed);
}

std::unique_ptr<SceneRenderer> makeRenderer(const PackedScene& packed, const Scene& scene) {
    if (const auto precision = hostPrecision())
        return std::make_unique<host::HostRenderer>(packed, scene, Marcher::Exact, *precision);
    return std::make_unique<Renderer>(device(), packed, scene, Marcher::Exact);
}

Image renderColour(SceneRenderer& renderer, int samples, std::uint32_t seed) {
    return pictureOf(renderer.renderSums({}, 0, samples, seed, {}));
}

void Conformance::TearDown() {
    if (onHost()) return;
    for (const std::string& message : device().validationMessages()) ADD_FAILURE() << message;
}

verify::Report probe(const World& world, const Queries& queries) {
    const PackedScene packed = packScene(world.scene, world.maps);
    verify::Report report = verify::verifyRays(*makeProbe(packed), world.scene, world.maps, queries);
    EXPECT_GE(report.rays, kLeastRays);
    return report;
}

verify::Outcome smallPicture(const World& world) {
    const PackedScene packed = packScene(world.scene, world.maps);
    return verify::verifyScene(*makeRenderer(packed, world.scene), world.scene, world.maps, 0, {});
}

verify::Outcome picture(const World& world) {
    verify::Outcome outcome = smallPicture(world);
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
