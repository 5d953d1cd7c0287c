#pragma once

#include "tests/conformance/rays.h"
#include "tests/conformance/world.h"
#include "verify/verify.h"

#include <gtest/gtest.h>

namespace dsphere::conformance {

/// The least number of rays that a case traces.
inline const std::uint64_t kLeastRays = std::uint64_t(kRays) * 5 / 6;

// The environment's DSPHERE_TEST_DEVICE names the device of all cases as --device does, host and host-double included;
// unset: the machine's CPU by Vulkan.

/// Whether that is the host.
bool onHost();
/// The Vulkan device, under validation, one a program, with a pipeline cache of its own. Not on the host.
gpu::Device& device();
std::unique_ptr<RayProbe> makeProbe(const PackedScene& packed);
std::unique_ptr<SceneRenderer> makeRenderer(const PackedScene& packed, const Scene& scene);
/// The mean of `samples` samples a pixel.
Image renderColour(SceneRenderer& renderer, int samples, std::uint32_t seed);

/// A case fails on any validation message.
class Conformance : public testing::Test {
  protected:
    void TearDown() override;
};

/// Runs the first shape, whose object space must be the world, or the whole picture. Fails on fewer than kLeastRays.
verify::Report probe(const World& world, const Queries& queries);
verify::Outcome picture(const World& world);
/// As picture(), of any size.
verify::Outcome smallPicture(const World& world);

/// Nothing of the report breaks the contract; prints it if something does.
void expectContract(const verify::Report& report);
/// The same but for the number of rays excused as tangent. Only for rays that are aimed at tangency.
void expectContractButTangents(verify::Report report);
/// The same but for the share of normals. Only for rays that are aimed at the edges of texels, where the surface has a
/// crease and so two or four normals; a test of its own holds them against each of these.
void expectContractButNormals(verify::Report report);

/// Prints a parameter of a case by its name, so that lists of tests stay readable.
template <typename Case>
std::string caseName(const testing::TestParamInfo<Case>& info) {
    return info.param.name;
}

}  // namespace dsphere::conformance
