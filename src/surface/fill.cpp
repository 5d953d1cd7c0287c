#include "surface/fill.h"

#include <algorithm>
#include <cassert>

namespace dsphere {
namespace {

/// Fills the gaps between one value and the next around the row, and returns how many texels it filled; a row of
/// nodata alone stays (and counts as a whole).
std::size_t fillRow(float* row, std::size_t width, const Nodata& nodata) {
    const auto known = [&](float stored) { return !nodata.is(stored); };
    // Most rows have no gaps; what follows walks around the row texel by texel.
    if (std::all_of(row, row + width, known)) return 0;
    const auto first = std::size_t(std::find_if(row, row + width, known) - row);
    if (first == width) return width;
    std::size_t filled = 0, left = first;  // `left` and `right` count on beyond the seam
    for (std::size_t right = first + 1; right <= first + width; ++right) {
        if (!known(row[right % width])) continue;
        for (std::size_t i = left + 1; i < right; ++i, ++filled)
            row[i % width] = row[(i - left <= right - i ? left : right) % width];
        left = right;
    }
    return filled;
}

/// Copies known rows over the unknown ones between them.
void fillRows(std::vector<float>& samples, std::size_t width, const std::vector<bool>& known) {
    const std::size_t height = known.size();
    const auto copy = [&](std::size_t from, std::size_t to) {
        std::copy_n(samples.begin() + std::ptrdiff_t(from * width), width,
                    samples.begin() + std::ptrdiff_t(to * width));
    };
    const auto first = std::size_t(std::find(known.begin(), known.end(), true) - known.begin());
    assert(first < height);
    for (std::size_t j = 0; j < first; ++j) copy(first, j);
    std::size_t north = first;
    for (std::size_t south = first + 1; south <= height; ++south) {
        const bool beyond = south == height;
        if (!beyond && !known[south]) continue;
        for (std::size_t j = north + 1; j < south; ++j) copy(beyond || j - north <= south - j ? north : south, j);
        north = south;
    }
}

}  // namespace

std::size_t fillNodata(std::vector<float>& samples, int width, int height, const Nodata& nodata) {
    assert(samples.size() == std::size_t(width) * std::size_t(height));
    if (!nodata.any()) return 0;
    const auto columns = std::size_t(width);
    std::vector<bool> known(std::size_t(height), true);
    std::size_t count = 0;
    for (std::size_t j = 0; j < known.size(); ++j) {
        const std::size_t filled = fillRow(&samples[j * columns], columns, nodata);
        known[j] = filled < columns;
        count += filled;
    }
    if (count > 0 && count < samples.size()) fillRows(samples, columns, known);
    return count;
}

}  // namespace dsphere
