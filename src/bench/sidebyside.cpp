#include "bench/sidebyside.h"

#include "base/error.h"
#include "bench/meshrays.h"
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dsphere::bench {

namespace {

/// What one pixel of either picture is made of.
struct Pixel {
    bool hit = false, lit = false;
    dvec3 normal{0.0};   ///< world
    double shade = 0.0;  ///< cosine with the sun where it is seen
};

dvec3 sunOf(const Workload& workload) {
    return std::get<DistantLight>(workload.scene.lights[0]).direction;
}

std::vector<Pixel> marched(gpu::Device& device, const Workload& workload) {
    Scene scene = workload.scene;
    scene.camera = workload.views[0].camera;
    scene.film = workload.views[0].film;
    const PackedScene packed = packScene(scene, workload.maps);
    Renderer renderer(device, packed, scene, MarchMethod());
    const std::uint32_t mask =
        planeBit(PLANE_NX) | planeBit(PLANE_NY) | planeBit(PLANE_NZ) | planeBit(PLANE_ID) | planeBit(PLANE_LIT);
    const Image image = renderer.renderPlanes(mask, {});
    std::vector<Pixel> pixels(image.pixelCount());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].hit = image.at("id").uints()[i] != 0;
        pixels[i].lit = image.at("lit").uints()[i] != 0;
        pixels[i].normal = {image.at("N.X").floats()[i], image.at("N.Y").floats()[i], image.at("N.Z").floats()[i]};
    }
    return pixels;
}

std::vector<Pixel> meshed(const Workload& workload) {
    const Relief& relief = workload.maps.reliefs[0];
    const EmbreeScene mesh(NodeGrid(*workload.maps.maps[0]), relief.base / relief.greatest_radius,
                           relief.scale / relief.greatest_radius, 1, MeshKind::Triangles);
    const Box box = cropBox(workload.views[0].film);
    std::vector<std::uint32_t> order(std::size_t(box.width()) * std::size_t(box.height()));
    std::iota(order.begin(), order.end(), 0u);
    const RaySet rays = cameraRays(workload, workload.views[0], order);
    std::vector<float> t(rays.size()), shadow_t(rays.size());
    std::vector<glm::vec3> normals(rays.size());
    mesh.intersect(rays, t, normals.data());
    const dmat4 object_from_world = glm::inverse(workload.scene.shapes[0].world_from_object);
    const dvec3 sun = glm::normalize(transformVector(object_from_world, sunOf(workload)));
    std::vector<Pixel> pixels(order.size());
    RaySet shadows;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const dvec3 origin(rays.x[i], rays.y[i], rays.z[i]), direction(rays.dx[i], rays.dy[i], rays.dz[i]);
        const dvec3 p = std::isfinite(t[i]) ? origin + double(t[i]) * direction : dvec3(0.0, 2.0, 0.0);
        dvec3 n = std::isfinite(t[i]) ? glm::normalize(dvec3(normals[i])) : dvec3(0.0, 1.0, 0.0);
        if (glm::dot(n, p) < 0.0) n = -n;
        shadows.add(p + kMeshOffset * n, sun);
        if (i >= pixels.size() || !std::isfinite(t[i])) continue;
        pixels[i].hit = true;
        pixels[i].normal = transformNormal(object_from_world, n);
    }
    mesh.occluded(shadows, shadow_t);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i].lit = pixels[i].hit && shadow_t[i] > 0.0f && glm::dot(pixels[i].normal, sunOf(workload)) > 0.0;
    return pixels;
}

double degreesBetween(const dvec3& a, const dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// Panels of one size, three in a row.
class Panels {
  public:
    Panels(int width, int height) : width_(width), height_(height) {
        image_.data = image_.display = {0, 0, 3 * width, 2 * height};
        for (const char* name : {"R", "G", "B"}) image_.addFloat(name);
    }
    void put(int column, int row, std::size_t pixel, const dvec3& colour) {
        const std::size_t x = pixel % std::size_t(width_) + std::size_t(column * width_);
        const std::size_t y = pixel / std::size_t(width_) + std::size_t(row * height_);
        for (int c = 0; c < 3; ++c)
            image_.channels[std::size_t(c)].floats()[y * std::size_t(3 * width_) + x] = float(colour[c]);
    }
    Image take() { return std::move(image_); }

  private:
    int width_, height_;
    Image image_;
};

}  // namespace

SideBySide drawSideBySide(gpu::Device& device, const Workload& workload) {
    requireNodes(workload);
    std::vector<Pixel> pictures[2] = {marched(device, workload), meshed(workload)};
    for (std::vector<Pixel>& picture : pictures)
        for (Pixel& pixel : picture)
            pixel.shade = pixel.lit ? std::max(0.0, glm::dot(pixel.normal, sunOf(workload))) : 0.0;
    const Box box = cropBox(workload.views[0].film);
    Panels panels(box.width(), box.height());
    SideBySide result;
    std::vector<double> angles;
    for (std::size_t i = 0; i < pictures[0].size(); ++i) {
        const Pixel &a = pictures[0][i], &b = pictures[1][i];
        for (int column : {0, 1}) {
            const Pixel& pixel = pictures[column][i];
            if (pixel.hit) panels.put(column, 0, i, 0.5 + 0.5 * pixel.normal);
            panels.put(column, 1, i, dvec3(pixel.shade));
        }
        result.one_sided += a.hit != b.hit;
        if (!a.hit || !b.hit) continue;
        const double degrees = degreesBetween(a.normal, b.normal), shade = std::abs(a.shade - b.shade);
        panels.put(2, 0, i, dvec3(degrees / kWhiteDegrees));
        panels.put(2, 1, i, dvec3(shade / kWhiteShade));
        angles.push_back(degrees);
        result.mean_shade += shade;
        result.other_shadow += a.lit != b.lit;
    }
    result.picture = panels.take();
    result.hits = angles.size();
    if (angles.empty()) return result;
    result.mean_shade /= double(angles.size());
    std::ranges::nth_element(angles, angles.begin() + std::ptrdiff_t(angles.size() / 2));
    result.median_degrees = angles[angles.size() / 2];
    result.greatest_degrees = *std::ranges::max_element(angles);
    return result;
}

}  // namespace dsphere::bench
