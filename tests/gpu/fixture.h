#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "gpu/device.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::gpu {

/// Sets an environment variable (nullptr: removes it) and puts the old state back at the end.
class ScopedVariable {
  public:
    ScopedVariable(std::string name, const char* value) : name_(std::move(name)) {
        if (const char* old = std::getenv(name_.c_str())) old_ = old;
        set(value);
    }
    ~ScopedVariable() { set(old_ ? old_->c_str() : nullptr); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

  private:
    void set(const char* value) const {
        if (value) {
            setenv(name_.c_str(), value, 1);
        } else {
            unsetenv(name_.c_str());
        }
    }
    std::string name_;
    std::optional<std::string> old_;
};

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
