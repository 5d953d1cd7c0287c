#include "tests/reference/oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsphere::reference::test {

// Rows -1 and height are the poles (texel registration), as are rows 0 and height - 1 (gridline).
long double Oracle::node(int i, int j) const {
    const bool texel = map_->registration == Registration::Texel;
    if (j <= (texel ? -1 : 0)) return map_->north_pole;
    if (j >= (texel ? map_->height : map_->height - 1)) return map_->south_pole;
    return map_->at(((i % map_->width) + map_->width) % map_->width, j);
}

// The cubic B-spline by its truncated powers, over every control point that can reach the place.
long double Oracle::spline(long double column, long double row) const {
    const auto bump = [](long double x) {
        const auto cube = [](long double t) { return t > 0 ? t * t * t : 0.0L; };
        return (cube(x + 2) - 4 * cube(x + 1) + 6 * cube(x) - 4 * cube(x - 1) + cube(x - 2)) / 6;
    };
    const int last = map_->height - 1, i0 = int(std::floor(column)), j0 = int(std::floor(row));
    long double sum = 0;
    for (int j = j0 - 2; j <= j0 + 3; ++j)
        for (int i = i0 - 2; i <= i0 + 3; ++i) {
            const int column_of = ((i % map_->width) + map_->width) % map_->width;
            long double control = map_->at(column_of, std::clamp(j, 0, last));
            if (map_->registration == Registration::Gridline && (j < 0 || j > last)) {
                const int mirrored = std::clamp(j < 0 ? -j : 2 * last - j, 0, last);
                control = 2.0L * (j < 0 ? map_->north_pole : map_->south_pole) - map_->at(column_of, mirrored);
            }
            sum += bump(column - i) * bump(row - j) * control;
        }
    return sum;
}

long double Oracle::f(long double x, long double y, long double z) const {
    const long double pi = std::numbers::pi_v<long double>, rho = std::sqrt(x * x + y * y + z * z);
    const long double u = 0.5L + std::atan2(x, z) / (2 * pi) - (map_->longitude_origin + 180.0L) / 360.0L;
    const long double v = std::atan2(std::hypot(x, z), y) / pi;
    return rho - (relief_.base + relief_.scale * stored(u, v));
}

long double Oracle::stored(long double u, long double v) const {
    const long double pi = std::numbers::pi_v<long double>;
    if (map_->ripples)
        return 0.5L +
               0.5L * std::sin(2 * pi * map_->ripples->u_frequency * u) * std::sin(pi * map_->ripples->v_frequency * v);
    const int height = map_->height;
    long double column = u * map_->width, row, share;
    int j;
    if (map_->registration == Registration::Texel) {
        column -= 0.5L;
        row = v * height - 0.5L;
        j = std::clamp(int(std::floor(row)), -1, height - 1);
        share = j == -1 ? v / (0.5L / height) : j == height - 1 ? (row - j) / 0.5L : row - j;
    } else {
        row = v * (height - 1);
        j = std::clamp(int(std::floor(row)), 0, height - 2);
        share = row - j;
    }
    if (relief_.filter == Filter::BSpline) {
        if (map_->registration == Registration::Gridline) return spline(column, row);
        if (j == -1) return map_->north_pole + share * (spline(column, 0) - map_->north_pole);
        if (j == height - 1) return map_->south_pole + (1 - share) * (spline(column, height - 1) - map_->south_pole);
        return spline(column, row);
    }
    const int i = int(std::floor(column));
    const long double a = column - i;
    const long double north = node(i, j) * (1 - a) + node(i + 1, j) * a;
    const long double south = node(i, j + 1) * (1 - a) + node(i + 1, j + 1) * a;
    return north * (1 - share) + south * share;
}

long double Oracle::f(const Ray& ray, long double t) const {
    return f(ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y,
             ray.origin.z + t * ray.direction.z);
}

namespace {

/// Equal distances, and ever closer ones around where the ray is nearest the axis: there the surface may have a needle.
std::vector<long double> sampleTimes(const Ray& ray, long double t0, long double t1, int samples) {
    std::vector<long double> times;
    for (int k = 1; k <= samples; ++k) times.push_back(t0 + (t1 - t0) * k / samples);
    const glm::vec<2, long double> o(ray.origin.x, ray.origin.z), d(ray.direction.x, ray.direction.z);
    const long double speed2 = glm::dot(d, d), nearest = speed2 > 0.0L ? -glm::dot(o, d) / speed2 : t0;
    for (int k = 0; k < 12 * 48; ++k) {
        const long double away = (t1 - t0) * std::exp2(-k / 12.0L);
        for (long double t : {nearest - away, nearest + away})
            if (t > t0 && t < t1) times.push_back(t);
    }
    std::sort(times.begin(), times.end());
    return times;
}

}  // namespace

DenseHit Oracle::search(const Ray& ray, double reach, int samples) const {
    using lvec3 = glm::vec<3, long double>;
    const lvec3 o(ray.origin), d(ray.direction);
    const long double a = glm::dot(d, d), b = glm::dot(o, d),
                      c = glm::dot(o, o) - static_cast<long double>(reach) * reach;
    const long double discriminant = b * b - a * c;
    if (discriminant <= 0.0L) return {};
    const long double t0 = std::max<long double>(ray.t_min, (-b - std::sqrt(discriminant)) / a);
    const long double t1 = std::min<long double>(ray.t_max, (-b + std::sqrt(discriminant)) / a);
    if (!(t0 < t1)) return {};
    DenseHit hit{.sampled = true, .least_f = f(ray, t0)};
    long double before = t0;
    for (long double t : sampleTimes(ray, t0, t1, samples)) {
        const long double value = f(ray, t);
        hit.least_f = std::min(hit.least_f, value);
        if (value > 0.0L) {
            before = t;
            continue;
        }
        long double low = before, high = t;
        for (int n = 0; n < 80; ++n) {
            const long double middle = 0.5L * (low + high);
            (f(ray, middle) > 0.0L ? low : high) = middle;
        }
        hit.hit = true;
        hit.t = 0.5L * (low + high);
        return hit;
    }
    return hit;
}

}  // namespace dsphere::reference::test
