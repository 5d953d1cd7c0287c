#include "reference/search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace dsphere::reference {

namespace {

/// Pieces still to search: `left` to the top, the top to the next below, ... Halving 2 R down to 1e-13 R needs 45.
class Pieces {
  public:
    Pieces(const ChordPoint& first, const ChordPoint& last) : left_(first) { push(last); }

    bool empty() const { return size_ == 0; }
    const ChordPoint& left() const { return left_; }
    const ChordPoint& right() const { return ends_[size_ - 1]; }
    void push(const ChordPoint& middle) {
        assert(size_ < ends_.size());
        ends_[size_++] = middle;
    }
    void drop() { left_ = ends_[--size_]; }

  private:
    ChordPoint left_;
    std::array<ChordPoint, 64> ends_;
    std::size_t size_ = 0;
};

/// The width under which a piece is decided without proof. It grows when a ray takes absurdly long, so that every
/// search ends.
class Patience {
  public:
    explicit Patience(double radius) : width_(1e-13 * radius) {}

    double width() {
        if (++steps_ % 4096 == 0) width_ *= 4.0;
        return width_;
    }

  private:
    double width_;
    int steps_ = 0;
};

double middle(const ChordPoint& a, const ChordPoint& b) {
    return a.s + 0.5 * (b.s - a.s);
}

/// The least value of a function over a piece of that width, from its values at the ends and its slopes: two lines that
/// meet in between.
double leastBySlopes(double left, double right, const SlopeRange& slope, double width) {
    if (slope.least >= 0.0) return left;
    if (slope.greatest <= 0.0) return right;
    return (slope.greatest * left - slope.least * right + slope.least * slope.greatest * width) /
           (slope.greatest - slope.least);
}

class CrossingSearch {
  public:
    CrossingSearch(const Chord& chord, Side side) : chord_(chord), sign_(side == Side::Outside ? 1.0 : -1.0) {}

    Crossing run(double s0, double s1);

  private:
    /// Unresolved: f varies by less than its own rounding.
    enum class State { Excluded, Root, Open, Unresolved };

    double g(const ChordPoint& p) const { return sign_ * chord_.f(p); }  // > 0 on the side that we are on
    State decide(const ChordPoint& a, const ChordPoint& b) const;
    State decideBySlopes(const ChordPoint& a, const ChordPoint& b, const ChordBox& box) const;
    Crossing refine(ChordPoint a, ChordPoint b) const;
    Crossing enclose(double s, const ChordPoint& a, const ChordPoint& b) const;

    const Chord& chord_;
    double sign_;
};

CrossingSearch::State CrossingSearch::decide(const ChordPoint& a, const ChordPoint& b) const {
    const ChordBox box = chord_.box(a, b);
    const RadiusBounds r = chord_.radii(box);
    const double clearance = sign_ > 0.0 ? box.rho0 - r.upper : r.lower - box.rho1;
    if (clearance > chord_.surface().evaluationError(box.row0, box.row1)) return State::Excluded;
    return Chord::isSmall(box) ? decideBySlopes(a, b, box) : State::Open;
}

CrossingSearch::State CrossingSearch::decideBySlopes(const ChordPoint& a, const ChordPoint& b,
                                                     const ChordBox& box) const {
    SlopeRange slope = chord_.slopes(box);
    if (sign_ < 0.0) slope = {-slope.greatest, -slope.least};
    const double ga = g(a), gb = g(b);
    // Whatever precedes `a` is on our side: a value beyond it is rounding if it rises from there.
    if (slope.least > 0.0 || slope.greatest < 0.0) return gb > 0.0 ? State::Excluded : State::Root;
    const double width = b.s - a.s, rounding = chord_.surface().evaluationError(box.row0, box.row1);
    if (leastBySlopes(ga, gb, slope, width) > rounding) return State::Excluded;
    return std::max(-slope.least, slope.greatest) * width < rounding ? State::Unresolved : State::Open;
}

Crossing CrossingSearch::run(double s0, double s1) {
    if (!(s0 < s1)) return {};
    Pieces pieces(chord_.point(s0), chord_.point(s1));
    Patience patience(chord_.surface().greatestRadius());
    if (g(pieces.left()) < -chord_.surface().evaluationError()) return {true, s0, s0, s0};
    while (!pieces.empty()) {
        const ChordPoint &a = pieces.left(), &b = pieces.right();
        const State state = decide(a, b);
        if (state == State::Root) return refine(a, b);
        if (state == State::Excluded) {
            pieces.drop();
            continue;
        }
        const ChordPoint m = chord_.point(middle(a, b));
        if (state == State::Unresolved || b.s - a.s < patience.width()) {
            if (g(m) <= 0.0 || g(b) <= 0.0) return {true, a.s, m.s, b.s};
            pieces.drop();
        } else {
            pieces.push(m);
        }
    }
    return {};
}

// g falls from a to b, with g(b) <= 0: the Illinois form of regula falsi, with a bisection every fourth step.
Crossing CrossingSearch::refine(ChordPoint a, ChordPoint b) const {
    const ChordPoint low = a, high = b;
    const double enough = 1e-15 * chord_.surface().greatestRadius();
    double ga = g(a), gb = g(b);
    if (ga <= 0.0) return enclose(a.s, low, high);
    if (gb == 0.0) return enclose(b.s, low, high);
    double kept = 0.0;  // the sign of the end that moved last
    for (int k = 1; k < 200 && b.s - a.s > enough; ++k) {
        double s = a.s + (b.s - a.s) * (ga / (ga - gb));
        if (k % 4 == 0 || !(s > a.s && s < b.s)) s = middle(a, b);
        const ChordPoint m = chord_.point(s);
        const double gm = g(m);
        if (std::abs(gm) <= 0.1 * enough) return enclose(s, low, high);
        if (gm > 0.0) {
            if (kept > 0.0) gb *= 0.5;
            a = m;
            ga = gm;
        } else {
            if (kept < 0.0) ga *= 0.5;
            b = m;
            gb = gm;
        }
        kept = gm;
    }
    return enclose(middle(a, b), low, high);
}

/// Widens s until f has certified signs at both ends, within a..b.
Crossing CrossingSearch::enclose(double s, const ChordPoint& a, const ChordPoint& b) const {
    const double rounding = chord_.surface().evaluationError(std::min(a.row, b.row), std::max(a.row, b.row));
    Crossing crossing{true, a.s, s, b.s};
    for (double width = 2.0 * rounding; s - width > a.s; width *= 4.0) {
        if (sign_ * chord_.f(s - width) <= rounding) continue;
        crossing.low = s - width;
        break;
    }
    for (double width = 2.0 * rounding; s + width < b.s; width *= 4.0) {
        if (sign_ * chord_.f(s + width) >= -rounding) continue;
        crossing.high = s + width;
        break;
    }
    return crossing;
}

}  // namespace

Crossing firstCrossing(const Chord& chord, Side side, double s0, double s1) {
    return CrossingSearch(chord, side).run(s0, s1);
}

Least leastOnChord(const Chord& chord, double s0, double s1) {
    const double radius = chord.surface().greatestRadius(), tolerance = 1e-12 * radius;
    Pieces pieces(chord.point(s0), chord.point(s1));
    Patience patience(radius);
    Least least{s0, chord.f(pieces.left())};
    auto meet = [&](const ChordPoint& p) {
        const double f = chord.f(p);
        if (f < least.f) least = {p.s, f};
        return f;
    };
    meet(pieces.right());
    while (!pieces.empty()) {
        const ChordPoint &a = pieces.left(), &b = pieces.right();
        const ChordBox box = chord.box(a, b);
        double lower = box.rho0 - chord.radii(box).upper;
        if (lower < least.f - tolerance && Chord::isSmall(box))
            lower = std::max(lower, leastBySlopes(chord.f(a), chord.f(b), chord.slopes(box), b.s - a.s));
        if (lower >= least.f - tolerance || b.s - a.s < patience.width()) {
            pieces.drop();
            continue;
        }
        const ChordPoint m = chord.point(middle(a, b));
        meet(m);
        pieces.push(m);
    }
    return least;
}

}  // namespace dsphere::reference
