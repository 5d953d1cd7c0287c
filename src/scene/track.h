#pragma once

#include <vector>

namespace dsphere {

/// How the values of a track run between its keys.
enum class Between {
    Linear,     ///< as numbers
    Logarithm,  ///< their logarithms; values are above 0
    Angle,      ///< degrees, the short way around from key to key
};

/// A value that is given at some frames and runs smoothly between them: a cubic from key to key whose slopes at the
/// keys are those of the parabola through the key and its two neighbours (Catmull-Rom, made for keys at unequal
/// distances), so that the first derivative is continuous. Before the first and after the last key it is held.
class Track {
  public:
    explicit Track(Between between = Between::Linear) : between_(between) {}

    /// `frame` is greater than that of every key before.
    void add(double frame, double value);
    bool empty() const { return keys_.empty(); }
    /// There is a key. Angles come out of any turn: 370 may stand for 10.
    double at(double frame) const;

  private:
    struct Key {
        double frame, value;  ///< the value as it is interpolated: a logarithm, or an angle near its neighbours
    };
    double interpolated(double frame) const;
    double slope(std::size_t key) const;
    double slopeBetween(std::size_t key) const;

    Between between_;
    std::vector<Key> keys_;
};

}  // namespace dsphere
