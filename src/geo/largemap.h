#pragma once

// A map whose samples stay in its file: only the windows that are asked for are read.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/rawmap.h"

namespace dsphere::geo {

/// Maps of more texels are opened as a LargeMap where they can be.
inline constexpr std::uint64_t kLargeMapTexels = 1ull << 26;

/// How a map's samples are kept, exactly as the file holds them; 8-bit ones are widened to 16.
enum class SampleKind { UInt16, Int16, Float32 };

inline int bytesOf(SampleKind kind) {
    return kind == SampleKind::Float32 ? 4 : 2;
}

/// Calls `use` with a zero of the kind's type, and returns what that returns.
template <typename Use>
auto withSampleType(SampleKind kind, const Use& use) {
    switch (kind) {
        case SampleKind::UInt16:
            return use(std::uint16_t());
        case SampleKind::Int16:
            return use(std::int16_t());
        case SampleKind::Float32:
            break;
    }
    return use(float());
}

class LargeMap {
  public:
    virtual ~LargeMap() = default;

    /// All that readMap() would say of the map but its samples, which are empty. Rows run from the north, columns
    /// eastward, each longitude has one column. `width` and `height` are those of the placed map: rows that the file
    /// does not cover count, and are unknown. facts.offset_is_radius is decided without the samples.
    virtual const RawMap& head() const = 0;
    virtual SampleKind kind() const = 0;
    /// 16-bit kinds: the code that means "unknown", in the kind's own value; unset: all texels are known. Float32: NaN.
    virtual std::optional<int> unknownCode() const = 0;
    /// Reads the window of columns [x, x + width) and rows [y, y + height), within the map, row by row, into `to`:
    /// width * height samples of kind(). May be called from several threads at once. Throws Error (InvalidInput) when
    /// the file cannot be read there.
    virtual void read(int x, int y, int width, int height, void* to) const = 0;
    /// The map at `columns` x `rows` texels, no more than it has: the samples nearest their middles, or what the file's
    /// own overviews have there. NaN: unknown. Quick, but not exact. Throws Error (InvalidInput) as read() does.
    virtual std::vector<float> overview(int columns, int rows) const = 0;
    /// Tells the file's content at this time apart from all other files and times: for the names of caches.
    virtual std::string identity() const = 0;
};

/// Opens a map of at least `least_texels` texels whose file GDAL reads in windows: any TIFF, and all formats that say
/// where they lie except ASCII grids. Null: the map is smaller, of another format, a mean of several bands or a
/// palette, or the build has no GDAL. Throws Error (InvalidInput) as readMap() does, and for a side of more than 131072
/// texels or more than 131072x65536 in all. Reads no samples but the last one, which is missing where the file is cut
/// short.
std::shared_ptr<const LargeMap> openLargeMap(const std::filesystem::path& path, std::optional<int> band,
                                             std::uint64_t least_texels);

}  // namespace dsphere::geo
