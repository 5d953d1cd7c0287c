#include "image/tiffcheck.h"

#include <array>
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

void checkEntry(const InputFile& file, const Format& format, const std::uint8_t* entry) {
    const std::size_t word = format.wordBytes();
    const std::size_t each = typeBytes(format.load(entry + 2, 2));
    const std::uint64_t count = format.load(entry + 4, word);
    if (each == 0 || count <= word / each) return;  // nothing, or within the entry
    const std::uint64_t offset = format.load(entry + 4 + word, word);
    if (offset > file.size() || count > (file.size() - offset) / each)
        file.invalid("TIFF: truncated or damaged: tag {} has {} values of {} bytes at byte {}, the file {} bytes",
                     format.load(entry, 2), count, each, offset, file.size());
}

}  // namespace

void checkTiffDirectory(InputFile& file) {
    file.rewind();
    std::array<std::uint8_t, 4> magic;
    file.read(magic.data(), magic.size());
    Format format{.little = magic[0] == 'I'};
    format.big = format.load(&magic[2], 2) == 43;
    if (format.big && (readNumber(file, format, 2) != 8 || readNumber(file, format, 2) != 0))
        file.invalid("TIFF: the header of a BigTIFF is damaged, expected offsets of 8 bytes");
    const std::uint64_t first = readNumber(file, format, format.wordBytes());
    if (first >= file.size())
        file.invalid("TIFF: truncated or damaged: the first directory is at byte {}, the file has {} bytes", first,
                     file.size());
    file.seek(first);
    const std::uint64_t entries = readNumber(file, format, format.big ? 8 : 2);
    if (entries < 1 || entries > kMaxEntries)
        file.invalid("TIFF: the first directory has {} entries, expected 1 to {}", entries, kMaxEntries);
    std::vector<std::uint8_t> bytes(std::size_t(entries) * format.entryBytes());
    file.read(bytes.data(), bytes.size());
    for (std::size_t k = 0; k < entries; ++k) checkEntry(file, format, &bytes[k * format.entryBytes()]);
    const std::uint64_t next = readNumber(file, format, format.wordBytes());
    if (next >= file.size())
        file.invalid("TIFF: truncated or damaged: the second directory is at byte {}, the file has {} bytes", next,
                     file.size());
}

}  // namespace dsphere
