#pragma once

// Which texels of a map that stays in its file are unknown, and what takes their place: fillNodata()'s rule, kept as
// runs along the rows instead of as samples.

#include "geo/largemap.h"
#include "surface/fill.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace dsphere {

/// Called with the share of a pass that is done; throws to stop it.
using SurveyProgress = std::function<void(double share)>;

/// Unknown texels of one row between two known ones: `count` of them from column `first` on, around the seam if need
/// be. The first half of them, rounded up, takes the value `left`, the rest `right`.
struct GapRun {
    int row, first, count;
    float left, right;
};

class Gaps {
  public:
    /// None.
    Gaps() = default;
    /// Reads the whole map once, in bands of rows. Throws Error (InvalidInput) when every texel is unknown, and where
    /// the unknown ones lie in more pieces than kMostRuns.
    Gaps(const geo::LargeMap& map, const Nodata& nodata, const SurveyProgress& progress = {});
    Gaps(std::vector<GapRun> runs, std::vector<int> row_source, std::uint64_t unknown)
        : runs_(std::move(runs)), row_source_(std::move(row_source)), unknown_(unknown) {}

    static constexpr std::size_t kMostRuns = std::size_t(1) << 24;

    bool any() const { return unknown_ > 0; }
    std::uint64_t unknown() const { return unknown_; }
    /// The row that a row is a copy of, once that is filled: itself unless all of its texels are unknown.
    int source(int row) const { return row_source_.empty() ? row : row_source_[std::size_t(row)]; }
    /// Fills columns [first, first + count) of a row that is its own source; `samples` holds them.
    template <typename T>
    void fill(int row, int first, int count, int width, T* samples) const;

    const std::vector<GapRun>& runs() const { return runs_; }           ///< by row
    const std::vector<int>& rowSources() const { return row_source_; }  ///< empty: every row is its own

  private:
    std::vector<GapRun> runs_;
    std::vector<int> row_source_;
    std::uint64_t unknown_ = 0;
};

}  // namespace dsphere
