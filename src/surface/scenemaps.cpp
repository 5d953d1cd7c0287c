#include "surface/scenemaps.h"

#include <algorithm>
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
           a.blur == b.blur && a.ripples == b.ripples && a.band == b.band && sameValue(a.nodata, b.nodata);
}

/// What `load` makes, its error prefixed by the place.
template <typename Load>
auto loadAt(const SourceLocation& where, Load load) {
    try {
        return std::make_unique<decltype(load())>(load());
    } catch (const Error& error) {
        if (where.line == 0) throw;  // it names the file itself
        throw Error(error.code(), where.text() + ": " + error.what());
    }
}

/// The index of the image in `images`, which is read when it is not among them.
int imageIndex(SceneMaps& result, const std::string& path, const SourceLocation& where) {
    const auto found = std::ranges::find_if(result.images, [&](const auto& image) { return image->path() == path; });
    const int index = int(found - result.images.begin());
    if (found == result.images.end()) result.images.push_back(loadAt(where, [&] { return loadColourMap(path); }));
    return index;
}

void loadImages(SceneMaps& result, const Scene& scene) {
    for (const Shape& shape : scene.shapes) {
        const auto* texture = textureAs<ImageMap>(shape.material);
        result.image_of_shape.push_back(texture ? imageIndex(result, texture->path, texture->where) : -1);
    }
}

// pbrt v4's own images of light are square ones in the equal-area octahedral mapping: read as longitude and latitude
// they would be garbled, silently.
void loadLightImage(SceneMaps& result, const Scene& scene) {
    for (const Light& light : scene.lights) {
        const auto* infinite = std::get_if<InfiniteLight>(&light);
        if (!infinite || infinite->map_path.empty()) continue;
        result.light_image = imageIndex(result, infinite->map_path, infinite->where);
        const ColourMap& image = *result.images[std::size_t(result.light_image)];
        if (image.width() == image.height())
            throwInvalid(
                "{}: {}: the image is square ({}x{}), as pbrt v4's equal-area maps are; supported: equirectangular "
                "ones, longitude by latitude",
                infinite->where.text(), image.path(), image.width(), image.height());
        const auto& values = image.raw().linear;
        const auto negative = std::ranges::find_if(values, [](float value) { return value < 0.0f; });
        if (negative != values.end())
            throwInvalid("{}: {}: the light at column {}, row {} is {}; supported: at least 0", infinite->where.text(),
                         image.path(), (negative - values.begin()) / 3 % image.width(),
                         (negative - values.begin()) / 3 / image.width(), *negative);
    }
}

}  // namespace

Notices SceneMaps::notices() const {
    Notices all;
    for (const auto& map : maps) all.insert(all.end(), map->notices.begin(), map->notices.end());
    return all;
}

std::vector<const Heightmap*> SceneMaps::perShape() const {
    std::vector<const Heightmap*> pointers;
    for (int index : map_of_shape) pointers.push_back(index < 0 ? nullptr : maps[std::size_t(index)].get());
    return pointers;
}

const ColourMap* SceneMaps::image(std::size_t shape) const {
    if (shape >= image_of_shape.size() || image_of_shape[shape] < 0) return nullptr;
    return images[std::size_t(image_of_shape[shape])].get();
}

std::vector<const ColourMap*> SceneMaps::imagePerShape() const {
    std::vector<const ColourMap*> pointers;
    for (std::size_t shape = 0; shape < map_of_shape.size(); ++shape) pointers.push_back(image(shape));
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
            result.maps.push_back(loadAt(shape.where, [&] { return loadHeightmap(*sphere); }));
            owners.push_back(sphere);
        }
        result.map_of_shape.push_back(int(index));
        if (const auto scale = trueScaleOf(*sphere, *result.maps[index]))
            result.maps[index]->notices.push_back(exaggerationNote(*scale, *result.maps[index]));
        result.reliefs.push_back(makeRelief(*sphere, *result.maps[index], shape.where));
    }
    loadImages(result, scene);
    loadLightImage(result, scene);
    return result;
}

}  // namespace dsphere
