#include "reference/analytic.h"

#include "reference/line.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

namespace {

FirstHit startHit(const Ray& ray, const Line& line) {
    return {.verdict = Verdict::Hit,
            .hit = true,
            .inside = true,
            .t_low = ray.t_min,
            .t_high = ray.t_min,
            .t_root = ray.t_min,
            .position = line.at(line.s_begin)};
}

}  // namespace

// |p|^2 = |c|^2 + s^2 = radius^2 at s = -+ sqrt((radius - |c|)(radius + |c|)).
FirstHit hitSphere(double radius, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line) || !(line.distance < radius)) return {};
    const long double half = std::sqrt((radius - line.distance) * (radius + line.distance));
    const long double begin = line.origin_s + line.length * ray.t_min, end = line.origin_s + line.length * ray.t_max;
    if (begin >= -half) {
        if (begin > half) return {};
        // A secondary ray on its way out (s > 0) does not come back; on its way in, or ending inside, it hits at once.
        const bool leaves = begin > 0.0L && end > half;
        return !ray.may_start_inside && leaves ? FirstHit{} : startHit(ray, line);
    }
    if (-half > end) return {};
    return {.verdict = Verdict::Hit,
            .hit = true,
            .t_low = std::clamp(line.tBelow(-half), ray.t_min, ray.t_max),
            .t_high = std::clamp(line.tAbove(-half), ray.t_min, ray.t_max),
            .t_root = std::clamp(line.tAt(-half), ray.t_min, ray.t_max),
            .position = line.at(double(-half))};
}

FirstHit hitDisk(const Disk& disk, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line) || ray.direction.z == 0.0) return {};
    const long double t = (static_cast<long double>(disk.height) - ray.origin.z) / ray.direction.z;
    if (!(t >= ray.t_min && t <= ray.t_max) || (!ray.may_start_inside && t == ray.t_min)) return {};
    const long double s = line.origin_s + line.length * t;
    const long double x = line.c.x + s * line.d.x, y = line.c.y + s * line.d.y, r2 = x * x + y * y;
    const long double inner = disk.inner_radius, outer = disk.radius;
    if (r2 > outer * outer || r2 < inner * inner) return {};
    return {.verdict = Verdict::Hit,
            .hit = true,
            .t_low = std::clamp(line.tBelow(s), ray.t_min, ray.t_max),
            .t_high = std::clamp(line.tAbove(s), ray.t_min, ray.t_max),
            .t_root = double(t),
            .position = dvec3(double(x), double(y), disk.height)};
}

}  // namespace dsphere::reference
