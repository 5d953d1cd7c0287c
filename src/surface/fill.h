#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace dsphere {

/// Which stored values mean "unknown".
class Nodata {
  public:
    /// No value at all (unset), all NaNs, or the float nearest to a number within float's range.
    explicit Nodata(std::optional<double> value)
        : any_(value.has_value()), nan_(any_ && std::isnan(*value)), value_(any_ ? float(*value) : 0.0f) {}

    bool is(float stored) const { return any_ && (nan_ ? std::isnan(stored) : stored == value_); }
    bool any() const { return any_; }

  private:
    bool any_, nan_;
    float value_;
};

/// Replaces each nodata texel of the row-major map by its row's nearest other value, the row wrapping around; of two
/// at one distance the left one counts. A row of nodata alone becomes a copy of the nearest other row as filled, of
/// two the northern. Returns how many texels were nodata; when that is all of them, the map is left as it was.
std::size_t fillNodata(std::vector<float>& samples, int width, int height, const Nodata& nodata);

}  // namespace dsphere
