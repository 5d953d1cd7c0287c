#include "image/tiffcheck.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// TIFF 6.0, section 2, and BigTIFF, whose counts and offsets have 8 bytes where TIFF's have 2 or 4.

namespace dsphere {
namespace {

constexpr std::uint64_t kMaxEntries = 4096;  // libtiff's own limit

struct Format {
    bool little = true, big = false;

    std::size_t wordBytes() const { return big ? 8 : 4; }           ///< of an offset or a value's count
    std::size_t entryBytes() const { return 4 + 2 * wordBytes(); }  ///< tag, type, count, value

    std::uint64_t load(const std::uint8_t* bytes, std::size_t count) const {
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < count; ++k) value = value << 8 | bytes[little ? count - 1 - k : k];
        return value;
    }
};

std::uint64_t readNumber(InputFile& file, const Format& format, std::size_t count) {
    std::array<std::uint8_t, 8> bytes;
    file.read(bytes.data(), count);
    return format.load(bytes.data(), count);
}

/// Bytes of one value; 0 for a type that is none, which libtiff skips.
std::size_t typeBytes(std::uint64_t type) {
    // BYTE ASCII SHORT LONG RATIONAL SBYTE UNDEFINED SSHORT SLONG SRATIONAL FLOAT DOUBLE IFD - - LONG8 SLONG8 IFD8
    constexpr std::array<std::uint8_t, 19> kBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type < kBytes.size() ? kBytes[type] : 0;
}

/// One field of a directory, as it lies in the file.
struct Entry {
    std::uint64_t tag, type, count;
    std::uint64_t offset;          ///< of its values, when they do not fit into the entry
    const std::uint8_t* in_entry;  ///< the values themselves when they do

    bool fits(const Format& format) const { return count <= format.wordBytes() / typeBytes(type); }
};

void checkEntry(const InputFile& file, const Format& format, const Entry& entry) {
    const std::size_t each = typeBytes(entry.type);
    if (each == 0 || entry.fits(format)) return;
    if (entry.offset > file.size() || entry.count > (file.size() - entry.offset) / each)
        file.invalid("TIFF: truncated or damaged: tag {} has {} values of {} bytes at byte {}, the file {} bytes",
                     entry.tag, entry.count, each, entry.offset, file.size());
}

/// The first directory; `bytes` holds what the entries point into.
struct Directory {
    Format format;
    std::vector<std::uint8_t> bytes;
    std::vector<Entry> entries;
    std::uint64_t next = 0;  ///< where the next directory is; 0: this is the last

    const Entry* find(std::uint64_t tag) const {
        const auto found = std::ranges::find(entries, tag, &Entry::tag);
        return found == entries.end() || typeBytes(found->type) == 0 ? nullptr : &*found;
    }
};

/// The directory at that byte; `which` is for messages: "first".
Directory readDirectoryAt(InputFile& file, const Format& format, std::uint64_t offset, const char* which) {
    Directory directory;
    directory.format = format;
    file.seek(offset);
    const std::uint64_t count = readNumber(file, format, format.big ? 8 : 2);
    if (count < 1 || count > kMaxEntries)
        file.invalid("TIFF: the {} directory has {} entries, expected 1 to {}", which, count, kMaxEntries);
    directory.bytes.resize(std::size_t(count) * format.entryBytes());
    file.read(directory.bytes.data(), directory.bytes.size());
    const std::size_t word = format.wordBytes();
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint8_t* at = &directory.bytes[k * format.entryBytes()];
        directory.entries.push_back({format.load(at, 2), format.load(at + 2, 2), format.load(at + 4, word),
                                     format.load(at + 4 + word, word), at + 4 + word});
        checkEntry(file, format, directory.entries.back());
    }
    directory.next = readNumber(file, format, word);
    return directory;
}

Directory readDirectory(InputFile& file) {
    file.rewind();
    std::array<std::uint8_t, 4> magic;
    file.read(magic.data(), magic.size());
    Format format;
    format.little = magic[0] == 'I';
    format.big = format.load(&magic[2], 2) == 43;
    if (format.big) {
        const std::uint64_t offset_bytes = readNumber(file, format, 2), zero = readNumber(file, format, 2);
        if (offset_bytes != 8 || zero != 0)
            file.invalid("TIFF: the header of a BigTIFF is damaged, expected offsets of 8 bytes");
    }
    const std::uint64_t first = readNumber(file, format, format.wordBytes());
    if (first >= file.size())
        file.invalid("TIFF: truncated or damaged: the first directory is at byte {}, the file has {} bytes", first,
                     file.size());
    Directory directory = readDirectoryAt(file, format, first, "first");
    if (directory.next >= file.size())
        file.invalid("TIFF: truncated or damaged: the second directory is at byte {}, the file has {} bytes",
                     directory.next, file.size());
    return directory;
}

/// All values of an entry of integers.
std::vector<std::uint64_t> valuesOf(InputFile& file, const Format& format, const Entry& entry) {
    const std::size_t each = typeBytes(entry.type);
    std::vector<std::uint8_t> bytes(std::size_t(entry.count) * each);
    if (entry.fits(format)) {
        std::copy_n(entry.in_entry, bytes.size(), bytes.begin());
    } else {
        file.seek(entry.offset);
        file.read(bytes.data(), bytes.size());
    }
    std::vector<std::uint64_t> values(std::size_t(entry.count));
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = format.load(&bytes[k * each], each);
    return values;
}

std::uint64_t firstValue(InputFile& file, const Directory& directory, std::uint64_t tag, std::uint64_t otherwise) {
    const Entry* entry = directory.find(tag);
    return entry && entry->count > 0 ? valuesOf(file, directory.format, *entry)[0] : otherwise;
}

/// Where the page's strips or tiles lie in the file.
struct Blocks {
    const char* name = "strip";
    std::vector<std::uint64_t> offsets, bytes;  ///< as many of both; both 0: such a block was never written
};

Blocks blocksOf(InputFile& file, const Directory& directory) {
    struct Tags {
        const char* name;
        std::uint64_t offsets, bytes;
    };
    for (const Tags& tags : {Tags{"strip", 273, 279}, Tags{"tile", 324, 325}}) {
        const Entry *offsets = directory.find(tags.offsets), *bytes = directory.find(tags.bytes);
        if (!offsets || !bytes) continue;
        Blocks blocks{tags.name, valuesOf(file, directory.format, *offsets), valuesOf(file, directory.format, *bytes)};
        const std::size_t count = std::min(blocks.offsets.size(), blocks.bytes.size());
        blocks.offsets.resize(count);
        blocks.bytes.resize(count);
        return blocks;
    }
    return {};
}

/// Whether a strip or tile was never written: GDAL's "sparse" files, where such a block counts as nodata.
bool isSparse(InputFile& file, const Directory& directory) {
    const Blocks blocks = blocksOf(file, directory);
    for (std::size_t k = 0; k < blocks.offsets.size(); ++k)
        if (blocks.offsets[k] == 0 && blocks.bytes[k] == 0) return true;
    return false;
}

/// Whether a further page is a mask of the first. Damaged pages after the first are nobody's concern.
bool hasMask(InputFile& file, const Directory& first) try {
    constexpr int kMostPages = 16;
    constexpr std::uint64_t kSubfileType = 254, kMask = 4;
    std::uint64_t next = first.next;
    for (int page = 0; next != 0 && page < kMostPages; ++page) {
        const Directory directory = readDirectoryAt(file, first.format, next, "next");
        if (firstValue(file, directory, kSubfileType, 0) & kMask) return true;
        next = directory.next;
    }
    return false;
} catch (const Error&) {
    return false;
}

bool isPlainSample(std::uint64_t bits, std::uint64_t format) {
    constexpr std::uint64_t kUnsigned = 1, kSigned = 2, kFloat = 3;
    return ((format == kUnsigned || format == kSigned) && (bits == 8 || bits == 16)) ||
           (format == kFloat && bits == 32);
}

}  // namespace

void checkTiffDirectory(InputFile& file) {
    readDirectory(file);
}

std::string whatPlainTiffLacks(InputFile& file) {
    struct Meaning {
        std::uint64_t tag;
        const char* says;
    };
    constexpr std::array kMeanings{
        Meaning{33550, "the size of its texels on the planet"},
        Meaning{33922, "where it lies on the planet"},
        Meaning{34264, "where it lies on the planet"},
        Meaning{34735, "its projection"},
        Meaning{42112, "what its values mean"},
        Meaning{42113, "which value means \"unknown\""},
    };
    const Directory directory = readDirectory(file);
    for (const Meaning& meaning : kMeanings)
        if (directory.find(meaning.tag)) return fmt::format("its tag {} says {}", meaning.tag, meaning.says);
    const std::uint64_t bits = firstValue(file, directory, 258, 1), format = firstValue(file, directory, 339, 1);
    if (!isPlainSample(bits, format)) return fmt::format("its samples have {} bits in format {}", bits, format);
    if (isSparse(file, directory)) return "some of its strips or tiles were never written";
    if (hasMask(file, directory)) return "a page of it is a mask";
    return "";
}

TiffPage tiffPageOf(InputFile& file) {
    const Directory directory = readDirectory(file);
    const auto value = [&](std::uint64_t tag, std::uint64_t otherwise) {
        return firstValue(file, directory, tag, otherwise);
    };
    constexpr std::uint64_t kBlackIsZero = 1, kTopLeft = 1;
    TiffPage page{value(256, 0), value(257, 0), false};
    page.plain_grey =
        value(277, 1) == 1 && value(262, kBlackIsZero) <= kBlackIsZero && value(274, kTopLeft) == kTopLeft;
    return page;
}

void checkTiffBlocks(InputFile& file) {
    const Blocks blocks = blocksOf(file, readDirectory(file));
    for (std::size_t k = 0; k < blocks.offsets.size(); ++k)
        if (blocks.offsets[k] > file.size() || blocks.bytes[k] > file.size() - blocks.offsets[k])
            file.invalid("TIFF: truncated or damaged: {} {} has {} bytes at byte {}, the file has {} bytes",
                         blocks.name, k, blocks.bytes[k], blocks.offsets[k], file.size());
}

}  // namespace dsphere
