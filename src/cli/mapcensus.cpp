#include "cli/mapcensus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "surface/preparemap.h"

namespace dsphere::cli {

namespace {

MapCensus censusOfRow(std::span<const float> samples, int row) {
    MapCensus census;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const CountedTexel texel{samples[i], int(i), row};
        if (!isHeight(texel.value)) {
            ++census.unknown;
            census.not_finite += !std::isfinite(texel.value);
            continue;
        }
        ++census.known;
        census.sum += double(texel.value);
        if (!census.least || texel.value < census.least->value) census.least = texel;
        if (!census.greatest || texel.value > census.greatest->value) census.greatest = texel;
    }
    return census;
}

// `row` is a later one than those that were counted.
void addRow(MapCensus& census, const MapCensus& row) {
    census.known += row.known;
    census.unknown += row.unknown;
    census.not_finite += row.not_finite;
    census.sum += row.sum;
    if (row.least && (!census.least || row.least->value < census.least->value)) census.least = row.least;
    if (row.greatest && (!census.greatest || row.greatest->value > census.greatest->value))
        census.greatest = row.greatest;
}

// rowAt(j, buffer) gives the samples of a row, in the buffer where they lie nowhere else.
template <typename RowAt>
void addRows(MapCensus& census, int first, int count, RowAt rowAt) {
    std::vector<MapCensus> rows(static_cast<std::size_t>(count));
    parallelFor(rows.size(), [&](std::size_t k) {
        std::vector<float> buffer;
        rows[k] = censusOfRow(rowAt(first + int(k), buffer), first + int(k));
    });
    for (const MapCensus& row : rows) addRow(census, row);
}

template <typename Sample>
MapCensus censusOfFile(const geo::LargeMap& map, const std::function<bool(double)>& progress) {
    constexpr int kRows = 512;  // the height of common files' tiles, so that each is read once
    const int height = map.head().height;
    const auto width = std::size_t(map.head().width);
    const std::optional<int> unknown = map.unknownCode();
    std::vector<Sample> band(width * kRows);
    MapCensus census;
    for (int top = 0; top < height; top += kRows) {
        if (!progress(double(top) / height)) throw Error(ExitCode::Interrupted, "interrupted");
        const int rows = std::min(kRows, height - top);
        map.read(0, top, int(width), rows, band.data());
        addRows(census, top, rows, [&](int j, std::vector<float>& buffer) -> std::span<const float> {
            const Sample* row = &band[std::size_t(j - top) * width];
            buffer.assign(row, row + width);
            if (unknown) std::ranges::replace(buffer, float(*unknown), std::numeric_limits<float>::quiet_NaN());
            return buffer;
        });
    }
    return census;
}

}  // namespace

MapCensus censusOf(const RawMap& map) {
    MapCensus census;
    const auto width = std::size_t(map.width);
    addRows(census, 0, map.height,
            [&](int j, std::vector<float>&) { return std::span(map.samples).subspan(std::size_t(j) * width, width); });
    return census;
}

MapCensus censusOf(const geo::LargeMap& map, const std::function<bool(double)>& progress) {
    return geo::withSampleType(map.kind(), [&](auto sample) { return censusOfFile<decltype(sample)>(map, progress); });
}

}  // namespace dsphere::cli
