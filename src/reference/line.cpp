#include "reference/line.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

namespace {

using lvec3 = glm::vec<3, long double>;

bool finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

double Line::tBelow(long double s) const {
    const double t = tAt(s), low = -std::numeric_limits<double>::infinity();
    return std::nextafter(std::nextafter(t, low), low);
}

double Line::tAbove(long double s) const {
    const double t = tAt(s), high = std::numeric_limits<double>::infinity();
    return std::nextafter(std::nextafter(t, high), high);
}

bool makeLine(const Ray& ray, Line& line) {
    if (!finite(ray.origin) || !finite(ray.direction) || !std::isfinite(ray.t_min)) return false;
    if (!(ray.t_max >= ray.t_min)) return false;
    const lvec3 o(ray.origin), direction(ray.direction);
    line.length = std::sqrt(glm::dot(direction, direction));
    if (!(line.length > 0.0L)) return false;
    // The moment of the given direction, whose products round once; the unit direction would add its own rounding.
    const lvec3 moment = glm::cross(o, direction) / line.length;
    const lvec3 d = direction / line.length, c = glm::cross(d, moment);
    line.c = dvec3(c);
    line.d = dvec3(d);
    line.distance = std::sqrt(glm::dot(c, c));
    line.origin_s = glm::dot(o, d);
    line.s_begin = double(line.origin_s + line.length * ray.t_min);
    // x87 takes many times as long over an infinity.
    line.s_end = std::isinf(ray.t_max) ? ray.t_max : double(line.origin_s + line.length * ray.t_max);
    return true;
}

}  // namespace dsphere::reference
