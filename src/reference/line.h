#pragma once

// A ray as the line that it lies on, about its point nearest the centre, so that nothing cancels along it.

#include "reference/ray.h"

namespace dsphere::reference {

/// p(s) = c + s d with d unit and c perpendicular to d: |p|^2 = |c|^2 + s^2, s in object units. c comes from the moment
/// o x d in extended precision: it is off by less than 1e-16 |c| + 1e-19 |o|.
struct Line {
    dvec3 c{0.0}, d{0.0, 0.0, 1.0};
    long double distance = 0.0L;  ///< |c|
    long double origin_s = 0.0L;  ///< s of the ray's origin
    long double length = 1.0L;    ///< |direction|
    double s_begin = 0.0, s_end = -1.0;

    dvec3 at(double s) const { return c + s * d; }
    /// The ray's t at s: rounded to nearest, and down and up by two ulp.
    double tAt(long double s) const { return double((s - origin_s) / length); }
    double tBelow(long double s) const;
    double tAbove(long double s) const;
};

/// False if the ray misses everything whatever the shape (see Ray).
bool makeLine(const Ray& ray, Line& line);

}  // namespace dsphere::reference
