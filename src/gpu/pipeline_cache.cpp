#include "gpu/pipeline_cache.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "base/atomicfile.h"
#include "base/cachefolder.h"
#include "base/error.h"

namespace dsphere::gpu {
namespace {

namespace fs = std::filesystem;

/// Stands before the driver's bytes. Drivers may trust their own data blindly (the specification lets them), so damage
/// must be seen here.
struct FileHeader {
    char magic[8] = {'d', 's', 'p', 'h', 'p', 'c', '0', '1'};
    std::uint64_t checksum = 0;
};
static_assert(sizeof(FileHeader) == 16);

constexpr std::uintmax_t kMaxFileBytes = 256u << 20;

/// FNV-1a, 64 bits.
std::uint64_t checksum(const std::vector<std::byte>& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (std::byte b : bytes) hash = (hash ^ std::uint64_t(b)) * 0x100000001b3u;
    return hash;
}

std::string hex(const std::uint8_t (&uuid)[VK_UUID_SIZE]) {
    std::string text;
    for (std::uint8_t byte : uuid) text += fmt::format("{:02x}", byte);
    return text;
}

/// Empty on any trouble.
std::vector<std::byte> readFile(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size <= sizeof(FileHeader) || size > kMaxFileBytes) return {};
    std::ifstream file(path, std::ios::binary);
    FileHeader header;
    std::vector<std::byte> bytes(std::size_t(size) - sizeof(header));
    file.read(reinterpret_cast<char*>(&header), sizeof(header));
    file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!file || std::memcmp(header.magic, FileHeader().magic, sizeof(header.magic)) != 0) return {};
    return checksum(bytes) == header.checksum ? bytes : std::vector<std::byte>();
}

void writeFile(const fs::path& path, const std::vector<std::byte>& bytes) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    FileHeader header;
    header.checksum = checksum(bytes);
    AtomicFile file(path);
    file.write(&header, sizeof(header));
    file.write(bytes.data(), bytes.size());
    file.commit();
}

/// The header that the specification puts before every driver's data fits this device.
bool fits(const std::vector<std::byte>& bytes, const VkPhysicalDeviceProperties& properties) {
    VkPipelineCacheHeaderVersionOne header;
    if (bytes.size() < sizeof(header)) return false;
    std::memcpy(&header, bytes.data(), sizeof(header));
    return header.headerSize >= sizeof(header) && header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
           std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

}  // namespace

PipelineCache::PipelineCache(VkPhysicalDevice physical, VkDevice device, const VolkDeviceTable& table)
    : device_(device), table_(&table) {
    VkPhysicalDeviceIDProperties id = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
    VkPhysicalDeviceProperties2 all = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    all.pNext = &id;
    vkGetPhysicalDeviceProperties2(physical, &all);
    if (const fs::path where = cacheFolder(); !where.empty()) {
        file_ = where / fmt::format("pipelines-{}-{}-{}.bin", hex(id.deviceUUID), hex(id.driverUUID),
                                    hex(all.properties.pipelineCacheUUID));
        loaded_ = readFile(file_);
        if (!fits(loaded_, all.properties)) loaded_.clear();
    }
    VkPipelineCacheCreateInfo create = {VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    create.initialDataSize = loaded_.size();
    create.pInitialData = loaded_.data();
    VkPipelineCache made = VK_NULL_HANDLE;
    // Without a cache every pipeline is still made, only slower: VK_NULL_HANDLE is a valid cache.
    if (table.vkCreatePipelineCache(device, &create, nullptr, &made) != VK_SUCCESS) return;
    cache_ = Handle<VkPipelineCache>(device, made, table.vkDestroyPipelineCache);
}

PipelineCache::~PipelineCache() {
    if (file_.empty() || !cache_.get()) return;
    try {
        std::size_t size = 0;
        if (table_->vkGetPipelineCacheData(device_, cache_.get(), &size, nullptr) != VK_SUCCESS) return;
        std::vector<std::byte> bytes(size);
        if (table_->vkGetPipelineCacheData(device_, cache_.get(), &size, bytes.data()) != VK_SUCCESS) return;
        bytes.resize(size);
        if (bytes != loaded_) writeFile(file_, bytes);
    } catch (const std::exception&) {
        // A cache that is not kept only costs time at the next start.
    }
}

}  // namespace dsphere::gpu
