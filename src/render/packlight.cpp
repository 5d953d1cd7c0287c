#include "render/packlight.h"

#include "base/overloads.h"
#include "render/packimage.h"
#include "render/tovec4.h"
#include "render/traits.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

using layout::LightData;
using layout::vec4;

double brightness(const dvec3& rgb) {
    return (rgb.r + rgb.g + rgb.b) / 3.0;
}

/// What lights are drawn by: their light on a surface at the first object's centre that faces them, roughly.
double nearIrradiance(const Light& light, const LightData& data, const PathTables& tables) {
    const double distance2 = std::max(glm::dot(dvec3(data.position), dvec3(data.position)), 1e-300);
    const double radiance = brightness(dvec3(data.radiance));
    switch (data.kind) {
        case LIGHT_POINT:
            return radiance / distance2;
        case LIGHT_SPHERE:
            return radiance * kPi * data.measure * data.measure / distance2;
        case LIGHT_DISK:
            return radiance * data.measure / distance2;
        case LIGHT_INFINITE:
            return radiance * kPi;
        case LIGHT_IMAGE:
            return radiance * kPi * tables.light_luminance;
        default:
            return brightness(std::get<DistantLight>(light).radiance);
    }
}

// Half of it equal, so that none is forgotten where it happens to be the only one.
void shareOut(std::vector<LightData>& lights, const std::vector<double>& irradiances) {
    double sum = 0.0, below = 0.0;
    for (double irradiance : irradiances) sum += irradiance;
    const double equal = 1.0 / double(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double share = sum > 0.0 ? 0.5 * equal + 0.5 * irradiances[i] / sum : equal;
        below += share;
        lights[i].share = float(share);
        lights[i].shares = float(below);
    }
}

void packAreaLight(LightData& data, const AreaLight& light, const Scene& scene, const dvec3& first_centre) {
    const Shape& shape = scene.shapes[std::size_t(light.shape)];
    data.object = light.shape;
    data.radiance = toVec4(light.radiance, 0.0);
    data.two_sided = light.two_sided ? 1 : 0;
    const dmat4& world = shape.world_from_object;
    const double scale = glm::length(dvec3(world[0]));  // the transform keeps angles
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
        data.position = toVec4(transformPoint(world, dvec3(0.0)) - first_centre, 1.0);
        data.measure = float(sphere->radius * scale);
        return;
    }
    const Disk& disk = std::get<Disk>(shape.geometry);
    const double inner = disk.inner_radius / disk.radius, radius = disk.radius * scale;
    data.position = toVec4(transformPoint(world, dvec3(0.0, 0.0, disk.height)) - first_centre, 1.0);
    data.x_axis = toVec4(disk.radius * dvec3(world[0]), 0.0);
    data.y_axis = toVec4(disk.radius * dvec3(world[1]), 0.0);
    data.z_axis = toVec4(transformNormal(glm::inverse(world), dvec3(0.0, 0.0, 1.0)), 0.0);
    data.inner_squared = float(inner * inner);
    data.measure = float(kPi * radius * radius * (1.0 - inner * inner));
}

void packInfiniteLight(LightData& data, const InfiniteLight& light, const SceneMaps& maps, const PathTables& tables) {
    data.radiance = toVec4(light.radiance, 0.0);
    const dmat3 world_from_light = light.world_from_light;
    data.x_axis = toVec4(world_from_light[0], 0.0);
    data.y_axis = toVec4(world_from_light[1], 0.0);
    data.z_axis = toVec4(world_from_light[2], 0.0);
    if (data.kind != LIGHT_IMAGE) return;
    const ColourMap& image = *maps.images[std::size_t(maps.light_image)];
    data.width = image.width();
    data.height = image.height();
    data.image = imageKind(image);
    data.table = tables.light_image;
}

}  // namespace

std::vector<LightData> packLights(const Scene& scene, const SceneMaps& maps, const PathTables& tables,
                                  const dvec3& first_centre) {
    std::vector<LightData> lights;
    std::vector<double> irradiances;
    for (const Light& light : scene.lights) {
        LightData data = {};
        data.kind = lightKind(scene, light);
        data.object = -1;
        const auto pack =
            Overloads{[&](const DistantLight& distant) {
                          data.position = toVec4(distant.direction, 0.0);
                          data.radiance = toVec4(distant.radiance, 0.0);
                      },
                      [&](const PointLight& point) {
                          data.position = toVec4(point.position - first_centre, 1.0);
                          data.radiance = toVec4(point.intensity, 0.0);
                      },
                      [&](const InfiniteLight& infinite) { packInfiniteLight(data, infinite, maps, tables); },
                      [&](const AreaLight& area) { packAreaLight(data, area, scene, first_centre); }};
        std::visit(pack, light);
        irradiances.push_back(nearIrradiance(light, data, tables));
        lights.push_back(data);
    }
    if (!lights.empty()) shareOut(lights, irradiances);
    return lights;
}

}  // namespace dsphere
