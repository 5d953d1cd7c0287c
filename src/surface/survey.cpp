#include "surface/survey.h"

#include "base/parallel.h"
#include "surface/bounds.h"
#include "surface/cubecells.h"
#include "surface/reduction.h"

#include <algorithm>
#include <cassert>
#include <future>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>

namespace dsphere {

namespace {

constexpr int kBand = 256;  // rows read at once: a multiple of every reduction and of the blocks' sides
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void include(float& least, float& greatest, float value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
}

/// The cells of the bounds by the band of rows where their nodes begin.
class CellsByBand {
  public:
    CellsByBand(const NodeGrid& grid, int side, int bands, int first_row) : boxes_(std::size_t(6) * side * side) {
        const CubeCells cells(side);
        parallelFor(std::size_t(side), [&](std::size_t n) {
            cells.visitLine(int(n), [&](int face, int i, int j, const Footprint& footprint) {
                boxes_[(std::size_t(face) * std::size_t(side) + std::size_t(j)) * std::size_t(side) + std::size_t(i)] =
                    nodesUnder(grid, footprint);
            });
        });
        const auto bandOf = [&](const NodeBox& box) {
            return std::size_t(std::clamp((box.top - first_row) / kBand, 0, bands - 1));
        };
        starts_.assign(std::size_t(bands) + 1, 0);
        for (const NodeBox& box : boxes_) ++starts_[bandOf(box) + 1];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        numbers_.resize(boxes_.size());
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t n = 0; n < boxes_.size(); ++n) numbers_[next[bandOf(boxes_[n])]++] = std::uint32_t(n);
    }

    const NodeBox& box(std::uint32_t number) const { return boxes_[number]; }
    std::span<const std::uint32_t> of(int band) const {
        return {&numbers_[starts_[std::size_t(band)]], starts_[std::size_t(band) + 1] - starts_[std::size_t(band)]};
    }

  private:
    std::vector<NodeBox> boxes_;
    std::vector<std::uint32_t> numbers_;
    std::vector<std::size_t> starts_;
};

template <typename T>
class Surveyor {
  public:
    Surveyor(const geo::LargeMap& source, const Gaps& gaps, const NodeGrid& grid)
        : source_(source),
          gaps_(gaps),
          grid_(grid),
          width_(grid.width()),
          height_(source.head().height),
          first_row_(grid.halfCaps() ? 1 : 0) {}

    Survey run(const SurveyProgress& progress) {
        const int side = boundsSide(width_), bands = (height_ + kBand - 1) / kBand;
        start(side);
        const CellsByBand cells(grid_, side, bands, first_row_);
        const Registration registration = grid_.map().registration;
        const int reduction = reductionOf(width_, height_, registration);
        std::optional<Reducer<T>> reducer;
        if (reduction > 0) reducer.emplace(survey_, width_, height_, registration, reduction);
        std::vector<std::uint32_t> unfinished;
        std::future<std::vector<T>> next = readBand(0);
        for (int band = 0; band < bands; ++band) {
            if (progress) progress(double(band) / bands);
            rows_ = next.get();
            y_ = band * kBand;
            count_ = int(rows_.size() / std::size_t(width_));
            if (band + 1 < bands) next = readBand((band + 1) * kBand);
            fillRows();
            measurePoles();
            measureValues();
            measureBlocks();
            measureSlopes();
            unfinished.insert(unfinished.end(), cells.of(band).begin(), cells.of(band).end());
            measureCells(cells, unfinished);
            std::erase_if(unfinished, [&](std::uint32_t n) { return cells.box(n).bottom - first_row_ < y_ + count_; });
            if (reducer) reducer->add(rows_.data(), y_, count_);
        }
        addPoles(cells);
        return std::move(survey_);
    }

  private:
    std::future<std::vector<T>> readBand(int y) const {
        return std::async(std::launch::async, [this, y] {
            std::vector<T> rows(std::size_t(width_) * std::size_t(std::min(kBand, height_ - y)));
            source_.read(0, y, width_, int(rows.size() / std::size_t(width_)), rows.data());
            return rows;
        });
    }

    T* row(int y) { return &rows_[std::size_t(y - y_) * std::size_t(width_)]; }
    /// Of the grid's nodes; those of the poles are none.
    const T* nodeRow(int j) { return row(j - first_row_); }
    int firstNodeRow() const { return std::max(y_ + first_row_, 1); }
    int endNodeRow() const { return std::min(y_ + count_ + first_row_, grid_.rows()); }

    void start(int side) {
        survey_.least = survey_.second_least = kInfinity;
        survey_.greatest = -kInfinity;
        CellExtremes& cells = survey_.cells;
        cells.side = side;
        cells.least.assign(std::size_t(6) * side * side, kInfinity);
        cells.greatest.assign(cells.least.size(), -kInfinity);
        survey_.blocks = emptyBlocks(grid_, width_ <= 32768 ? 3 : 4);
    }

    void fillRows() {
        if (!gaps_.any()) return;
        parallelFor(std::size_t(count_), [&](std::size_t j) {
            const int y = y_ + int(j);
            if (gaps_.source(y) == y) gaps_.fill(y, 0, width_, width_, row(y));
        });
        std::vector<T> copied;
        int copied_row = -1;
        for (int y = y_; y < y_ + count_; ++y) {
            const int from = gaps_.source(y);
            if (from == y) continue;
            if (from != copied_row) {
                copied.resize(std::size_t(width_));
                source_.read(0, from, width_, 1, copied.data());
                gaps_.fill(from, 0, width_, width_, copied.data());
                copied_row = from;
            }
            std::ranges::copy(copied, row(y));
        }
    }

    float meanOfRow(int y) {
        const T* const samples = row(y);
        double sum = 0.0;
        for (int i = 0; i < width_; ++i) sum += double(samples[i]);
        return float(sum / width_);
    }

    // The pole rows of a gridline map hold their mean; one of 16 bits rounds it, which nothing reads but the level of
    // detail, whose error tells of it.
    void measurePoles() {
        if (y_ == 0) survey_.north_pole = meanOfRow(0);
        if (y_ + count_ == height_) survey_.south_pole = meanOfRow(height_ - 1);
    }

    void measureValues() {
        std::mutex mutex;
        parallelFor(std::size_t(count_), [&](std::size_t j) {
            const T* const samples = row(y_ + int(j));
            T least = samples[0], greatest = samples[0];
            for (int i = 1; i < width_; ++i) {
                least = std::min(least, samples[i]);
                greatest = std::max(greatest, samples[i]);
            }
            // Most rows hold nothing as small as what is known of others.
            float second = kInfinity;
            std::uint64_t at_least = 0;
            for (int i = 0; i < width_; ++i) {
                if (samples[i] == least)
                    ++at_least;
                else
                    second = std::min(second, float(samples[i]));
            }
            const std::lock_guard lock(mutex);
            merge(float(least), second, at_least);
            survey_.greatest = std::max(survey_.greatest, float(greatest));
        });
    }

    void merge(float least, float second, std::uint64_t count) {
        if (least < survey_.least) {
            survey_.second_least = std::min(survey_.least, second);
            survey_.least = least;
            survey_.at_least = count;
        } else {
            const bool same = least == survey_.least;
            if (same) survey_.at_least += count;
            survey_.second_least = std::min(survey_.second_least, same ? second : least);
        }
    }

    void measureBlocks() {
        BlockExtremes& blocks = survey_.blocks;
        const int block = 1 << blocks.shift, from = firstNodeRow(), end = endNodeRow();
        if (from >= end) return;
        const int first = (from - 1) >> blocks.shift;
        const int last = std::min((end - 1) >> blocks.shift, blocks.rows - 1);
        parallelFor(std::size_t(last - first + 1), [&](std::size_t n) {
            const int bj = first + int(n);
            for (int j = std::max(from, bj * block); j < std::min(end, (bj + 1) * block + 1); ++j) {
                const T* const samples = nodeRow(j);
                for (int bi = 0; bi < blocks.columns; ++bi) {
                    const int i0 = bi * block, i1 = std::min(i0 + block, width_);
                    T least = samples[i1 < width_ ? i1 : 0], greatest = least;
                    for (int i = i0; i < i1; ++i) {
                        least = std::min(least, samples[i]);
                        greatest = std::max(greatest, samples[i]);
                    }
                    const std::size_t at = blocks.index(bi, bj);
                    include(blocks.least[at], blocks.greatest[at], float(least));
                    include(blocks.least[at], blocks.greatest[at], float(greatest));
                }
            }
        });
    }

    // Of the rows of cells whose southern nodes are in this band; the last one's, at a pole, when its mean is known.
    void measureSlopes() {
        BlockExtremes& blocks = survey_.blocks;
        const int block = 1 << blocks.shift, from = firstNodeRow() - 1, end = endNodeRow() - 1;
        if (from < end) {
            const int first = from >> blocks.shift, last = (end - 1) >> blocks.shift;
            parallelFor(std::size_t(last - first + 1), [&](std::size_t n) {
                const int bj = first + int(n);
                std::vector<float> squares(std::size_t(width_), 0.0f);
                for (int j = std::max(from, bj * block); j < std::min(end, (bj + 1) * block); ++j) {
                    const RowSlopes slopes(grid_, j);
                    if (j == 0)
                        raiseSlopes(slopes, poleRow(survey_.north_pole).data(), nodeRow(1), width_, squares.data());
                    else
                        raiseSlopes(slopes, j == from ? row_before_.data() : nodeRow(j), nodeRow(j + 1), width_,
                                    squares.data());
                }
                raiseSteepest(blocks, bj, squares);
            });
            const T* const last_row = nodeRow(end);
            row_before_.assign(last_row, last_row + width_);
        }
        if (y_ + count_ < height_) return;
        std::vector<float> squares(std::size_t(width_), 0.0f);
        raiseSlopes(RowSlopes(grid_, grid_.rows() - 1), row_before_.data(), poleRow(survey_.south_pole).data(), width_,
                    squares.data());
        raiseSteepest(blocks, blocks.rows - 1, squares);
    }

    std::vector<float> poleRow(float value) const { return std::vector<float>(std::size_t(width_), value); }

    void measureCells(const CellsByBand& cells, const std::vector<std::uint32_t>& numbers) {
        constexpr std::size_t kChunk = 1024;
        CellExtremes& extremes = survey_.cells;
        parallelFor((numbers.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
            for (std::size_t k = chunk * kChunk; k < std::min(numbers.size(), (chunk + 1) * kChunk); ++k)
                measureCell(cells.box(numbers[k]), extremes.least[numbers[k]], extremes.greatest[numbers[k]]);
        });
    }

    void measureCell(const NodeBox& box, float& least_of_cell, float& greatest_of_cell) {
        const int from = std::max(box.top, firstNodeRow()), end = std::min(box.bottom + 1, endNodeRow());
        if (from >= end) return;
        const int before_seam = std::min(box.count, width_ - box.first);
        T least = nodeRow(from)[box.first], greatest = least;
        for (int j = from; j < end; ++j) {
            const T* const samples = nodeRow(j);
            for (int i = box.first; i < box.first + before_seam; ++i) {
                least = std::min(least, samples[i]);
                greatest = std::max(greatest, samples[i]);
            }
            for (int i = 0; i < box.count - before_seam; ++i) {
                least = std::min(least, samples[i]);
                greatest = std::max(greatest, samples[i]);
            }
        }
        include(least_of_cell, greatest_of_cell, float(least));
        include(least_of_cell, greatest_of_cell, float(greatest));
    }

    void addPoles(const CellsByBand& cells) {
        CellExtremes& extremes = survey_.cells;
        for (std::size_t n = 0; n < extremes.least.size(); ++n) {
            const NodeBox& box = cells.box(std::uint32_t(n));
            if (box.top <= 0) include(extremes.least[n], extremes.greatest[n], survey_.north_pole);
            if (box.bottom >= grid_.rows()) include(extremes.least[n], extremes.greatest[n], survey_.south_pole);
        }
        BlockExtremes& blocks = survey_.blocks;
        for (int i = 0; i < blocks.columns; ++i) {
            const std::size_t north = blocks.index(i, 0), south = blocks.index(i, blocks.rows - 1);
            include(blocks.least[north], blocks.greatest[north], survey_.north_pole);
            include(blocks.least[south], blocks.greatest[south], survey_.south_pole);
        }
    }

    const geo::LargeMap& source_;
    const Gaps& gaps_;
    const NodeGrid& grid_;
    const int width_, height_, first_row_;
    Survey survey_;
    std::vector<T> rows_;        ///< [y_, y_ + count_)
    std::vector<T> row_before_;  ///< the last row of nodes before those, but the north pole's
    int y_ = 0, count_ = 0;
};

}  // namespace

Survey surveyMap(const geo::LargeMap& source, const Gaps& gaps, const NodeGrid& grid, const SurveyProgress& progress) {
    return geo::withSampleType(
        source.kind(), [&](auto sample) { return Surveyor<decltype(sample)>(source, gaps, grid).run(progress); });
}

}  // namespace dsphere
