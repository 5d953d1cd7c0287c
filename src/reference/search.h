#pragma once

// Bisection of a chord, front to back, that excludes pieces by proven bounds.

#include "reference/chord.h"

namespace dsphere::reference {

/// Where f steps to the other side: the root lies in low..high, most likely at `root` (s, object units).
struct Crossing {
    bool found = false;
    double low = 0.0, root = 0.0, high = 0.0;
};

enum class Side { Outside, Inside };

/// The first s in s0..s1 where f leaves the side that it is taken to be on at s0: from Outside the first f <= 0, from
/// Inside the first f >= 0. If f(s0) is on the other side by more than rounding, that is s0 itself.
Crossing firstCrossing(const Chord& chord, Side side, double s0, double s1);

struct Least {
    double s, f;
};

/// The least f over s0..s1, to within 1e-12 R, and where.
Least leastOnChord(const Chord& chord, double s0, double s1);

}  // namespace dsphere::reference
