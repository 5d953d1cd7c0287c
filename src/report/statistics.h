#pragma once

#include <vector>

namespace dsphere::report {

/// Repeated measurements of one thing.
struct Spread {
    double median = 0.0, least = 0.0, greatest = 0.0;
    int count = 0;  ///< 0: not measured, the rest is 0

    bool measured() const { return count > 0; }
};

/// The median of an even number is the mean of the middle two.
Spread spreadOf(std::vector<double> values);

/// What `work` units done in each of these seconds are a second: the least comes from the longest time. Times of 0 or
/// less (a difference of two that noise has swallowed) count as the least that is not; without any nothing is measured.
Spread ratesOf(double work, const std::vector<double>& seconds);

}  // namespace dsphere::report
