// Buffers and images: what goes in comes out, and the limits hold.

#include <numeric>

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/result.h"
#include "tests/gpu/fixture.h"

namespace dsphere::gpu {
namespace {

std::vector<std::uint32_t> counting(std::size_t count, std::uint32_t first) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

using BufferTest = GpuTest;
using ImageTest = GpuTest;
using LimitsTest = GpuTest;

TEST_F(BufferTest, RoundTripsInEveryPlace) {
    // The last size takes three rounds through the staging buffer, the last one short.
    for (const std::uint64_t words : {std::uint64_t(1), std::uint64_t(1023), kStagingBytes / 2 + 77}) {
        for (const Buffer::Place place : {Buffer::Place::Host, Buffer::Place::Device}) {
            Buffer buffer(device_, Buffer::Usage::Storage, place, words * 4, "numbers");
            EXPECT_EQ(buffer.size(), words * 4);
            const auto values = counting(words, 7);
            buffer.upload(0, buffer.size(), values.data());
            std::vector<std::uint32_t> back(words);
            buffer.download(0, buffer.size(), back.data());
            EXPECT_TRUE(back == values) << words << " words";
        }
    }
}

TEST_F(BufferTest, CopiesPartsAndLeavesTheRest) {
    for (const Buffer::Place place : {Buffer::Place::Host, Buffer::Place::Device}) {
        Buffer buffer(device_, Buffer::Usage::Uniform, place, 64, "part");
        const auto values = counting(16, 0);
        buffer.upload(0, 64, values.data());
        const std::uint32_t middle[] = {100, 101};
        buffer.upload(20, 8, middle);
        buffer.upload(64, 0, nullptr);
        std::uint32_t back[4] = {};
        buffer.download(16, 16, back);
        EXPECT_EQ(back[0], 4u);
        EXPECT_EQ(back[1], 100u);
        EXPECT_EQ(back[2], 101u);
        EXPECT_EQ(back[3], 7u);
    }
}

TEST_F(BufferTest, MapsHostMemory) {
    const Buffer buffer(device_, Buffer::Usage::Storage, Buffer::Place::Host, 100, "mapped");
    ASSERT_EQ(buffer.mapped().size(), 100u);
    buffer.mapped()[99] = std::byte(42);
    buffer.flush();
    std::byte back{};
    buffer.download(99, 1, &back);
    EXPECT_EQ(back, std::byte(42));
}

TEST_F(BufferTest, Moves) {
    Buffer first(device_, Buffer::Usage::Storage, Buffer::Place::Host, 16, "first");
    const VkBuffer handle = first.handle();
    Buffer second(std::move(first));
    EXPECT_EQ(second.handle(), handle);
    second = Buffer(device_, Buffer::Usage::Storage, Buffer::Place::Device, 32, "second");
    EXPECT_EQ(second.size(), 32u);
}

TEST_F(ImageTest, RoundTripsOddSizesInEveryFormat) {
    for (const Format format : {Format::R32Float, Format::R32Uint, Format::Rgba32Float}) {
        StorageImage image(device_, format, 37, 19, 3, "odd");
        const std::size_t words = 37 * 19 * texelBytes(format) / 4;
        for (std::uint32_t layer = 0; layer < 3; ++layer) {
            image.upload(layer, 0, 0, 37, 19, counting(words, layer * 100000).data());
        }
        for (std::uint32_t layer = 0; layer < 3; ++layer) {
            std::vector<std::uint32_t> back(words);
            image.download(layer, 0, 0, 37, 19, back.data());
            EXPECT_TRUE(back == counting(words, layer * 100000)) << "layer " << layer;
        }
    }
}

TEST_F(ImageTest, CopiesRectangles) {
    StorageImage image(device_, Format::R32Uint, 9, 7, 2, "rectangle");
    image.clear();
    const std::uint32_t pixels[] = {1, 2, 3, 4, 5, 6};
    image.upload(1, 5, 4, 3, 2, pixels);
    image.upload(1, 9, 7, 0, 0, nullptr);
    std::vector<std::uint32_t> back(63);
    image.download(1, 0, 0, 9, 7, back.data());
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 9; ++x) {
            const bool inside = x >= 5 && x < 8 && y >= 4 && y < 6;
            EXPECT_EQ(back[y * 9 + x], inside ? pixels[(y - 4) * 3 + x - 5] : 0u) << x << ", " << y;
        }
    }
    std::uint32_t two[2] = {};
    image.download(1, 6, 5, 2, 1, two);
    EXPECT_EQ(two[0], 5u);
    EXPECT_EQ(two[1], 6u);
    image.download(0, 5, 4, 2, 1, two);
    EXPECT_EQ(two[0] | two[1], 0u) << "the other layer is untouched";
    image.clear();
    image.download(1, 6, 5, 2, 1, two);
    EXPECT_EQ(two[0] | two[1], 0u);
}

TEST_F(ImageTest, RoundTripsThroughSeveralChunks) {
    // Rows of 12,004 bytes: 1,397 fit the staging buffer, so 1,601 take two rounds.
    StorageImage image(device_, Format::R32Uint, 3001, 1601, 1, "large");
    const auto values = counting(3001 * 1601, 1);
    image.upload(0, 0, 0, 3001, 1601, values.data());
    std::vector<std::uint32_t> back(values.size());
    image.download(0, 0, 0, 3001, 1601, back.data());
    EXPECT_TRUE(back == values);
}

TEST_F(LimitsTest, RefusesBuffersBeyondTheRange) {
    const std::uint64_t storage = device_.limits().max_storage_buffer_range + 1;
    const auto make = [&](Buffer::Usage usage, std::uint64_t bytes) {
        Buffer(device_, usage, Buffer::Place::Device, bytes, "huge");
    };
    expectError([&] { make(Buffer::Usage::Storage, storage); }, ExitCode::Failure,
                fmt::format("huge: {} asked, but maxStorageBufferRange of this device is {}", storage, storage - 1));
    expectError([&] { make(Buffer::Usage::Uniform, device_.limits().max_uniform_buffer_range + 1); }, ExitCode::Failure,
                "maxUniformBufferRange");
    expectError([&] { make(Buffer::Usage::Staging, device_.limits().max_allocation_size + 1); }, ExitCode::Failure,
                "maxMemoryAllocationSize");
}

TEST_F(LimitsTest, RefusesImagesBeyondTheSize) {
    const std::uint32_t side = device_.limits().max_image_dimension_2d;
    const std::uint32_t layers = device_.limits().max_image_array_layers;
    const auto make = [&](std::uint32_t w, std::uint32_t h, std::uint32_t l) {
        StorageImage(device_, Format::Rgba32Float, w, h, l, "map");
    };
    expectError([&] { make(side + 1, 1, 1); }, ExitCode::Failure,
                fmt::format("map: {} asked, but maxImageDimension2D (width) of this device is {}", side + 1, side));
    expectError([&] { make(1, side + 1, 1); }, ExitCode::Failure, "maxImageDimension2D (height)");
    expectError([&] { make(1, 1, layers + 1); }, ExitCode::Failure, "maxImageArrayLayers");
    expectError([&] { make(side, side, layers); }, ExitCode::Failure, "maxMemoryAllocationSize");
    expectError([&] { make(~0u, ~0u, ~0u); }, ExitCode::Failure, "maxImageDimension2D");
}

TEST_F(LimitsTest, RefusesMemoryBeyondTheHeap) {
    VkMemoryRequirements need = {device_.limits().max_allocation_size + 1, 256, ~0u};
    expectError([&] { device_.allocate(need, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "heap"); }, ExitCode::Failure,
                "heap: ");
    need.memoryTypeBits = 0;
    expectError([&] { device_.allocate(need, 0, 0, "nothing"); }, ExitCode::Failure, "no memory type");
}

TEST(ResultTest, NamesCallAndResult) {
    EXPECT_EQ(resultName(VK_ERROR_OUT_OF_DEVICE_MEMORY), "VK_ERROR_OUT_OF_DEVICE_MEMORY");
    EXPECT_EQ(resultName(VkResult(-77)), "VkResult -77");
    check(VK_SUCCESS, "vkNothing");
    expectError([] { check(VK_ERROR_DEVICE_LOST, "vkQueueSubmit"); }, ExitCode::Failure,
                "vkQueueSubmit: the device was lost (VK_ERROR_DEVICE_LOST)");
    expectError([] { check(VK_ERROR_TOO_MANY_OBJECTS, "vkMake"); }, ExitCode::Failure,
                "vkMake failed: VK_ERROR_TOO_MANY_OBJECTS");
}

}  // namespace
}  // namespace dsphere::gpu
