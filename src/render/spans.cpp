#include "render/spans.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

dvec3 sum(const layout::vec4& hi, const layout::vec4& lo) {
    return dvec3(hi) + dvec3(lo);
}

/// |m'|^2 - k^2 |d'|^2 <= 0 for a row of pixels: a x^2 + 2 b x + c with x counted from the object's anchor.
struct RowQuadratic {
    double a, b, c;
};

/// The cone of rays that pass an object's centre within k, as the camera's linear rays see it: both nappes, or, of a
/// pinhole outside the shell, the one ahead.
class Cone {
  public:
    Cone(const layout::ObjectData& object, double reach)
        : d0_(sum(object.direction_0, object.direction_0_lo)),
          dx_(sum(object.direction_x, object.direction_x_lo)),
          dy_(sum(object.direction_y, object.direction_y_lo)),
          anchor_x_(object.anchor_x),
          anchor_y_(object.anchor_y) {
        double steps = object.direction_0.w;
        start_ = sum(object.point_0, object.point_0_lo) - steps * d0_;
        dvec3 start_x = sum(object.point_x, object.point_x_lo) - steps * dx_;
        dvec3 start_y = sum(object.point_y, object.point_y_lo) - steps * dy_;
        // Linear too, since either the start or the direction is constant.
        m0_ = glm::cross(start_, d0_);
        mx_ = glm::cross(start_x, d0_) + glm::cross(start_, dx_);
        my_ = glm::cross(start_y, d0_) + glm::cross(start_, dy_);
        double shell = std::sqrt(double(object.shell_squared)) * (1.0 + 1e-5);
        // A ray `reach` pixels beside a sampled one: |m'| is at most this larger, |d'| this smaller, relative to |d'|,
        // which is never below the image plane's distance.
        dvec3 across = glm::cross(dx_, dy_);
        double flat = glm::length(across);
        double plane = std::max(flat > 0.0 ? std::abs(glm::dot(d0_, across)) / flat : glm::length(d0_), 1e-30);
        double drift = glm::length(mx_) + glm::length(my_) + shell * (glm::length(dx_) + glm::length(dy_));
        k_ = shell + 2.0 * reach * drift / plane;
        // From a point outside, the rays that meet the shell are those within an angle of its centre, and the pixels
        // beside them: a cone with one nappe, even close above the ground.
        double distance = glm::length(start_), turn = reach * (glm::length(dx_) + glm::length(dy_)) / plane;
        bool one_start = flat > 0.0 && glm::length(start_x) + glm::length(start_y) < 1e-10 * distance;
        if (!one_start || !(distance > shell) || !(turn < 1.0)) return;
        double angle = std::asin(shell / distance) + std::asin(turn);
        ahead_ = angle < 0.5 * kPi;
        if (ahead_) k_ = distance * std::sin(angle);
    }

    /// Widens a row's span, of pixels from the box's left edge, to hold the row's rays of the cone.
    void widen(Span& span, const Box& box, int row) const {
        double y = box.y0 + row - anchor_y_;
        double first = box.x0, last = box.x1;
        cut(y, rowAt(y), first, last);
        if (!(first < last)) return;
        int x0 = int(first) - box.x0, x1 = int(last) - box.x0;
        span = span.empty() ? Span{x0, x1} : Span{std::min(span.x0, x0), std::max(span.x1, x1)};
    }

  private:
    RowQuadratic rowAt(double y) const {
        dvec3 d = d0_ + y * dy_, m = m0_ + y * my_;
        double kk = k_ * k_;
        return {glm::dot(mx_, mx_) - kk * glm::dot(dx_, dx_), glm::dot(m, mx_) - kk * glm::dot(d, dx_),
                glm::dot(m, m) - kk * glm::dot(d, d)};
    }

    /// False: a ray of the cone goes away from the centre. The line of a row meets each nappe in one piece, and they
    /// lie far apart, so that any place of a piece tells.
    bool isAhead(double x, double y) const {
        dvec3 d = d0_ + y * dy_ + x * dx_;
        return !ahead_ || !(glm::dot(start_, d) >= 1e-6 * glm::length(start_) * glm::length(d));
    }

    // Cuts [first, last) to the row's pixels. Written so that a NaN keeps the whole row.
    void cut(double y, const RowQuadratic& q, double& first, double& last) const {
        double discriminant = q.b * q.b - q.a * q.c, root = std::sqrt(std::max(discriminant, 0.0));
        if (q.a > 0.0) {
            if (discriminant < 0.0 || !isAhead(-q.b / q.a, y)) {
                last = first;
                return;
            }
            keepFrom((-q.b - root) / q.a, first);
            keepTo((-q.b + root) / q.a, last);
        } else if (ahead_ && q.a < 0.0) {
            // The row's line runs from one nappe into the other.
            if (discriminant < 0.0) return;                      // by rounding
            double doubled = -(q.b + std::copysign(root, q.b));  // what does not cancel of a root, times a
            double one = doubled / q.a, other = q.c / doubled;
            double left = std::min(one, other), right = std::max(one, other);
            bool left_ahead = isAhead(left - 1.0, y), right_ahead = isAhead(right + 1.0, y);
            if (left_ahead && right_ahead) return;
            if (left_ahead) keepTo(left, last);
            if (right_ahead) keepFrom(right, first);
            if (!left_ahead && !right_ahead) last = first;
        }
    }

    void keepFrom(double x, double& first) const { first = std::max(first, anchor_x_ + std::floor(x) - 1.0); }
    void keepTo(double x, double& last) const { last = std::min(last, anchor_x_ + std::ceil(x) + 2.0); }

    dvec3 d0_, dx_, dy_, m0_, mx_, my_, start_;
    double k_;
    bool ahead_ = false;  ///< only rays towards the centre count
    double anchor_x_, anchor_y_;
};

}  // namespace

std::vector<Span> objectSpans(const std::vector<PackedObject>& objects, const Box& box, double reach) {
    std::vector<Span> spans(std::size_t(box.height()));
    for (const PackedObject& object : objects) {
        Cone cone(object.data, reach);
        for (int row = 0; row < box.height(); ++row) cone.widen(spans[std::size_t(row)], box, row);
    }
    return spans;
}

std::vector<Span> shownSpans(const SceneTraits& traits, const std::vector<PackedObject>& objects, const Box& crop) {
    const SceneTraits::Paths& paths = traits.paths;
    if (!paths.hide_distance && (paths.light_kinds & (1u << LIGHT_INFINITE | 1u << LIGHT_IMAGE)))
        return std::vector<Span>(std::size_t(crop.height()), Span{0, crop.width()});
    return objectSpans(objects, crop, std::max({0.5, double(paths.radius_x), double(paths.radius_y)}));
}

}  // namespace dsphere
