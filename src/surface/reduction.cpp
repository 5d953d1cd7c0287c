#include "surface/reduction.h"

#include "base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>

namespace dsphere {

namespace {

constexpr int kMostReduction = 64, kWidestReduced = 2 * kReducedWidth;

}  // namespace

int reductionOf(int width, int height, Registration registration) {
    const int rows = registration == Registration::Texel ? height : height - 1;
    int best = 0;
    for (int reduction = 2; reduction <= kMostReduction && width % reduction == 0 && rows % reduction == 0;
         reduction *= 2) {
        best = reduction;
        if (width / reduction <= kReducedWidth) break;
    }
    const bool useful = best > 0 && width / best <= kWidestReduced && width / best >= NodeGrid::kLeastWidth &&
                        rows / best >= NodeGrid::kLeastRows;
    return useful ? best : 0;
}

template <typename T>
Reducer<T>::Reducer(Survey& survey, int width, int height, Registration registration, int reduction)
    : survey_(survey),
      width_(width),
      height_(height),
      reduction_(reduction),
      level_width_(width / reduction),
      level_height_(registration == Registration::Texel ? height / reduction : (height - 1) / reduction + 1),
      texel_(registration == Registration::Texel) {
    survey.reduction = reduction;
    survey.reduced.assign(std::size_t(level_width_) * std::size_t(level_height_), 0.0f);
}

template <typename T>
const T* Reducer<T>::row(int y) const {
    const bool old = y < first_;
    const std::vector<T>& tail = tail_;
    return old ? &tail[std::size_t(y - tail_first_) * std::size_t(width_)]
               : rows_ + std::size_t(y - first_) * std::size_t(width_);
}

// Means of squares of texels; of a gridline map the nodes that remain.
template <typename T>
void Reducer<T>::reduceRows(int y, int count) {
    const int f = reduction_;
    const int first = (y + f - 1) / f;
    const int end = texel_ ? (y + count) / f : (y + count - 1) / f + 1;
    parallelFor(std::size_t(std::max(0, end - first)), [&](std::size_t n) {
        const int J = first + int(n);
        float* const to = &survey_.reduced[std::size_t(J) * std::size_t(level_width_)];
        for (int I = 0; I < level_width_; ++I) {
            if (!texel_) {
                to[I] = float(row(f * J)[f * I]);
                continue;
            }
            double sum = 0.0;
            for (int j = 0; j < f; ++j) {
                const T* const from = row(f * J + j) + f * I;
                for (int i = 0; i < f; ++i) sum += double(from[i]);
            }
            to[I] = float(sum / (f * f));
        }
    });
}

/// The reduced map along the parallel of the whole map's row coordinate y, at its own columns.
template <typename T>
std::vector<float> Reducer<T>::levelRow(double y) const {
    const double shift = texel_ ? 0.5 : 0.0;
    const double place = (y + shift) / reduction_ - shift;
    const auto levelRowOf = [&](int J) { return &survey_.reduced[std::size_t(J) * std::size_t(level_width_)]; };
    std::vector<float> result(static_cast<std::size_t>(level_width_));
    if (texel_ && (place < 0.0 || place > level_height_ - 1)) {
        const bool north = place < 0.0;
        const float pole = north ? survey_.north_pole : survey_.south_pole;
        const double share = 2.0 * (north ? place + 0.5 : level_height_ - 0.5 - place);
        const float* const edge = levelRowOf(north ? 0 : level_height_ - 1);
        for (std::size_t I = 0; I < result.size(); ++I) result[I] = float(pole + share * (double(edge[I]) - pole));
        return result;
    }
    const int J = std::clamp(int(std::floor(place)), 0, std::max(0, level_height_ - 2));
    const double share = place - J;
    const float* const above = levelRowOf(J);
    const float* const below = levelRowOf(std::min(J + 1, level_height_ - 1));
    for (std::size_t I = 0; I < result.size(); ++I)
        result[I] = float(double(above[I]) + share * (double(below[I]) - double(above[I])));
    return result;
}

/// The greatest difference along a parallel, where lines of either map cross it: `level` is the reduced map there, the
/// whole one the mean of two rows (or twice the same).
template <typename T>
double Reducer<T>::differenceAlong(const float* level, const T* above, const T* below) const {
    const int f = reduction_, half = texel_ ? f / 2 : 0;
    const float shift = texel_ ? 0.5f : 0.0f;
    const auto whole = [&](int i) { return 0.5f * (float(above[i]) + float(below[i])); };
    float greatest = 0.0f;
    for (int I = 0; I < level_width_; ++I) {
        const float west = level[I], east = level[I + 1 < level_width_ ? I + 1 : 0];
        const int first = f * I + half;
        if (texel_) greatest = std::max(greatest, std::abs(0.5f * (whole(first - 1) + whole(first)) - west));
        for (int k = 0; k < f; ++k) {
            const int i = first + k < width_ ? first + k : first + k - width_;
            const float share = (float(k) + shift) / float(f);
            greatest = std::max(greatest, std::abs(whole(i) - (west + share * (east - west))));
        }
    }
    return double(greatest);
}

// Rows of the whole map, and the reduced map's own, which run between two of these where they are texels.
template <typename T>
void Reducer<T>::measure(int from, int to) {
    double greatest = 0.0;
    std::mutex mutex;
    parallelFor(std::size_t(std::max(0, to - from)), [&](std::size_t n) {
        const int y = from + int(n);
        if (!texel_ && (y == 0 || y == height_ - 1)) return;  // both maps hold the pole's value there
        double found = differenceAlong(levelRow(y).data(), row(y), row(y));
        if (texel_ && y % reduction_ == reduction_ / 2)
            found = std::max(found, differenceAlong(levelRow(y - 0.5).data(), row(y - 1), row(y)));
        const std::lock_guard lock(mutex);
        greatest = std::max(greatest, found);
    });
    // Rounding of floats here and in the means.
    const double size = std::max(std::abs(double(survey_.least)), std::abs(double(survey_.greatest)));
    survey_.reduced_error = std::max(survey_.reduced_error, greatest > 0.0 ? greatest + 1e-6 * size : 0.0);
}

template <typename T>
void Reducer<T>::add(const T* rows, int y, int count) {
    rows_ = rows;
    first_ = y;
    count_ = count;
    reduceRows(y, count);
    if (!texel_ && y == 0) std::fill_n(survey_.reduced.begin(), level_width_, survey_.north_pole);
    if (!texel_ && y + count == height_)
        std::fill_n(survey_.reduced.end() - level_width_, level_width_, survey_.south_pole);
    // Rows beyond the last reduced one lie between it and the next, which is still to come.
    const bool last = y + count == height_;
    const int known = (y + count) / reduction_ * reduction_ - reduction_ / 2 - (texel_ ? 0 : reduction_ / 2);
    const int end = last ? height_ : std::max(measured_, known);
    measure(measured_, end);
    measured_ = end;
    const int keep = std::max(0, end - 1);
    std::vector<T> tail;
    for (int j = keep; j < y + count && !last; ++j) tail.insert(tail.end(), row(j), row(j) + width_);
    tail_ = std::move(tail);
    tail_first_ = keep;
}

template class Reducer<std::uint16_t>;
template class Reducer<std::int16_t>;
template class Reducer<float>;

}  // namespace dsphere
