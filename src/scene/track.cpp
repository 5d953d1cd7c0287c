#include "scene/track.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dsphere {

void Track::add(double frame, double value) {
    assert(keys_.empty() || frame > keys_.back().frame);
    if (between_ == Between::Logarithm) value = std::log(value);
    if (between_ == Between::Angle && !keys_.empty())
        value = keys_.back().value + std::remainder(value - keys_.back().value, 360.0);
    keys_.push_back({frame, value});
}

/// Of the straight line from a key to the next.
double Track::slopeBetween(std::size_t key) const {
    const Key &from = keys_[key], &to = keys_[key + 1];
    return (to.value - from.value) / (to.frame - from.frame);
}

// Of the parabola through three keys at the middle one: the mean of both sides' slopes, each weighed by the length of
// the other side.
double Track::slope(std::size_t key) const {
    if (key == 0) return slopeBetween(0);
    if (key + 1 == keys_.size()) return slopeBetween(key - 1);
    const double before = keys_[key].frame - keys_[key - 1].frame, after = keys_[key + 1].frame - keys_[key].frame;
    return (slopeBetween(key - 1) * after + slopeBetween(key) * before) / (before + after);
}

double Track::interpolated(double frame) const {
    if (frame <= keys_.front().frame) return keys_.front().value;
    if (frame >= keys_.back().frame) return keys_.back().value;
    const auto next = std::ranges::upper_bound(keys_, frame, {}, [](const Key& key) { return key.frame; });
    const auto first = std::size_t(next - keys_.begin()) - 1;
    const Key &from = keys_[first], &to = keys_[first + 1];
    const double length = to.frame - from.frame, s = (frame - from.frame) / length;
    // Hermite's cubic.
    const double rise = s * s * (3.0 - 2.0 * s);
    const double leaving = s * (1.0 - s) * (1.0 - s), arriving = -s * s * (1.0 - s);
    return from.value + rise * (to.value - from.value) +
           length * (leaving * slope(first) + arriving * slope(first + 1));
}

double Track::at(double frame) const {
    assert(!keys_.empty());
    const double value = interpolated(frame);
    return between_ == Between::Logarithm ? std::exp(value) : value;
}

}  // namespace dsphere
