#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace dsphere {

/// Which stored values mean "unknown".
class Nodata {
  public:
    /// No value at all (unset), all NaNs, or the float nearest to a number within float's range; with `nan_too` all
    /// NaNs besides.
    explicit Nodata(std::optional<double> value, bool nan_too = false)
        : number_(value && !std::isnan(*value)),
          nan_(nan_too || (value && std::isnan(*value))),
          value_(number_ ? float(*value) : 0.0f) {}

    bool is(float stored) const { return (number_ && stored == value_) || (nan_ && std::isnan(stored)); }
    bool any() const { return number_ || nan_; }

  private:
    bool number_, nan_;
    float value_;
};

/// Replaces each nodata texel of the row-major map by its row's nearest other value, the row wrapping around; of two
/// at one distance the left one counts. A row of nodata alone becomes a copy of the nearest other row as filled, of
/// two the northern. Returns how many texels were nodata; when that is all of them, the map is left as it was.
std::size_t fillNodata(std::vector<float>& samples, int width, int height, const Nodata& nodata);

}  // namespace dsphere
