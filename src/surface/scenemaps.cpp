#include "surface/scenemaps.h"

#include <cmath>

#include "base/error.h"

namespace dsphere {

namespace {

/// NaN, which differs from itself, is one and the same here.
bool sameValue(const std::optional<double>& a, const std::optional<double>& b) {
    return a == b || (a && b && std::isnan(*a) && std::isnan(*b));
}

bool sameMap(const DisplacedSphere& a, const DisplacedSphere& b) {
    return a.map_path == b.map_path && a.registration == b.registration && a.longitude_origin == b.longitude_origin &&
           a.blur == b.blur && sameValue(a.nodata, b.nodata);
}

std::unique_ptr<Heightmap> load(const DisplacedSphere& sphere, const SourceLocation& where) {
    try {
        return std::make_unique<Heightmap>(loadHeightmap(sphere));
    } catch (const Error& error) {
        throw Error(error.code(), where.text() + ": " + error.what());
    }
}

}  // namespace

std::vector<const Heightmap*> SceneMaps::perShape() const {
    std::vector<const Heightmap*> pointers;
    for (int index : map_of_shape) pointers.push_back(index < 0 ? nullptr : maps[std::size_t(index)].get());
    return pointers;
}

SceneMaps loadSceneMaps(const Scene& scene) {
    SceneMaps result;
    std::vector<const DisplacedSphere*> owners;
    for (const Shape& shape : scene.shapes) {
        const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) {
            result.map_of_shape.push_back(-1);
            result.reliefs.push_back({});
            continue;
        }
        std::size_t index = 0;
        while (index < owners.size() && !sameMap(*owners[index], *sphere)) ++index;
        if (index == owners.size()) {
            result.maps.push_back(load(*sphere, shape.where));
            owners.push_back(sphere);
        }
        result.map_of_shape.push_back(int(index));
        result.reliefs.push_back(makeRelief(*sphere, *result.maps[index], shape.where));
    }
    return result;
}

}  // namespace dsphere
