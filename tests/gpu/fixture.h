#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "base/error.h"
#include "gpu/device.h"
#include "tests/support/expecterror.h"
#include "tests/support/scopedvariable.h"
#include "tests/support/tempfolder.h"

namespace dsphere::gpu {

using test::ScopedVariable;

/// Each test has a cache folder of its own, never the user's.
class CacheTest : public testing::Test {
  protected:
    test::TempFolder cache_;
    ScopedVariable cache_home_{"XDG_CACHE_HOME", cache_.path().c_str()};
};

/// A device under validation; a test fails on any message that it leaves.
class GpuTest : public CacheTest {
  protected:
    void TearDown() override {
        for (const std::string& message : device_.validationMessages()) ADD_FAILURE() << message;
    }
    Device device_{DeviceOptions{.selector = "", .validation = true}};
};

/// Runs `action`, which must throw Error(`code`) with `part` in its message.
template <typename Action>
void expectError(Action action, ExitCode code, const std::string& part) {
    EXPECT_TRUE(test::holds(test::messageOf(code, action), part));
}

}  // namespace dsphere::gpu
