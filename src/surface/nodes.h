#pragma once

#include "surface/heightmap.h"

#include <vector>

namespace dsphere {

/// The map as the marcher sees it: node rows from pole to pole, wrapping columns, every cell at most 2 pi / 512 wide
/// and pi / 256 high. A coarser map is subdivided, which leaves its bilinear surface as it is; a finer one is not
/// copied. Ripples have cells alone, of a 32nd of a period at most.
class NodeGrid {
  public:
    static constexpr int kLeastWidth = 512, kLeastRows = 256;  ///< a grid with fewer is subdivided

    /// Keeps a reference to `map`, which must outlive the grid.
    explicit NodeGrid(const Heightmap& map);

    const Heightmap& map() const { return map_; }
    int width() const { return width_; }
    int rows() const { return rows_; }  ///< rows of cells; there are rows() + 1 rows of nodes
    /// True: the first and last rows are half as high as the others (the polar caps of texel registration).
    bool halfCaps() const { return half_caps_; }
    /// Rows of cells in each polar cap, where heights run linearly in latitude whatever the filter.
    int capRows() const { return cap_rows_; }
    /// Where a node stands in the map's own rows and columns, whose values are at whole numbers; rows below 0 and above
    /// height - 1 lie in the caps (the pole at -0.5 and height - 0.5).
    double mapColumn(int i) const;
    double mapRow(int j) const;
    /// `width()` stored values; row 0 is the north pole's, row rows() the south pole's. None for ripples
    /// and for a map that stays in its file.
    const float* row(int j) const;
    /// The stored value of a node; of a map that stays in its file, which has no rows, too.
    float at(int i, int j) const { return map_.tiled ? tiledNode(i, j) : row(j)[i]; }

    double cellWidth() const;                 ///< radians of longitude
    double cellHeight() const;                ///< radians of latitude, of a row that is no cap
    double longitude(int i) const;            ///< of node column i, radians, any turn
    double colatitude(int j) const;           ///< of node row j, radians, 0 at the north pole
    double column(double longitude) const;    ///< fractional, unwrapped
    double nodeRow(double colatitude) const;  ///< fractional, as if caps were whole rows; its floor is the cell row

  private:
    float tiledNode(int i, int j) const;
    void subdivide();
    void spanRipples();

    const Heightmap& map_;
    int width_ = 0, rows_ = 0, cap_rows_ = 0;
    bool half_caps_ = false;
    double first_node_ = 0.0;  ///< longitude of column 0 in cells
    std::vector<float> north_, south_;
    std::vector<float> fine_;  ///< the subdivided rows, if any
};

}  // namespace dsphere
