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

/// The cone of rays that pass an object's centre within k, as the camera's linear rays see it.
struct Cone {
    dvec3 d0, dx, dy, m0, mx, my;
    double k;
    double anchor_x, anchor_y;

    Cone(const layout::ObjectData& object, double reach)
        : d0(sum(object.direction_0, object.direction_0_lo)),
          dx(sum(object.direction_x, object.direction_x_lo)),
          dy(sum(object.direction_y, object.direction_y_lo)),
          anchor_x(object.anchor_x),
          anchor_y(object.anchor_y) {
        double steps = object.direction_0.w;
        dvec3 start = sum(object.point_0, object.point_0_lo) - steps * d0;
        dvec3 start_x = sum(object.point_x, object.point_x_lo) - steps * dx;
        dvec3 start_y = sum(object.point_y, object.point_y_lo) - steps * dy;
        // Linear too, since either the start or the direction is constant.
        m0 = glm::cross(start, d0);
        mx = glm::cross(start_x, d0) + glm::cross(start, dx);
        my = glm::cross(start_y, d0) + glm::cross(start, dy);
        double shell = std::sqrt(double(object.shell_squared)) * (1.0 + 1e-5);
        // A ray `reach` pixels beside a sampled one: |m'| is at most this larger, |d'| this smaller, relative to |d'|,
        // which is never below the image plane's distance.
        dvec3 across = glm::cross(dx, dy);
        double flat = glm::length(across);
        double plane = flat > 0.0 ? std::abs(glm::dot(d0, across)) / flat : glm::length(d0);
        double drift = glm::length(mx) + glm::length(my) + shell * (glm::length(dx) + glm::length(dy));
        k = shell + 2.0 * reach * drift / std::max(plane, 1e-30);
    }

    RowQuadratic row(double y) const {
        dvec3 d = d0 + y * dy, m = m0 + y * my;
        double kk = k * k;
        return {glm::dot(mx, mx) - kk * glm::dot(dx, dx), glm::dot(m, mx) - kk * glm::dot(d, dx),
                glm::dot(m, m) - kk * glm::dot(d, d)};
    }
};

void widen(Span& span, const Cone& cone, const Box& box, int row) {
    RowQuadratic q = cone.row(box.y0 + row - cone.anchor_y);
    double first = box.x0, last = box.x1;
    // Written so that a NaN keeps the whole row; a <= 0: the camera is inside the shell, or the cone reaches infinity.
    if (q.a > 0.0) {
        double discriminant = q.b * q.b - q.a * q.c;
        if (discriminant < 0.0) return;
        double root = std::sqrt(discriminant);
        first = std::max(first, cone.anchor_x + std::floor((-q.b - root) / q.a) - 1.0);
        last = std::min(last, cone.anchor_x + std::ceil((-q.b + root) / q.a) + 2.0);
        if (!(first < last)) return;
    }
    int x0 = int(first) - box.x0, x1 = int(last) - box.x0;
    span = span.empty() ? Span{x0, x1} : Span{std::min(span.x0, x0), std::max(span.x1, x1)};
}

}  // namespace

std::vector<Span> objectSpans(const std::vector<layout::ObjectData>& objects, const Box& box, double reach) {
    std::vector<Span> spans(std::size_t(box.height()));
    for (const layout::ObjectData& object : objects) {
        Cone cone(object, reach);
        for (int row = 0; row < box.height(); ++row) widen(spans[std::size_t(row)], cone, box, row);
    }
    return spans;
}

}  // namespace dsphere
