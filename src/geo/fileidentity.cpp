#include "geo/fileidentity.h"

#include <algorithm>
#include <chrono>

#include "base/hash.h"
#include "image/inputfile.h"

namespace dsphere::geo {
namespace {

void addBytes(Hash& hash, InputFile& file, std::uint64_t position, std::uint64_t count) {
    std::vector<char> bytes(std::size_t(std::min(count, file.size() - position)));
    file.seek(position);
    file.read(bytes.data(), bytes.size());
    hash.bytes(bytes.data(), bytes.size());
}

void addSample(Hash& hash, InputFile& file) {
    constexpr std::uint64_t kEnd = 1 << 20, kBlock = 4096, kBlocks = 64;
    const std::uint64_t size = file.size();
    addBytes(hash, file, 0, kEnd);
    if (size <= kEnd) return;
    for (std::uint64_t k = 1; k <= kBlocks; ++k) addBytes(hash, file, size / (kBlocks + 1) * k, kBlock);
    addBytes(hash, file, size - kEnd, kEnd);
}

}  // namespace

std::string identityOf(const std::vector<std::filesystem::path>& files) {
    Hash times, content;
    for (const std::filesystem::path& path : files) {
        InputFile file(path);
        std::error_code error;
        const auto modified = std::filesystem::last_write_time(path, error).time_since_epoch();
        if (error) file.invalid("cannot be read: {}", error.message());
        times.word(std::uint64_t(std::chrono::nanoseconds(modified).count()));
        times.word(file.size());
        addSample(content, file);
    }
    return fmt::format("{:016x}{:016x}", times.value(), content.value());
}

}  // namespace dsphere::geo
