#include "surface/gaps.h"

#include "base/error.h"
#include "base/parallel.h"
#include "surface/preparemap.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace dsphere {

namespace {

template <typename T>
bool isUnknown(T stored, const Nodata& nodata, std::optional<int> code) {
    if constexpr (std::is_floating_point_v<T>)
        return nodata.is(stored) || !isHeight(stored);
    else
        return (code && int(stored) == *code) || nodata.is(float(stored));
}

/// Appends the runs of one row; returns how many texels are unknown, `width` of a row of nothing else.
template <typename T>
std::size_t findRuns(const T* samples, int width, int row, const Nodata& nodata, std::optional<int> code,
                     std::vector<GapRun>& runs) {
    const auto unknown = [&](int i) { return isUnknown(samples[i < width ? i : i - width], nodata, code); };
    int start = 0;
    while (start < width && unknown(start)) ++start;
    if (start == width) return std::size_t(width);
    std::size_t count = 0;
    int left = start;
    for (int right = start + 1; right <= start + width; ++right) {
        if (unknown(right)) continue;
        const int gap = right - left - 1;
        if (gap > 0) {
            const auto at = [&](int i) { return float(samples[i % width]); };
            runs.push_back({row, (left + 1) % width, gap, at(left), at(right)});
            count += std::size_t(gap);
        }
        left = right;
    }
    return count;
}

/// For each row the nearest one of those that are known, of two the northern.
std::vector<int> nearestKnown(const std::vector<std::uint8_t>& known) {
    const int height = int(known.size());
    std::vector<int> source(known.size());
    int north = -1, south = 0;
    for (int j = 0; j < height; ++j) {
        if (known[std::size_t(j)]) north = j;
        south = std::max(south, j);
        while (south < height && !known[std::size_t(south)]) ++south;
        const bool from_north = north >= 0 && (south >= height || j - north <= south - j);
        source[std::size_t(j)] = from_north ? north : south;
    }
    return source;
}

template <typename T>
void readRuns(const geo::LargeMap& map, const Nodata& nodata, std::vector<GapRun>& runs,
              std::vector<std::uint8_t>& known, std::uint64_t& unknown, const SurveyProgress& progress) {
    const int width = map.head().width, height = map.head().height;
    const int band = std::clamp((16 << 20) / width, 1, height);
    std::vector<T> samples(std::size_t(width) * std::size_t(band));
    for (int y = 0; y < height; y += band) {
        const int rows = std::min(band, height - y);
        if (progress) progress(double(y) / height);
        map.read(0, y, width, rows, samples.data());
        std::vector<std::vector<GapRun>> found(static_cast<std::size_t>(rows));
        std::vector<std::size_t> counts(found.size());
        parallelFor(std::size_t(rows), [&](std::size_t j) {
            counts[j] =
                findRuns(&samples[j * std::size_t(width)], width, y + int(j), nodata, map.unknownCode(), found[j]);
        });
        for (std::size_t j = 0; j < found.size(); ++j) {
            unknown += counts[j];
            known[std::size_t(y) + j] = counts[j] < std::size_t(width);
            runs.insert(runs.end(), found[j].begin(), found[j].end());
        }
        if (runs.size() > Gaps::kMostRuns)
            throwInvalid(
                "{}: its unknown texels lie in more than {} pieces; supported for maps that are read in windows: so "
                "many at most",
                map.head().type, Gaps::kMostRuns);
    }
}

}  // namespace

Gaps::Gaps(const geo::LargeMap& map, const Nodata& nodata, const SurveyProgress& progress) {
    std::vector<std::uint8_t> known(std::size_t(map.head().height), 1);
    geo::withSampleType(
        map.kind(), [&](auto sample) { readRuns<decltype(sample)>(map, nodata, runs_, known, unknown_, progress); });
    if (std::ranges::find(known, 1) == known.end())
        throwInvalid("every one of the {}x{} texels is unknown (nodata)", map.head().width, map.head().height);
    if (std::ranges::find(known, 0) != known.end()) row_source_ = nearestKnown(known);
}

template <typename T>
void Gaps::fill(int row, int first, int count, int width, T* samples) const {
    auto run = std::ranges::lower_bound(runs_, row, {}, &GapRun::row);
    for (; run != runs_.end() && run->row == row; ++run) {
        const int of_left = (run->count + 1) / 2;
        // The run as it lies in the window, which may see it twice: before and after the seam.
        for (const int shift : {0, -width}) {
            const int begin = std::max(run->first + shift, first);
            const int end = std::min(run->first + shift + run->count, first + count);
            const int turn = run->first + shift + of_left;
            for (int i = begin; i < end; ++i) samples[i - first] = T(i < turn ? run->left : run->right);
        }
    }
}

template void Gaps::fill(int, int, int, int, std::uint16_t*) const;
template void Gaps::fill(int, int, int, int, std::int16_t*) const;
template void Gaps::fill(int, int, int, int, float*) const;

}  // namespace dsphere
