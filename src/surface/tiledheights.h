#pragma once

// Heights that stay in their file, for maps too large to be held. What must be known of all of them comes from a
// survey, which is kept in the cache folder; the rest is read in windows when it is asked for.

#include "surface/survey.h"

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace dsphere {

/// May be used by several threads at once. All values are stored ones, unknown texels filled, counted from the value of
/// countFrom().
class TiledHeights {
  public:
    TiledHeights(std::shared_ptr<const geo::LargeMap> source, Gaps gaps);

    const geo::LargeMap& source() const { return *source_; }
    const Gaps& gaps() const { return gaps_; }
    geo::SampleKind kind() const { return source_->kind(); }
    int width() const { return source_->head().width; }
    int height() const { return source_->head().height; }

    /// Of the finest cells, blocks and all texels.
    const Survey& survey() const { return survey_; }
    void setSurvey(Survey survey) { survey_ = std::move(survey); }

    /// Takes Heightmap::zero, a value of kind(), away from all values and the survey; before anything is read.
    void countFrom(float zero);

    /// The value of a texel. Texels are kept in tiles of some that were asked for last, kCacheBytes of them.
    float at(int column, int row) const;
    /// `width` x `height` samples of kind() from column and row on, row by row: columns wrap, rows beyond the map
    /// repeat its first and last.
    void read(int column, int row, int width, int height, void* to) const;

    static constexpr int kCacheSide = 256;  ///< texels along an edge of a kept tile
    static constexpr std::size_t kCacheBytes = std::size_t(64) << 20;

  private:
    struct Tile {
        std::vector<float> samples;
    };

    std::shared_ptr<const Tile> tile(int number) const;
    template <typename T>
    void readAs(int column, int row, int width, int height, T* to) const;

    std::shared_ptr<const geo::LargeMap> source_;
    Gaps gaps_;
    Survey survey_;
    float zero_ = 0.0f;
    std::uint64_t id_;  ///< tells the tiles that a thread remembers from those of others
    mutable std::mutex mutex_;
    mutable std::list<std::pair<int, std::shared_ptr<const Tile>>> tiles_;  ///< the last asked for first
    mutable std::unordered_map<int, decltype(tiles_)::iterator> places_;
};

}  // namespace dsphere
