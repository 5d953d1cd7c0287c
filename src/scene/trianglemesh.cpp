#include "scene/directives.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr std::size_t kMostTriangles = 64;
constexpr std::size_t kMostPoints = 3 * kMostTriangles;
constexpr double kFlat = 1e-9;  // height over longest edge below which a triangle has no area

std::vector<dvec3> pointsOf(Statement s, Parameters& p) {
    const Parameter* parameter = p.take("P", {"point"});
    if (!parameter) failAt(s.word.where, "Shape \"trianglemesh\" lacks \"point3 P\"");
    std::vector<double> numbers = listValue(*parameter, 3, "points", kMostPoints);
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return points;
}

// As in pbrt, three points need no indices.
std::vector<std::array<int, 3>> trianglesOf(Statement s, Parameters& p, std::size_t points) {
    const Parameter* parameter = p.take("indices", {"integer"});
    if (!parameter && points == 3) return {{0, 1, 2}};
    if (!parameter) failAt(s.word.where, "Shape \"trianglemesh\" lacks \"integer indices\" of its {} points", points);
    listValue(*parameter, 3, "triangles", kMostTriangles);
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t i = 0; i < parameter->values.size(); ++i) {
        const int index = integerOf(parameter->values[i]);
        if (index < 0 || std::size_t(index) >= points)
            failAt(parameter->values[i].where, "index {} names no point; supported: in [0, {}]", index, points - 1);
        if (i % 3 == 0) triangles.emplace_back();
        triangles.back()[i % 3] = index;
    }
    return triangles;
}

// v3 says uv or st, as floats; v4 uv, as point2.
std::vector<dvec2> uvsOf(Parameters& p, std::size_t points) {
    const Parameter *uv = p.take("uv", {"point2", "float"}), *st = p.take("st", {"point2", "float"});
    if (uv && st) failAt(st->where, "uv and st mean the same: give one");
    const Parameter* parameter = uv ? uv : st;
    if (!parameter) return {};
    std::vector<double> numbers = listValue(*parameter, 2, "points", kMostPoints);
    if (numbers.size() != 2 * points)
        failAt(parameter->where, "parameter {} has {} numbers; supported: 2 for each of the {} points",
               dsphere::quoted(parameter->name), numbers.size(), points);
    std::vector<dvec2> uvs;
    for (std::size_t i = 0; i < numbers.size(); i += 2) uvs.emplace_back(numbers[i], numbers[i + 1]);
    return uvs;
}

bool hasArea(dvec3 a, dvec3 b, dvec3 c) {
    auto greatest = [](const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    b -= a, c -= a;
    const double size = std::max(greatest(b), greatest(c));
    return size > 0.0 && std::isfinite(size) && glm::length(glm::cross(b / size, c / size)) > kFlat;
}

}  // namespace

TriangleMesh triangleMesh(Statement s, Parameters& p) {
    TriangleMesh mesh;
    mesh.points = pointsOf(s, p);
    mesh.triangles = trianglesOf(s, p, mesh.points.size());
    mesh.uvs = uvsOf(p, mesh.points.size());
    p.finish();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const auto& [i0, i1, i2] = mesh.triangles[k];
        auto point = [&](int i) { return mesh.points[std::size_t(i)]; };
        if (!hasArea(point(i0), point(i1), point(i2)))
            failAt(s.word.where, "triangle {} of the mesh, counted from 0, has no area", k);
    }
    return mesh;
}

}  // namespace dsphere
