#include "base/limits.h"
#include "scene/directives.h"
#include "scene/shadingnormals.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr std::size_t kMostTriangles = limits::kTrianglesOfMesh;
constexpr std::size_t kMostPoints = 3 * kMostTriangles;
constexpr double kPlanar = 1e-5;  // of a quad's size: written points have six digits
constexpr double kFlat = 1e-9;    // height over longest edge below which a triangle has no area

std::vector<dvec3> pointsOf(Statement s, Parameters& p) {
    const Parameter* parameter = p.take("P", {"point"});
    p.requireSound();
    if (!parameter) failAt(s.word.where, "this Shape lacks \"point3 P\"");
    std::vector<double> numbers = listValue(*parameter, 3, "points", kMostPoints);
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return points;
}

// `corners` for each face; as in pbrt, the points of a single face need no indices.
std::vector<int> indicesOf(Statement s, Parameters& p, std::size_t points, std::size_t corners, const char* faces,
                           std::size_t most) {
    const Parameter* parameter = p.take("indices", {"integer"});
    p.requireSound();
    if (!parameter && points != corners)
        failAt(s.word.where, "this Shape lacks \"integer indices\" of its {} points", points);
    std::vector<int> indices;
    for (std::size_t i = 0; !parameter && i < corners; ++i) indices.push_back(int(i));
    if (!parameter) return indices;
    listValue(*parameter, corners, faces, most);
    for (const Token& value : parameter->values) {
        const int index = integerOf(value);
        if (index < 0 || std::size_t(index) >= points)
            failAt(value.where, "index {} names no point; supported: in [0, {}]", index, points - 1);
        indices.push_back(index);
    }
    return indices;
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
               inQuotes(parameter->name), numbers.size(), points);
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

void requireAreas(Statement s, const TriangleMesh& mesh) {
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const auto& [i0, i1, i2] = mesh.triangles[k];
        auto point = [&](int i) { return mesh.points[std::size_t(i)]; };
        if (!hasArea(point(i0), point(i1), point(i2)))
            failAt(s.word.where, "triangle {} of the mesh, counted from 0, has no area", k);
    }
}

// Normals and tangents at the points, and numbers of faces that only pbrt's Ptex textures read.
void ignoreShading(Parameters& p, const TriangleMesh& mesh, const std::vector<int>& corners) {
    ignoreFlatNormals(p, mesh, corners);
    p.ignore("S", {"vector"});
    p.ignore("faceIndices", {"integer"});
}

struct Quad {
    dvec3 p00, p10, p01, p11;
};

// A bilinear patch with its corners in a plane is the quad between them; a concave one would fold.
void requirePlanar(Statement s, const Quad& quad, std::size_t k) {
    const dvec3 a = quad.p10 - quad.p00, b = quad.p01 - quad.p00, c = quad.p11 - quad.p00;
    const double size = std::max({glm::length(a), glm::length(b), glm::length(c)});
    const dvec3 normal = glm::cross(a / size, b / size);
    const double length = glm::length(normal);
    if (!(length > kFlat) || !(std::abs(glm::dot(normal / length, c / size)) <= kPlanar))
        failAt(s.word.where,
               "patch {} of the mesh, counted from 0, is curved; supported: the four corners in one plane", k);
    const auto turns = [&](const dvec3& from, const dvec3& corner, const dvec3& to) {
        return glm::dot(glm::cross((corner - from) / size, (to - corner) / size), normal) > 0.0;
    };
    if (!turns(quad.p00, quad.p10, quad.p11) || !turns(quad.p10, quad.p11, quad.p01) ||
        !turns(quad.p11, quad.p01, quad.p00) || !turns(quad.p01, quad.p00, quad.p10))
        failAt(s.word.where, "patch {} of the mesh, counted from 0, is not convex", k);
}

bool isParallelogram(const Quad& quad) {
    const dvec3 gap = quad.p00 + quad.p11 - quad.p10 - quad.p01;
    return glm::length(gap) <= kPlanar * glm::length(quad.p11 - quad.p00);
}

}  // namespace

TriangleMesh triangleMesh(Statement s, Parameters& p) {
    TriangleMesh mesh;
    mesh.points = pointsOf(s, p);
    const std::vector<int> indices = indicesOf(s, p, mesh.points.size(), 3, "triangles", kMostTriangles);
    for (std::size_t i = 0; i < indices.size(); i += 3)
        mesh.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    mesh.uvs = uvsOf(p, mesh.points.size());
    requireAreas(s, mesh);
    ignoreShading(p, mesh, indices);
    p.finish();
    return mesh;
}

// pbrt v4's: four corners for each patch, p00 p10 p01 p11, each patch two triangles here.
TriangleMesh bilinearMesh(Statement s, Parameters& p) {
    TriangleMesh mesh;
    mesh.points = pointsOf(s, p);
    const std::vector<int> indices = indicesOf(s, p, mesh.points.size(), 4, "patches", kMostTriangles / 2);
    mesh.uvs = uvsOf(p, mesh.points.size());
    const Material& material = s.state.attributes.material;
    const bool varies = textureAs<ImageMap>(material) || textureAs<Checkerboard>(material);
    TriangleMesh unshared{{}, {}, {}};  // without uv each patch has its own, from (0, 0) to (1, 1)
    std::vector<int> corners;           // of the triangles, as the file counts points
    for (std::size_t i = 0; i < indices.size(); i += 4) {
        const auto corner = [&](std::size_t k) { return mesh.points[std::size_t(indices[i + k])]; };
        const Quad quad{corner(0), corner(1), corner(2), corner(3)};
        requirePlanar(s, quad, i / 4);
        if (varies && !isParallelogram(quad))
            failAt(s.word.where,
                   "patch {} of the mesh, counted from 0, is no parallelogram, so that pbrt bends its texture; "
                   "supported: parallelograms, or a colour that does not vary",
                   i / 4);
        constexpr dvec2 kOwn[] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}};
        const int first = int(unshared.points.size());
        for (std::size_t k = 0; k < 4; ++k) {
            unshared.points.push_back(corner(k));
            unshared.uvs.push_back(mesh.uvs.empty() ? kOwn[k] : mesh.uvs[std::size_t(indices[i + k])]);
        }
        for (const std::array<int, 3>& triangle : {std::array{0, 1, 3}, std::array{0, 3, 2}}) {
            unshared.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
            for (int k : triangle) corners.push_back(indices[i + std::size_t(k)]);
        }
    }
    requireAreas(s, unshared);
    ignoreShading(p, unshared, corners);
    p.finish();
    return unshared;
}

}  // namespace dsphere
