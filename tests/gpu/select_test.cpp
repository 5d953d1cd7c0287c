#include "gpu/select.h"

#include <algorithm>

#include "tests/gpu/fixture.h"

namespace dsphere::gpu {
namespace {

Candidate invented(int index, const char* name, VkPhysicalDeviceType type, const char* trouble = "") {
    Candidate one;
    one.info.index = index;
    one.info.name = name;
    one.info.unusable_reason = trouble;
    one.info.usable = one.info.unusable_reason.empty();
    one.type = type;
    return one;
}

std::vector<Candidate> machine() {
    return {invented(0, "llvmpipe (LLVM 15)", VK_PHYSICAL_DEVICE_TYPE_CPU),
            invented(1, "Old Card 9", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, "it has Vulkan 1.0.3"),
            invented(2, "Graphics 620", VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU),
            invented(3, "Big Card 12", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
            invented(4, "Other Card 12", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU)};
}

int selected(const std::string& selector) {
    const std::vector<Candidate> all = machine();
    return select(all, selector).info.index;
}

TEST(SelectTest, TakesTheBestUsableWithoutSelector) {
    EXPECT_EQ(selected(""), 3);
    std::vector<Candidate> fewer = machine();
    fewer.resize(3);
    EXPECT_EQ(select(fewer, "").info.index, 2);
    fewer.resize(2);
    EXPECT_EQ(select(fewer, "").info.index, 0);
}

TEST(SelectTest, TakesIndexTypeOrPartOfName) {
    EXPECT_EQ(selected("2"), 2);
    EXPECT_EQ(selected("cpu"), 0);
    EXPECT_EQ(selected("CPU"), 0);
    EXPECT_EQ(selected("LLVMpipe"), 0);
    EXPECT_EQ(selected("big card"), 3);
    EXPECT_EQ(selected("card 12"), 3);
    EXPECT_EQ(selected("card"), 3) << "the unusable first match is passed over";
}

TEST(SelectTest, SaysWhatExistsWhenNothingFits) {
    for (const char* selector : {"geforce", "5", "-1", "99999999999999999999"}) {
        expectError([&] { selected(selector); }, ExitCode::NoDevice, "\n  3: Big Card 12 (");
        expectError([&] { selected(selector); }, ExitCode::NoDevice, selector);
    }
    expectError([] { selected("1"); }, ExitCode::NoDevice, "unusable: it has Vulkan 1.0.3");
    expectError([] { selected("old"); }, ExitCode::NoDevice, "no usable Vulkan device matching 'old'");
}

using DeviceTest = CacheTest;

TEST_F(DeviceTest, ListsThisMachine) {
    const std::vector<DeviceInfo> all = listDevices();
    ASSERT_FALSE(all.empty());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].index, int(i));
        EXPECT_FALSE(all[i].name.empty());
        EXPECT_FALSE(all[i].driver.empty());
        EXPECT_EQ(std::count(all[i].api_version.begin(), all[i].api_version.end(), '.'), 2) << all[i].api_version;
        EXPECT_EQ(all[i].usable, all[i].unusable_reason.empty());
    }
}

TEST_F(DeviceTest, OpensByIndexNameAndType) {
    const std::vector<DeviceInfo> all = listDevices();
    EXPECT_EQ(Device({.selector = "0"}).info().name, all[0].name);
    EXPECT_EQ(Device({.selector = all[0].name.substr(0, 5)}).info().index, 0);
    bool has_cpu = false;
    for (const DeviceInfo& one : all) has_cpu |= one.type == "CPU";
    if (has_cpu) {
        EXPECT_EQ(Device({.selector = "cpu"}).info().type, "CPU");
    }
    expectError([] { Device({.selector = "nonsense"}); }, ExitCode::NoDevice, all[0].name);
    expectError([] { Device({.selector = "77"}); }, ExitCode::NoDevice, all[0].name);
}

TEST_F(DeviceTest, TwoDevicesLiveSideBySide) {
    const Device first;
    const Device second;
    EXPECT_EQ(first.info().name, second.info().name);
    EXPECT_NE(first.handle(), second.handle());
    EXPECT_GE(first.limits().max_image_dimension_2d, 4096u);
    EXPECT_GT(first.limits().memory_heap_size, 0u);
}

}  // namespace
}  // namespace dsphere::gpu
