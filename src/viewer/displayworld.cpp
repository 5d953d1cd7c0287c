#include "viewer/displayworld.h"

#include <algorithm>
#include <cmath>

namespace dsphere::viewer {

namespace {

layout::vec4 vec4Of(const dvec3& v, double w) {
    return layout::vec4(float(v.x), float(v.y), float(v.z), float(w));
}

const Heightmap* mapOf(const Document& document, std::size_t shape) {
    const int map = document.maps.map_of_shape[shape];
    return map < 0 ? nullptr : document.maps.maps[std::size_t(map)].get();
}

layout::DisplayObject objectOf(const Document& document, std::size_t shape) {
    const Globe& globe = (*document.bodies)[shape];
    layout::DisplayObject object = {};
    object.centre = vec4Of(globe.centre(), 0.0);
    if (!globe.solid()) return object;
    const Relief& relief = document.maps.reliefs[shape];
    const HeightUnit unit = heightUnitOf(document, shape);
    const dmat4 m = glm::inverse(document.scene.shapes[shape].world_from_object);
    const auto row = [&](int i) { return dvec3(m[0][i], m[1][i], m[2][i]); };
    object.centre.w = float(0.5 * (relief.least_radius + relief.greatest_radius));
    object.to_object_x = vec4Of(row(0), relief.base);
    object.to_object_y = vec4Of(row(1), relief.scale != 0.0 ? unit.scale / relief.scale : 0.0);
    object.to_object_z = vec4Of(row(2), unit.offset);
    return object;
}

}  // namespace

HeightUnit heightUnitOf(const Heightmap& map) {
    const double offset = map.facts.heightOf(0.0);
    return {map.facts.heightOf(1.0) - offset, offset, map.facts.unit};
}

HeightUnit heightUnitOf(const Document& document, std::size_t shape) {
    const Heightmap* map = mapOf(document, shape);
    return map ? heightUnitOf(*map) : HeightUnit{};
}

std::pair<double, double> heightRange(const Document& document, std::size_t shape) {
    const Heightmap* map = mapOf(document, shape);
    if (!map) return {0.0, 1.0};
    const HeightUnit unit = heightUnitOf(*map);
    return std::minmax({unit.of(map->storedLeast()), unit.of(map->storedGreatest())});
}

layout::DisplayWorld displayWorld(const Document& document) {
    layout::DisplayWorld world = {};
    const std::size_t objects = std::min(document.scene.shapes.size(), std::size(world.objects));
    for (std::size_t i = 0; i < objects; ++i) world.objects[i] = objectOf(document, i);
    return world;
}

double roundStep(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    const double share = most / power;
    return power * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

}  // namespace dsphere::viewer
