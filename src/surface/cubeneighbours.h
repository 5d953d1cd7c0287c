#pragma once

#include <cstddef>
#include <vector>

namespace dsphere {

/// A value for each cell of a cube map of side x side cells a face; faces as in Bounds.
class CubeGrid {
  public:
    CubeGrid() = default;
    explicit CubeGrid(int side);

    int side() const { return side_; }
    float& at(int face, int i, int j) { return values_[index(face, i, j)]; }
    float at(int face, int i, int j) const { return values_[index(face, i, j)]; }

    float greatest() const;
    /// The maxima of two by two cells.
    CubeGrid halved() const;
    /// The maxima of the cells at most `rings` cells away along either edge of the face, whose plane goes on beyond its
    /// edges: there the cells of other faces count that lie behind it. `rings` < side.
    CubeGrid dilated(int rings) const;

  private:
    std::size_t index(int face, int i, int j) const {
        return (std::size_t(face) * std::size_t(side_) + std::size_t(j)) * std::size_t(side_) + std::size_t(i);
    }
    float greatestBehind(int face, int i, int j) const;

    int side_ = 0;
    std::vector<float> values_;
};

}  // namespace dsphere
