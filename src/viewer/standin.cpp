#include "viewer/standin.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "viewer/camera.h"

namespace dsphere::viewer {

namespace {

constexpr double kHiddenRadius = 1e-4;  // of a sphere that nobody sees, in the shape's own units

Texture plainTexture(const Material& material) {
    Texture texture = matteTextureOf(material);
    if (const auto* squares = std::get_if<Checkerboard>(&texture))
        return ConstantColour{0.5 * (squares->even + squares->odd)};
    return texture;
}

// Beside where the shape was, so that a lamp does not stand in its own point's light.
void hide(Shape& shape, const dvec3& middle, double reach) {
    shape.geometry = Sphere{kHiddenRadius * reach};
    dmat4& m = shape.world_from_object;
    m[3] = m * dvec4(middle + dvec3(0.0, 0.0, 2.0 * reach), 1.0);
}

/// The disk of a flat mesh's area about its middle, if it is flat.
bool makeDisk(Shape& shape, const TriangleMesh& mesh) {
    dvec3 normal(0.0);
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const dvec3 cross = glm::cross(mesh.points[std::size_t(b)] - mesh.points[std::size_t(a)],
                                       mesh.points[std::size_t(c)] - mesh.points[std::size_t(a)]);
        normal += glm::dot(cross, normal) < 0.0 ? -cross : cross;
        area += 0.5 * glm::length(cross);
    }
    const double length = glm::length(normal);
    const dvec3 middle = middleOf(mesh);
    const double reach = std::sqrt(area / kPi);
    if (!(length > 0.0)) return false;
    normal /= length;
    for (const dvec3& point : mesh.points)
        if (std::abs(glm::dot(point - middle, normal)) > 1e-3 * reach) return false;
    const dvec3 across = glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const dmat4 placed(dvec4(across, 0.0), dvec4(glm::cross(normal, across), 0.0), dvec4(normal, 0.0),
                       dvec4(middle, 1.0));
    shape.geometry = Disk{0.0, reach, 0.0};
    shape.world_from_object = shape.world_from_object * placed;
    return true;
}

double meshReach(const TriangleMesh& mesh) {
    double reach = 0.0;
    for (const dvec3& point : mesh.points) reach = std::max(reach, glm::length(point - middleOf(mesh)));
    return reach;
}

double scaleOf(const dmat4& m) {
    return std::cbrt(std::abs(glm::determinant(dmat3(m))));
}

/// As bright as the lamp is from far away, where it faces.
PointLight pointOf(const Scene& scene, const AreaLight& light) {
    const Shape& shape = scene.shapes[std::size_t(light.shape)];
    const double scale = scaleOf(shape.world_from_object);
    double square = 1.0, height = 0.0;
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) square = sphere->radius * sphere->radius;
    if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
        square = disk->radius * disk->radius - disk->inner_radius * disk->inner_radius;
        height = disk->height;
    }
    return {transformPoint(shape.world_from_object, dvec3(0.0, 0.0, height)),
            kPi * square * scale * scale * light.radiance};
}

}  // namespace

Scene standIn(const Scene& scene) {
    Scene plain = scene;
    plain.integrator = {};
    plain.pixel_filter = {};
    plain.lights.clear();
    for (Shape& shape : plain.shapes) {
        shape.material = Matte{.reflectance = plainTexture(shape.material)};
        if (const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry)) {
            const TriangleMesh whole = *mesh;
            if (!makeDisk(shape, whole)) hide(shape, middleOf(whole), meshReach(whole));
        }
    }
    for (const Light& light : scene.lights) {
        if (const auto* area = std::get_if<AreaLight>(&light)) {
            Shape& lamp = plain.shapes[std::size_t(area->shape)];
            const auto* sphere = std::get_if<Sphere>(&lamp.geometry);
            plain.lights.emplace_back(pointOf(scene, *area));
            hide(lamp, dvec3(0.0), sphere ? sphere->radius : std::get<Disk>(lamp.geometry).radius);
        } else if (const auto* sky = std::get_if<InfiniteLight>(&light)) {
            // Half of the sky is seen from a facet at the least.
            const dvec3 towards = -glm::normalize(Pose::of(scene.camera).ahead);
            plain.lights.emplace_back(DistantLight{towards, 0.5 * kPi * sky->radiance});
        } else {
            plain.lights.push_back(light);
        }
    }
    return plain;
}

}  // namespace dsphere::viewer
