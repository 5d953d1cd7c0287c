// The pipeline cache's file: made, reused, and never a reason to fail.

#include "gpu/pipeline_cache.h"

#include <fstream>

#include "base/cachefolder.h"
#include "gpu/buffer.h"
#include "gpu/pipeline.h"
#include "shaders/affine.spv.h"
#include "tests/gpu/fixture.h"

namespace dsphere::gpu {
namespace {

namespace fs = std::filesystem;

class PipelineCacheTest : public CacheTest {
  protected:
    /// A device's life with one pipeline; any validation message fails.
    static void run() {
        Device device({.selector = "", .validation = true});
        constexpr Binding::Kind kBindings[] = {Binding::StorageBuffer, Binding::StorageBuffer};
        const ComputePipeline pipeline(device, kSpirv_affine, kBindings, {}, 8, "affine");
        for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
    }
    /// The only file in the folder; empty if there is none or more than one.
    fs::path onlyFile() const {
        std::vector<fs::path> files;
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(cache_.path() / "dsphere", error))
            files.push_back(entry.path());
        return files.size() == 1 ? files[0] : fs::path();
    }
    static void write(const fs::path& path, const std::string& bytes) {
        std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    }
};

TEST_F(PipelineCacheTest, IsWrittenAndReused) {
    run();
    const fs::path file = onlyFile();
    ASSERT_FALSE(file.empty()) << "one file and no temporaries";
    const std::string bytes = test::readBytes(file);
    EXPECT_GT(bytes.size(), 16u + sizeof(VkPipelineCacheHeaderVersionOne) - 1);
    // Only a file that was refused or outgrown is written again, so an old date that stays shows that it was taken.
    const auto long_ago = fs::last_write_time(file) - std::chrono::hours(1000);
    fs::last_write_time(file, long_ago);
    run();
    EXPECT_EQ(onlyFile(), file);
    EXPECT_EQ(fs::last_write_time(file), long_ago);
}

TEST_F(PipelineCacheTest, DamageIsIgnoredAndRepaired) {
    run();
    const fs::path file = onlyFile();
    ASSERT_FALSE(file.empty());
    const std::string good = test::readBytes(file);
    std::string flipped = good, grown = good + "x";
    flipped.back() = char(flipped.back() ^ 1);
    for (const std::string& bad : {std::string(), std::string("dsph"), good.substr(0, 16), good.substr(0, 30), flipped,
                                   grown, std::string(5000, '\xff')}) {
        write(file, bad);
        run();
        EXPECT_EQ(onlyFile(), file);
        EXPECT_EQ(test::readBytes(file), good) << "after " << bad.size() << " bytes of damage";
    }
}

TEST_F(PipelineCacheTest, AnotherDevicesDataIsIgnored) {
    run();
    const fs::path file = onlyFile();
    ASSERT_FALSE(file.empty());
    const std::string good = test::readBytes(file);
    for (const std::size_t at : {std::size_t(0), std::size_t(4), std::size_t(8), std::size_t(12), std::size_t(16)}) {
        std::string foreign = good;
        foreign[16 + at] = char(foreign[16 + at] ^ 0x55);
        std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a, so that the header alone is wrong
        for (std::size_t i = 16; i < foreign.size(); ++i) hash = (hash ^ std::uint8_t(foreign[i])) * 0x100000001b3u;
        for (int i = 0; i < 8; ++i) foreign[8 + i] = char(hash >> (8 * i));
        write(file, foreign);
        run();
        EXPECT_EQ(test::readBytes(file), good) << "header byte " << at;
    }
}

TEST_F(PipelineCacheTest, UnwritableFolderIsHarmless) {
    write(cache_.path() / "dsphere", "a file where the folder should be");
    testing::internal::CaptureStderr();
    run();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(PipelineCacheTest, FolderFollowsTheBaseDirectoryRules) {
    const ScopedVariable home("HOME", "/somewhere");
    {
        const ScopedVariable cache("XDG_CACHE_HOME", "/elsewhere");
        EXPECT_EQ(cacheFolder(), "/elsewhere/dsphere");
    }
    for (const char* ignored : {"", "relative/path", static_cast<const char*>(nullptr)}) {
        const ScopedVariable cache("XDG_CACHE_HOME", ignored);
        EXPECT_EQ(cacheFolder(), "/somewhere/.cache/dsphere");
    }
    const ScopedVariable no_cache("XDG_CACHE_HOME", nullptr), no_home("HOME", nullptr);
    EXPECT_TRUE(cacheFolder().empty());
    run();
}

/// The device's own store of pipelines.
class PipelineStoreTest : public CacheTest {
  protected:
    static constexpr Binding::Kind kBindings[] = {Binding::StorageBuffer, Binding::StorageBuffer};

    VkPipeline make(std::vector<std::uint32_t> specialization) {
        return ComputePipeline(device_, kSpirv_affine, kBindings, specialization, 8, "affine").handle();
    }

    Device device_{{.selector = "", .validation = true}};
};

TEST_F(PipelineStoreTest, GivesTheSameForTheSameAlone) {
    const VkPipeline first = make({1, 2}), other = make({1, 3}), shorter = make({1});
    EXPECT_EQ(make({1, 2}), first);
    EXPECT_EQ(make({1, 3}), other);
    EXPECT_NE(first, other);
    EXPECT_NE(first, shorter);
    EXPECT_TRUE(device_.validationMessages().empty());
}

TEST_F(PipelineStoreTest, ForgetsThoseUsedLeastRecently) {
    PipelineStore store;
    for (std::size_t i = 0; i < PipelineStore::kMost; ++i)
        store.keep(std::to_string(i), std::make_shared<const PipelineObjects>());
    EXPECT_NE(store.find("0"), nullptr);
    store.keep("one more", std::make_shared<const PipelineObjects>());
    EXPECT_NE(store.find("0"), nullptr);
    EXPECT_EQ(store.find("1"), nullptr);
    EXPECT_NE(store.find("one more"), nullptr);
    store.clear();
    EXPECT_EQ(store.find("one more"), nullptr);
}

TEST_F(PipelineStoreTest, APipelineOutlivesItsPlaceInTheStore) {
    const ComputePipeline pipeline(device_, kSpirv_affine, kBindings, {}, 8, "affine");
    device_.pipelineStore().clear();
    Buffer a(device_, Buffer::Usage::Storage, Buffer::Place::Device, 64, "a");
    const BindingSet set(device_, pipeline, {&a, &a}, "set");
    EXPECT_TRUE(device_.validationMessages().empty());
}

}  // namespace
}  // namespace dsphere::gpu
