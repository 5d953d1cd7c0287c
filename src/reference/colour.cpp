#include "reference/colour.h"

#include "base/overloads.h"
#include "reference/mesh.h"

#include <cmath>

namespace dsphere::reference {
namespace {

int wrapped(double index, int count) {
    const double turns = std::floor(index / count);
    return std::min(int(index - turns * count), count - 1);
}

/// Bilinear within row j, at the column coordinate x whose whole numbers are texel centres.
dvec3 alongRow(const ColourMap& image, double x, int j) {
    const double west = std::floor(x);
    const dvec3 a = image.texel(wrapped(west, image.width()), j),
                b = image.texel(wrapped(west + 1.0, image.width()), j);
    return glm::mix(a, b, x - west);
}

dvec3 onPlanet(const ColourMap& image, double u, double v) {
    const double x = u * image.width() - 0.5, y = v * image.height() - 0.5;
    const int last = image.height() - 1;
    if (y < 0.0) return glm::mix(image.north(), alongRow(image, x, 0), 2.0 * v * image.height());
    if (y > last) return glm::mix(image.south(), alongRow(image, x, last), 2.0 * (1.0 - v) * image.height());
    const int north = std::min(int(y), std::max(last - 1, 0));
    return glm::mix(alongRow(image, x, north), alongRow(image, x, std::min(north + 1, last)), y - north);
}

dvec3 repeated(const ColourMap& image, double u, double v) {
    const double x = u * image.width() - 0.5, y = v * image.height() - 0.5;
    const double north = std::floor(y);
    return glm::mix(alongRow(image, x, wrapped(north, image.height())),
                    alongRow(image, x, wrapped(north + 1.0, image.height())), y - north);
}

/// [0, 1): counterclockwise about +z, from +x.
double turnAboutZ(const dvec3& p) {
    const double turn = std::atan2(p.y, p.x) / (2.0 * kPi);
    return turn < 0.0 ? turn + 1.0 : turn;
}

}  // namespace

dvec2 surfaceUv(const Shape& shape, const dvec3& p) {
    const auto onDisplaced = [&](const DisplacedSphere&) {
        return dvec2(0.5 + std::atan2(p.x, p.z) / (2.0 * kPi), std::atan2(std::hypot(p.x, p.z), p.y) / kPi);
    };
    const auto onSphere = [&](const Sphere&) {
        return dvec2(turnAboutZ(p), 1.0 - std::atan2(std::hypot(p.x, p.y), p.z) / kPi);
    };
    const auto onDisk = [&](const Disk& disk) {
        return dvec2(turnAboutZ(p), (disk.radius - std::hypot(p.x, p.y)) / (disk.radius - disk.inner_radius));
    };
    const auto onMesh = [&](const TriangleMesh& mesh) { return meshUv(mesh, nearestOnMesh(mesh, p)); };
    return std::visit(Overloads{onDisplaced, onSphere, onDisk, onMesh}, shape.geometry);
}

dvec3 imageColour(const Shape& shape, const ImageMap& texture, const ColourMap& image, const dvec3& p) {
    const dvec2 uv = surfaceUv(shape, p);
    dvec3 colour(0.0);
    if (std::holds_alternative<DisplacedSphere>(shape.geometry))
        colour = onPlanet(image, uv.x - (texture.longitude_origin + 180.0) / 360.0, uv.y);
    else
        colour = repeated(image, uv.x, 1.0 - uv.y);  // pbrt's images stand on their last row
    return glm::clamp(texture.scale * colour, 0.0, 1.0);
}

dvec3 checkerboardColour(const Checkerboard& texture, const dvec2& uv) {
    const double squares = std::floor(texture.u_scale * uv.x) + std::floor(texture.v_scale * uv.y);
    return std::fmod(squares, 2.0) == 0.0 ? texture.even : texture.odd;
}

}  // namespace dsphere::reference
