#include "image/exrcheck.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "image/codecs.h"

// "OpenEXR File Layout": magic, version and flags, then for each part attributes (name, type, size, value; numbers are
// little-endian) up to an empty name; in files of several parts an empty header ends the list.

namespace dsphere {
namespace {

constexpr std::uint32_t kMagic = 20000630, kPartsFlag = 0x1000;
constexpr std::size_t kMaxName = 255, kMaxParts = 1024;

std::int32_t loadInt(const std::uint8_t* bytes) {
    return std::int32_t(load32(bytes, std::endian::little));
}

/// Up to its zero byte; an empty text at the end of the file.
std::string readText(InputFile& file) {
    std::string text;
    for (int c = file.get(); c > 0; c = file.get()) {
        text += char(c);
        if (text.size() > kMaxName) throwInvalid("a name of more than {} bytes in its header", kMaxName);
    }
    return text;
}

/// What a part's header says of its size.
struct Part {
    std::optional<std::array<std::int64_t, 2>> window;  ///< width, height of the data window
    std::optional<std::array<std::int64_t, 2>> tile;
    int compression = 0;

    std::uint64_t chunks() const;
};

/// Rows of a chunk of scanlines, by the number of the compression.
std::int64_t rowsOfChunk(int compression) {
    // NONE RLE ZIPS ZIP PIZ PXR24 B44 B44A DWAA DWAB
    constexpr std::array<std::int64_t, 10> kRows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    return compression >= 0 && std::size_t(compression) < kRows.size() ? kRows[std::size_t(compression)] : 256;
}

/// At the finest level; coarser ones have at most three times as many.
std::uint64_t Part::chunks() const {
    const auto count = [](std::int64_t length, std::int64_t step) { return std::uint64_t((length + step - 1) / step); };
    if (tile) return count((*window)[0], (*tile)[0]) * count((*window)[1], (*tile)[1]);
    return count((*window)[1], rowsOfChunk(compression));
}

/// The bytes of a value of each type whose size is fixed: OpenEXR reads so many whatever size the file states.
std::optional<std::size_t> bytesOfType(const std::string& type) {
    static const std::map<std::string, std::size_t> kBytes{{"box2f", 16},
                                                           {"box2i", 16},
                                                           {"chromaticities", 32},
                                                           {"compression", 1},
                                                           {"deepImageState", 1},
                                                           {"double", 8},
                                                           {"envmap", 1},
                                                           {"float", 4},
                                                           {"int", 4},
                                                           {"keycode", 28},
                                                           {"lineOrder", 1},
                                                           {"m33d", 72},
                                                           {"m33f", 36},
                                                           {"m44d", 128},
                                                           {"m44f", 64},
                                                           {"rational", 8},
                                                           {"tiledesc", 9},
                                                           {"timecode", 8},
                                                           {"v2d", 16},
                                                           {"v2f", 8},
                                                           {"v2i", 8},
                                                           {"v3d", 24},
                                                           {"v3f", 12},
                                                           {"v3i", 12}};
    const auto found = kBytes.find(type);
    return found == kBytes.end() ? std::nullopt : std::optional(found->second);
}

/// Whether a list of channels (a name, then 16 bytes, up to an empty name) is as long as its size states.
bool isChannelList(std::span<const std::uint8_t> value) {
    constexpr std::size_t kChannelBytes = 16;
    for (std::size_t at = 0;;) {
        const auto end = std::find(value.begin() + std::ptrdiff_t(at), value.end(), std::uint8_t(0));
        if (end == value.end()) return false;
        const auto next = std::size_t(end - value.begin()) + 1;
        if (next == at + 1) return next == value.size();
        if (next + kChannelBytes > value.size()) return false;
        at = next + kChannelBytes;
    }
}

void checkValue(const std::string& name, const std::string& type, std::span<const std::uint8_t> value) {
    const std::optional<std::size_t> fixed = bytesOfType(type);
    bool whole = !fixed || *fixed == value.size();
    if (type == "chlist") whole = isChannelList(value);
    if (type == "preview" && value.size() >= 8) {
        const std::uint64_t width = load32(&value[0], std::endian::little);
        const std::uint64_t height = load32(&value[4], std::endian::little);
        whole = 4 * width * height == value.size() - 8;
    }
    if (!whole)
        throwInvalid("damaged: the attribute {:?} of type {:?} has {} bytes, not those of its value", name, type,
                     value.size());
}

void takeAttribute(Part& part, const std::string& name, const std::string& type, const std::uint8_t* value) {
    if (name == "dataWindow" && type == "box2i") {
        const std::int64_t width = std::int64_t(loadInt(value + 8)) - loadInt(value) + 1;
        const std::int64_t height = std::int64_t(loadInt(value + 12)) - loadInt(value + 4) + 1;
        if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
            throwInvalid("the size is {}x{}, expected sides of 1 to {} and at most {} pixels", width, height, kMaxSide,
                         kMaxTexels);
        part.window = {width, height};
    }
    if (name == "tiles" && type == "tiledesc") {
        const std::int64_t width = load32(value, std::endian::little), height = load32(value + 4, std::endian::little);
        if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
            throwInvalid("tiles of {}x{} pixels, expected sides of 1 to {}", width, height, kMaxSide);
        part.tile = {width, height};
    }
    if (type == "compression") part.compression = value[0];
}

/// False where the list of parts ends.
bool readPart(InputFile& file, Part& part) {
    std::vector<std::uint8_t> value;
    bool any = false;
    for (std::string name = readText(file); !name.empty(); name = readText(file), any = true) {
        const std::string type = readText(file);
        std::array<std::uint8_t, 4> length;
        if (file.remaining() < length.size()) throwInvalid("truncated: its header has no end");
        file.read(length.data(), length.size());
        const std::int32_t size = loadInt(length.data());
        if (size < 0 || std::uint64_t(size) > file.remaining())
            throwInvalid("truncated or damaged: the attribute {:?} of {} bytes reaches beyond the file's end", name,
                         size);
        value.resize(std::size_t(size));
        file.read(value.data(), value.size());
        checkValue(name, type, value);
        takeAttribute(part, name, type, value.data());
    }
    return any;
}

}  // namespace

void checkExrHeaders(InputFile& file) {
    std::array<std::uint8_t, 8> start;
    file.rewind();
    if (file.remaining() < start.size()) return;
    file.read(start.data(), start.size());
    if (load32(&start[0], std::endian::little) != kMagic) throwInvalid("it does not begin as EXR files do");
    const std::uint32_t flags = load32(&start[4], std::endian::little);
    std::vector<Part> parts(1);
    while (readPart(file, parts.back()) && (flags & kPartsFlag)) {
        if (parts.size() > kMaxParts) throwInvalid("more than {} parts", kMaxParts);
        parts.emplace_back();
    }
    std::uint64_t chunks = 0;
    for (const Part& part : parts)
        if (part.window) chunks += part.chunks();
    if (8 * chunks > file.size())
        throwInvalid("truncated or damaged: a table of {} chunks in a file of {} bytes", chunks, file.size());
}

}  // namespace dsphere
