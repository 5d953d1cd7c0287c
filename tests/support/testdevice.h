#pragma once

#include <cstdlib>
#include <string>

namespace dsphere::test {

/// The Vulkan device that tests compute on, as --device has it: DSPHERE_TEST_DEVICE, or the CPU's, which is on every
/// machine.
inline std::string testDevice() {
    const char* named = std::getenv("DSPHERE_TEST_DEVICE");
    return named ? named : "cpu";
}

}  // namespace dsphere::test
