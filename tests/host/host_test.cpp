// The kernel compiled as C++, as a device: against the certified reference, and against the Vulkan device.

#include "host/hostrenderer.h"
#include "tests/render/world.h"
#include "tests/support/keepdriver.h"
#include "verify/verify.h"

#include <algorithm>
#include <cmath>

namespace dsphere::test {
namespace {

using host::HostRenderer;
using host::Precision;

/// Objects of every kind and material, lights of every kind that takes no file.
const char* const kEverything =
    "Material \"plastic\" \"rgb Kd\" [.3 .5 .1] \"rgb Ks\" [.4 .4 .4] \"float roughness\" .1\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" \"float maxdispl\" 15\n"
    "AttributeBegin Translate 1.6 -.3 .7 Material \"conductor\" \"float roughness\" .2\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"other.pgm\" \"string filter\" \"bspline\" \"float radius\" "
    ".5 "
    "\"float maxdispl\" 20\nAttributeEnd\n"
    "AttributeBegin Translate -1.6 .2 .3 Material \"matte\" \"rgb Kd\" [.7 .6 .5] \"float sigma\" 20\n"
    "Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\" \"float radius\" .5 \"float maxdispl\" 10\n"
    "AttributeEnd\n"
    "AttributeBegin Translate 0 -1.5 1 Material \"mirror\" Shape \"sphere\" \"float radius\" .3\nAttributeEnd\n"
    "AttributeBegin Translate -1 1.8 1 AreaLightSource \"diffuse\" \"rgb L\" [9 8 7] Shape \"sphere\" \"float radius\" "
    ".3\n"
    "AttributeEnd\n"
    "AttributeBegin Texture \"squares\" \"spectrum\" \"checkerboard\" \"float uscale\" 8 \"float vscale\" 8\n"
    "Material \"matte\" \"texture Kd\" \"squares\" Shape \"trianglemesh\" \"integer indices\" [0 1 2  0 2 3]\n"
    "\"point3 P\" [-5 -1.9 5  5 -1.9 5  5 -1.9 -5  -5 -1.9 -5] \"point2 uv\" [0 0  1 0  1 1  0 1]\nAttributeEnd\n"
    "LightSource \"infinite\" \"rgb L\" [.2 .2 .3]\nLightSource \"point\" \"point3 from\" [2 2 2]\n";

const std::string kPaths = "Integrator \"path\" \"integer maxdepth\" 3 PixelFilter \"gaussian\"";

class HostTest : public WorldTest {
  protected:
    static Image planes(const World& world, Precision precision) {
        return HostRenderer(world.packed, world.scene, Marcher::Exact, precision).renderPlanes(kVerifyPlanes, {});
    }

    /// The scenes of every shader variant.
    std::vector<World> worlds() const {
        std::vector<World> all;
        all.push_back(world(planet()));
        all.push_back(world(planet("\"float maxdispl\" 20 \"string filter\" \"bspline\"")));
        all.push_back(world(planet("\"float maxdispl\" 10 \"bool smoothnormals\" true") +
                            "Translate 1.2 0 .5 Shape \"sphere\" \"float radius\" .4\n"));
        all.push_back(world(kEverything, kPaths));
        return all;
    }
};

TEST_F(HostTest, HoldsTheContractInBothPrecisions) {
    for (const World& world : worlds())
        for (const Precision precision : {Precision::Float, Precision::Double}) {
            HostRenderer renderer(world.packed, world.scene, Marcher::Exact, precision);
            const verify::Report report = verify::verifyScene(renderer, world.scene, world.maps, 0, {}).report;
            EXPECT_TRUE(report.passed()) << report.table();
            EXPECT_GT(report.hits, 300u);
            if (precision == Precision::Double) {
                EXPECT_LT(report.distanceQuantile(1.0), 1.2e-7) << report.table();
            }
        }
}

std::size_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

// Float for float what lavapipe computes, but for divisions by constants, which spirv-opt makes products of
// reciprocals, and the driver's own sine and cosine. Other drivers round as they like.
TEST_F(HostTest, FloatsAreTheDevices) {
    gpu::Device device{{"", true}};
    for (const World& world : worlds()) {
        const Image there = Renderer(device, world.packed, world.scene, Marcher::Exact).renderPlanes(kVerifyPlanes, {});
        const Image here = planes(world, Precision::Float);
        ASSERT_EQ(here.channels.size(), there.channels.size());
        for (const char* name : {"id", "lit", "flags"})
            EXPECT_LE(differing(here.at(name).uints(), there.at(name).uints()), 3u) << name;
        for (const char* name : {"t", "P.X", "N.Y", "Ns.Z", "u", "v", "Albedo.R", "R", "G", "B", "start.X"}) {
            const auto &a = here.at(name).floats(), &b = there.at(name).floats();
            std::size_t off = 0;
            for (std::size_t i = 0; i < a.size(); ++i)
                off += !(a[i] == b[i] || std::abs(a[i] - b[i]) <= 1e-5f + 1e-3f * std::abs(b[i]));
            EXPECT_LE(off, 5u) << name << " of " << a.size();
        }
    }
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
}

// The same sample numbers, so the same paths, but where a rounding decides.
TEST_F(HostTest, PathsAreTheDevices) {
    gpu::Device device;
    const World made = world(kEverything, kPaths);
    const Image there = Renderer(device, made.packed, made.scene, Marcher::Exact).renderSums({}, 0, 4, 7, {}).total();
    const Image here =
        HostRenderer(made.packed, made.scene, Marcher::Exact, Precision::Float).renderSums({}, 0, 4, 7, {}).total();
    for (const char* name : {"R", "G", "B"}) {
        const auto &a = here.at(name).floats(), &b = there.at(name).floats();
        std::size_t off = 0;
        for (std::size_t i = 0; i < a.size(); ++i) off += std::abs(a[i] - b[i]) > 1e-3f * (1.0f + std::abs(b[i]));
        EXPECT_LE(off, a.size() / 100) << name;
    }
}

TEST_F(HostTest, SumsGoOnWhereTheyStopped) {
    const World made = world(kEverything, kPaths);
    HostRenderer renderer(made.packed, made.scene, Marcher::Exact, Precision::Float);
    const SampleSums whole = renderer.renderSums({}, 0, 3, 5, {});
    SampleSums part = renderer.renderSums({}, 0, 1, 5, {});
    EXPECT_EQ(part.samples(), 1);
    const SampleSums resumed = renderer.renderSums(std::move(part), 0, 3, 5, {});
    EXPECT_EQ(resumed.samples(), 3);
    for (const char* name : {"R", "G", "B"})
        EXPECT_EQ(resumed.total().at(name).floats(), whole.total().at(name).floats()) << name;
}

TEST_F(HostTest, StopsWhenTold) {
    const World made = world(planet());
    HostRenderer renderer(made.packed, made.scene, Marcher::Exact, Precision::Float);
    EXPECT_EQ(renderer.renderSums({}, 0, 3, 5, [](double) { return false; }).samples(), 1);
    EXPECT_THROW(renderer.renderPlanes(kAovPlanes, [](double) { return false; }), Error);
}

TEST_F(HostTest, MissesAreInfinitelyFar) {
    World small = world("Scale .1 .1 .1\n" + planet());
    const Image image = planes(small, Precision::Float);
    const auto& t = image.at("t").floats();
    const auto& id = image.at("id").uints();
    for (std::size_t i = 0; i < t.size(); ++i) ASSERT_EQ(std::isinf(t[i]), id[i] == 0) << i;
    EXPECT_TRUE(std::ranges::any_of(id, [](std::uint32_t k) { return k != 0; }));
}

TEST_F(HostTest, BaselinesMarchToo) {
    const World made = world(planet());
    const Image exact = planes(made, Precision::Float);
    for (const Marcher marcher : {Marcher::Naive, Marcher::NaiveShell, Marcher::Lipschitz}) {
        const Image image =
            HostRenderer(made.packed, made.scene, marcher, Precision::Float).renderPlanes(kVerifyPlanes, {});
        EXPECT_LE(differing(image.at("id").uints(), exact.at("id").uints()), 40u);
    }
}

}  // namespace
}  // namespace dsphere::test
