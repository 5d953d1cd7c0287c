#include "base/hash.h"

#include <gtest/gtest.h>

#include <set>

namespace dsphere::test {
namespace {

TEST(Hash, TellsLengthsAndTails) {
    std::set<std::uint64_t> seen;
    const char zeros[20] = {};
    for (std::size_t count = 0; count < sizeof zeros; ++count) {
        Hash hash;
        hash.bytes(zeros, count);
        EXPECT_TRUE(seen.insert(hash.value()).second) << count;
    }
    Hash nothing, null;
    nothing.bytes(zeros, 0);
    null.bytes(nullptr, 0);
    EXPECT_EQ(null.value(), nothing.value());
}

}  // namespace
}  // namespace dsphere::test
