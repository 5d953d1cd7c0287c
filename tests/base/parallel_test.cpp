#include "base/parallel.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace dsphere {
namespace {

TEST(ParallelFor, RunsEachIndexOnce) {
    for (std::size_t count : {0, 1, 2, 3, 1000, 100000}) {
        std::vector<std::atomic<int>> runs(count);
        parallelFor(count, [&](std::size_t i) { ++runs.at(i); });
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(runs[i], 1) << i << " of " << count;
    }
}

TEST(ParallelFor, RethrowsWhatABodyThrows) {
    for (std::size_t thrower : {0, 57, 999}) {
        try {
            parallelFor(1000, [&](std::size_t i) {
                if (i == thrower) throwInvalid("body {}", i);
            });
            ADD_FAILURE() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), "body " + std::to_string(thrower));
            EXPECT_EQ(error.code(), ExitCode::InvalidInput);
        }
    }
}

TEST(ParallelFor, StopsSoonAfterAThrow) {
    std::atomic<std::size_t> runs = 0;
    auto body = [&](std::size_t) {
        ++runs;
        throw std::runtime_error("stop");
    };
    EXPECT_THROW(parallelFor(1000000, body), std::runtime_error);
    EXPECT_LT(runs, 10000u);
}

TEST(ParallelFor, WorksAgainAfterAThrow) {
    EXPECT_THROW(parallelFor(8, [](std::size_t) { throw std::runtime_error("once"); }), std::runtime_error);
    std::atomic<int> runs = 0;
    parallelFor(8, [&](std::size_t) { ++runs; });
    EXPECT_EQ(runs, 8);
}

}  // namespace
}  // namespace dsphere
