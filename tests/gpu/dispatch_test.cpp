// Pipelines, binding sets and batches, and that validation hears misuse.

#include <chrono>
#include <cstdint>
#include <cstring>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"
#include "shaders/affine.spv.h"
#include "shaders/scale.spv.h"
#include "tests/gpu/fixture.h"

namespace dsphere::gpu {
namespace {

struct AffinePush {
    std::uint32_t count, addend;
};

constexpr Binding::Kind kAffineBindings[] = {Binding::StorageBuffer, Binding::StorageBuffer};
constexpr Binding::Kind kScaleBindings[] = {Binding::StorageImage, Binding::UniformBuffer};

ComputePipeline affinePipeline(Device& device, std::uint32_t factor) {
    const std::uint32_t constants[] = {factor};
    return ComputePipeline(device, kSpirv_affine, kAffineBindings, constants, sizeof(AffinePush), "affine");
}

class DispatchTest : public GpuTest {
  protected:
    static constexpr std::uint32_t kCount = 100'003;  // odd, and many groups for every thread of the device
    static constexpr std::uint32_t kGroups = (kCount + 7) / 8;

    DispatchTest() {
        for (std::uint32_t i = 0; i < kCount; ++i) numbers_[i] = i;
        a_.upload(0, kCount * 4, numbers_.data());
    }
    std::vector<std::uint32_t> read(const Buffer& buffer) const {
        std::vector<std::uint32_t> values(kCount);
        buffer.download(0, kCount * 4, values.data());
        return values;
    }

    std::vector<std::uint32_t> numbers_ = std::vector<std::uint32_t>(kCount);
    Buffer a_{device_, Buffer::Usage::Storage, Buffer::Place::Device, kCount * 4, "a"};
    Buffer b_{device_, Buffer::Usage::Storage, Buffer::Place::Host, kCount * 4, "b"};
};

TEST_F(DispatchTest, AppliesSpecializationAndPushConstants) {
    const ComputePipeline pipeline = affinePipeline(device_, 3);
    const BindingSet set(device_, pipeline, {&a_, &b_}, "a to b");
    Batch batch(device_);
    batch.bind(pipeline, set);
    batch.push(AffinePush{kCount, 11});
    batch.dispatch(kGroups, 1, 1);
    const auto start = std::chrono::steady_clock::now();
    const double seconds = batch.submit();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    EXPECT_GT(seconds, 0.0);
    EXPECT_LE(seconds, wall.count() * 1.05 + 1e-4) << "device time is a part of the host's";
    const std::vector<std::uint32_t> values = read(b_);
    for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(values[i], (kCount - 1 - i) * 3 + 11) << i;
}

TEST_F(DispatchTest, BarrierOrdersDependentDispatches) {
    const ComputePipeline times2 = affinePipeline(device_, 2), times5 = affinePipeline(device_, 5);
    const BindingSet forth(device_, times2, {&a_, &b_}, "a to b"), back(device_, times5, {&b_, &a_}, "b to a");
    Batch batch(device_, "chain");
    for (int round = 0; round < 2; ++round) {
        batch.bind(times2, forth);
        batch.push(AffinePush{kCount, 1});
        batch.dispatch(kGroups, 1, 1);
        batch.barrier();
        batch.bind(times5, back);
        batch.push(AffinePush{kCount, 7});
        batch.dispatch(kGroups, 1, 1);
        batch.barrier();
    }
    batch.submit();
    const std::vector<std::uint32_t> values = read(a_);
    const auto once = [](std::uint32_t x) { return (x * 2 + 1) * 5 + 7; };
    for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(values[i], once(once(i))) << i;
}

TEST_F(DispatchTest, AsManyGroupsAsABufferSays) {
    const ComputePipeline pipeline = affinePipeline(device_, 3);
    const BindingSet set(device_, pipeline, {&a_, &b_}, "a to b");
    const Buffer counts(device_, Buffer::Usage::Storage, Buffer::Place::Device, 16, "counts");
    const std::vector<std::uint32_t> before = read(b_);
    const std::uint32_t none[3] = {0, 1, 1}, some[3] = {kGroups, 1, 1};
    Batch batch(device_);
    batch.write(counts, none, 12);
    batch.bind(pipeline, set);
    batch.push(AffinePush{kCount, 1});
    batch.dispatchIndirect(counts);
    batch.submit();
    EXPECT_EQ(read(b_), before);
    batch.write(counts, some, 12);
    batch.bind(pipeline, set);
    batch.push(AffinePush{kCount, 1});
    batch.dispatchIndirect(counts);
    batch.submit();
    const std::vector<std::uint32_t> from = read(a_), to = read(b_);
    for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(to[i], from[kCount - 1 - i] * 3 + 1) << i;
}

TEST_F(DispatchTest, WritesAndCopiesInTheOrderOfTheBatch) {
    const ComputePipeline pipeline = affinePipeline(device_, 3);
    const BindingSet set(device_, pipeline, {&a_, &b_}, "a to b");
    const Buffer before(device_, Buffer::Usage::Staging, Buffer::Place::Host, 16, "before");
    const Buffer after(device_, Buffer::Usage::Staging, Buffer::Place::Host, 16, "after");
    const std::uint32_t zeros[2] = {};
    Batch batch(device_);
    batch.write(a_, zeros, 8);
    batch.bind(pipeline, set);
    batch.push(AffinePush{kCount, 1});
    batch.dispatch(kGroups, 1, 1);
    batch.copy(b_, before, 16);
    batch.write(b_, zeros, 8);
    batch.copy(b_, after, 16);
    batch.submit();
    auto words = [](const Buffer& buffer) {
        buffer.invalidate();
        std::vector<std::uint32_t> values(4);
        std::memcpy(values.data(), buffer.mapped().data(), 16);
        return values;
    };
    const std::vector<std::uint32_t> written = {3 * (kCount - 1) + 1, 3 * (kCount - 2) + 1, 3 * (kCount - 3) + 1,
                                                3 * (kCount - 4) + 1};
    EXPECT_EQ(words(before), written);
    EXPECT_EQ(words(after), (std::vector<std::uint32_t>{0, 0, written[2], written[3]}));
    EXPECT_EQ(read(b_).back(), 1u) << "a's first number was cleared before it was read";
}

TEST_F(DispatchTest, BatchIsUsedAgain) {
    const ComputePipeline pipeline = affinePipeline(device_, 1);
    const BindingSet forth(device_, pipeline, {&a_, &b_}, "a to b"), back(device_, pipeline, {&b_, &a_}, "b to a");
    Batch batch(device_);
    for (int round = 0; round < 10; ++round) {
        batch.bind(pipeline, round % 2 == 0 ? forth : back);
        batch.push(AffinePush{kCount, 1});
        batch.dispatch(kGroups, 1, 1);
        batch.submit();
    }
    EXPECT_GE(batch.submit(), 0.0) << "an empty batch is no error";
    const std::vector<std::uint32_t> values = read(a_);
    for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(values[i], i + 10) << i;
}

TEST_F(DispatchTest, ImagesAndUniformsAreBound) {
    StorageImage image(device_, Format::R32Float, 21, 10, 2, "texels");
    std::vector<float> texels(210);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = float(i);
    for (std::uint32_t layer = 0; layer < 2; ++layer) image.upload(layer, 0, 0, 21, 10, texels.data());
    Buffer parameters(device_, Buffer::Usage::Uniform, Buffer::Place::Host, 4, "parameters");
    const float factor = 1.5f;
    parameters.upload(0, 4, &factor);
    const ComputePipeline pipeline(device_, kSpirv_scale, kScaleBindings, {}, 0, "scale");
    const BindingSet set(device_, pipeline, {&image, &parameters}, "scale set");
    Batch batch(device_);
    batch.bind(pipeline, set);
    batch.dispatch(3, 2, 2);
    batch.submit();
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
        std::vector<float> back(210);
        image.download(layer, 0, 0, 21, 10, back.data());
        for (std::size_t i = 0; i < back.size(); ++i) ASSERT_EQ(back[i], float(i) * 1.5f) << i;
    }
}

TEST_F(DispatchTest, RefusesWhatTheDeviceCannot) {
    const ComputePipeline pipeline = affinePipeline(device_, 1);
    const BindingSet set(device_, pipeline, {&a_, &b_}, "set");
    Batch batch(device_);
    batch.bind(pipeline, set);
    batch.push(AffinePush{0, 0});
    const std::uint32_t most = device_.limits().max_workgroup_count[1];
    expectError([&] { batch.dispatch(1, most + 1, 1); }, ExitCode::Failure,
                fmt::format("{} asked, but maxComputeWorkGroupCount[1] of this device is {}", most + 1, most));
    const std::uint32_t push = device_.limits().max_push_constants_size + 4;
    expectError([&] { ComputePipeline(device_, kSpirv_affine, kAffineBindings, {}, push, "wide"); }, ExitCode::Failure,
                "maxPushConstantsSize");
    if (device_.limits().max_storage_images < 10'000) {
        const std::vector<Binding::Kind> many(device_.limits().max_storage_images + 1, Binding::StorageImage);
        expectError([&] { ComputePipeline(device_, kSpirv_affine, many, {}, 0, "many"); }, ExitCode::Failure,
                    "maxPerStageDescriptorStorageImages");
    }
}

/// Devices whose messages the tests want.
using ValidationTest = CacheTest;

bool contains(const std::vector<std::string>& messages, const std::string& part) {
    for (const std::string& message : messages) {
        if (message.find(part) != std::string::npos) return true;
    }
    return false;
}

TEST_F(ValidationTest, HearsMisuse) {
    const Device device({.selector = "", .validation = true});
    EXPECT_TRUE(device.validationMessages().empty());
    VkBufferCreateInfo create = {};
    create.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    create.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;  // the size stays 0
    VkBuffer buffer = VK_NULL_HANDLE;
    if (device.vk().vkCreateBuffer(device.handle(), &create, nullptr, &buffer) == VK_SUCCESS) {
        device.vk().vkDestroyBuffer(device.handle(), buffer, nullptr);
    }
    EXPECT_TRUE(contains(device.validationMessages(), "VUID-VkBufferCreateInfo-size-00912"));
}

TEST_F(ValidationTest, HearsAMissingBarrierAndNamesTheObject) {
    Device device({.selector = "", .validation = true});
    const Buffer a(device, Buffer::Usage::Storage, Buffer::Place::Device, 400, "alpha");
    const Buffer b(device, Buffer::Usage::Storage, Buffer::Place::Device, 400, "beta");
    const ComputePipeline pipeline = affinePipeline(device, 1);
    const BindingSet forth(device, pipeline, {&a, &b}, "forth"), back(device, pipeline, {&b, &a}, "back");
    Batch batch(device);
    for (const BindingSet* set : {&forth, &back}) {
        batch.bind(pipeline, *set);
        batch.push(AffinePush{100, 0});
        batch.dispatch(13, 1, 1);
    }
    EXPECT_TRUE(contains(device.validationMessages(), "SYNC-HAZARD-READ-AFTER-WRITE")) << "no sync validation";
    EXPECT_TRUE(contains(device.validationMessages(), "beta"));
}

TEST_F(ValidationTest, NothingIsLeftBehind) {
    testing::internal::CaptureStderr();
    {
        Device device({.selector = "", .validation = true});
        const Buffer a(device, Buffer::Usage::Storage, Buffer::Place::Device, 400, "alpha");
        const StorageImage image(device, Format::R32Uint, 4, 4, 1, "image");
        const ComputePipeline pipeline = affinePipeline(device, 1);
        const BindingSet set(device, pipeline, {&a, &a}, "set");
        const Batch batch(device);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ValidationTest, SilentWithoutIt) {
    Device device;
    const Buffer a(device, Buffer::Usage::Storage, Buffer::Place::Device, 400, "alpha");
    EXPECT_TRUE(device.validationMessages().empty());
}

}  // namespace
}  // namespace dsphere::gpu
