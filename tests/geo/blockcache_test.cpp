#include "geo/blockcache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace dsphere::test {
namespace {

using geo::BlockCache;

constexpr std::size_t kMiB = std::size_t(1) << 20;

/// Fills a block with its number, and counts how often that is done.
struct Source {
    std::atomic<int> reads = 0;

    BlockCache::Samples from(BlockCache& cache, std::int64_t number, std::size_t bytes = kMiB) {
        return cache.get(number, bytes, [&](std::byte* to) {
            ++reads;
            std::fill_n(to, bytes, std::byte(number));
        });
    }
};

bool isOf(const BlockCache::Samples& samples, std::int64_t number, std::size_t bytes = kMiB) {
    return samples->size() == bytes &&
           std::ranges::all_of(*samples, [&](std::byte byte) { return byte == std::byte(number); });
}

TEST(BlockCache, ABlockIsReadOnceWhileItIsKept) {
    BlockCache cache;
    Source source;
    for (int turn = 0; turn < 3; ++turn)
        for (std::int64_t number = 0; number < 20; ++number) EXPECT_TRUE(isOf(source.from(cache, number), number));
    EXPECT_EQ(source.reads, 20);
}

TEST(BlockCache, TheOneAskedForLongestAgoLeaves) {
    constexpr auto kMost = std::int64_t(BlockCache::kBytes / kMiB);
    BlockCache cache;
    Source source;
    for (std::int64_t number = 0; number < kMost; ++number) source.from(cache, number);
    source.from(cache, 0);
    EXPECT_EQ(source.reads, kMost);
    source.from(cache, kMost);  // in place of 1
    source.from(cache, 0);
    EXPECT_EQ(source.reads, kMost + 1);
    EXPECT_TRUE(isOf(source.from(cache, 1), 1));
    EXPECT_EQ(source.reads, kMost + 2);
}

// Its memory is not the next block's before that.
TEST(BlockCache, ABlockInUseStaysAsItIs) {
    BlockCache cache;
    Source source;
    const BlockCache::Samples held = source.from(cache, 7, kMiB / 2);
    for (std::int64_t number = 10; number < 100; ++number) source.from(cache, number);
    EXPECT_TRUE(isOf(held, 7, kMiB / 2));
}

TEST(BlockCache, ThreadsShareWhatOneReads) {
    BlockCache cache;
    Source source;
    std::atomic<int> wrong = 0;
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&] {
            for (std::int64_t number = 0; number < 60; ++number) wrong += !isOf(source.from(cache, number), number);
        });
    threads.clear();
    EXPECT_EQ(wrong, 0);
    EXPECT_GE(source.reads, 60);
}

TEST(BlockCache, ABlockThatCannotBeReadIsTriedAgain) {
    BlockCache cache;
    Source source;
    EXPECT_THROW(cache.get(3, kMiB, [](std::byte*) { throw std::runtime_error("cut short"); }), std::runtime_error);
    EXPECT_TRUE(isOf(source.from(cache, 3), 3));
}

}  // namespace
}  // namespace dsphere::test
