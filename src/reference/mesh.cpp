#include "reference/mesh.h"

#include "reference/line.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {
namespace {

using Wide = glm::tvec3<long double>;

struct Corners {
    dvec3 a, b, c;
};

Corners cornersOf(const TriangleMesh& mesh, int triangle) {
    const auto& corner = mesh.triangles[std::size_t(triangle)];
    auto point = [&](int k) { return mesh.points[std::size_t(corner[std::size_t(k)])]; };
    return {point(0), point(1), point(2)};
}

// t of a ray's crossing, NaN if it passes by. The line's side of an edge is the sign of d . (a x b); swapped ends
// negate it to the last bit, so that no ray slips between two triangles.
long double crossing(const Ray& ray, const Line& line, const Corners& corners) {
    const Wide d(line.d), centre(line.c), a = Wide(corners.a), b = Wide(corners.b), c = Wide(corners.c);
    auto side = [&](const Wide& from, const Wide& to) { return glm::dot(d, glm::cross(from - centre, to - centre)); };
    const long double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    const bool positive = ab >= 0.0L && bc >= 0.0L && ca >= 0.0L, negative = ab <= 0.0L && bc <= 0.0L && ca <= 0.0L;
    const Wide normal = glm::cross(b - a, c - a);
    const long double speed = glm::dot(normal, Wide(ray.direction));
    if (!(positive || negative) || speed == 0.0L) return std::numeric_limits<long double>::quiet_NaN();
    return glm::dot(normal, a - Wide(ray.origin)) / speed;
}

/// The point of the segment nearest to p, as its share of the way.
double alongSegment(const dvec3& from, const dvec3& to, const dvec3& p) {
    const dvec3 way = to - from;
    const double length2 = glm::dot(way, way);
    return length2 > 0.0 ? std::clamp(glm::dot(p - from, way) / length2, 0.0, 1.0) : 0.0;
}

/// Of the point of the triangle nearest to p.
dvec3 nearestBarycentric(const Corners& t, const dvec3& p) {
    const dvec3 n = glm::cross(t.b - t.a, t.c - t.a);
    const double area2 = glm::dot(n, n);
    if (area2 > 0.0) {
        const double b = glm::dot(glm::cross(p - t.a, t.c - t.a), n) / area2,
                     c = glm::dot(glm::cross(t.b - t.a, p - t.a), n) / area2;
        if (b >= 0.0 && c >= 0.0 && b + c <= 1.0) return {1.0 - b - c, b, c};
    }
    const double ab = alongSegment(t.a, t.b, p), bc = alongSegment(t.b, t.c, p), ca = alongSegment(t.c, t.a, p);
    dvec3 nearest(1.0, 0.0, 0.0);
    double least = std::numeric_limits<double>::infinity();
    for (const dvec3& at : {dvec3(1.0 - ab, ab, 0.0), dvec3(0.0, 1.0 - bc, bc), dvec3(ca, 0.0, 1.0 - ca)}) {
        const double distance = glm::distance(p, at.x * t.a + at.y * t.b + at.z * t.c);
        if (distance < least) nearest = at;
        least = std::min(least, distance);
    }
    return nearest;
}

}  // namespace

FirstHit hitMesh(const TriangleMesh& mesh, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line)) return {};
    long double nearest = std::numeric_limits<long double>::infinity();
    for (int k = 0; k < int(mesh.triangles.size()); ++k) {
        const long double t = crossing(ray, line, cornersOf(mesh, k));
        const bool begins = ray.may_start_inside ? t >= ray.t_min : t > ray.t_min;
        if (begins && t <= ray.t_max) nearest = std::min(nearest, t);
    }
    if (std::isinf(nearest)) return {};
    const long double s = line.origin_s + line.length * nearest;
    return {.verdict = Verdict::Hit,
            .hit = true,
            .t_low = std::clamp(line.tBelow(s), ray.t_min, ray.t_max),
            .t_high = std::clamp(line.tAbove(s), ray.t_min, ray.t_max),
            .t_root = double(nearest),
            .position = line.at(double(s))};
}

MeshPoint nearestOnMesh(const TriangleMesh& mesh, const dvec3& p) {
    MeshPoint nearest{.distance = std::numeric_limits<double>::infinity()};
    for (int k = 0; k < int(mesh.triangles.size()); ++k) {
        const Corners t = cornersOf(mesh, k);
        const dvec3 at = nearestBarycentric(t, p);
        const double distance = glm::distance(p, at.x * t.a + at.y * t.b + at.z * t.c);
        if (distance < nearest.distance) nearest = {k, distance, at};
    }
    return nearest;
}

dvec3 meshNormal(const TriangleMesh& mesh, int triangle) {
    const Corners t = cornersOf(mesh, triangle);
    const dvec3 n = glm::cross(t.b - t.a, t.c - t.a);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : dvec3(0.0, 0.0, 1.0);
}

dvec2 meshUv(const TriangleMesh& mesh, const MeshPoint& point) {
    const auto& corner = mesh.triangles[std::size_t(point.triangle)];
    const dvec3& weight = point.barycentric;
    if (mesh.uvs.empty()) return {weight.y + weight.z, weight.z};  // (0, 0), (1, 0), (1, 1)
    dvec2 uv(0.0);
    for (int k = 0; k < 3; ++k) uv += weight[k] * mesh.uvs[std::size_t(corner[std::size_t(k)])];
    return uv;
}

}  // namespace dsphere::reference
