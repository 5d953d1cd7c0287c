#include "surface/scenemaps.h"

#include "base/errorlist.h"

#include <algorithm>
#include <cmath>
#include <set>

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

/// What `load` makes of the file at `path`. Its error goes on with what the scene says of a missing file, prefixed by
/// the place.
template <typename Load>
auto loadAt(const Scene& scene, const SourceLocation& where, const std::string& path, Load load) {
    try {
        return std::make_unique<decltype(load())>(load());
    } catch (const Error& error) {
        if (error.code() == ExitCode::Interrupted) throw;
        const auto missing = scene.missing.find(path);
        const std::string more = missing == scene.missing.end() ? "" : missing->second;
        // Without a line the place is the file, which the error names itself.
        throw Error(error.code(), (where.line == 0 ? "" : where.text() + ": ") + error.what() + more);
    }
}

/// Runs `load`; an error of the input goes into the list.
template <typename Load>
void gather(ErrorList& errors, Load load) {
    try {
        load();
    } catch (const Error& error) {
        if (error.code() != ExitCode::InvalidInput) throw;
        errors.add(error.what());
    }
}

/// Texels of a map that does not stay in its file.
std::uint64_t mostHeld(std::uint64_t memory_limit) {
    constexpr std::uint64_t kBytesHeld = 2 * sizeof(float);  // of a texel, on the host and on the device
    return memory_limit > 0 ? std::min(geo::kLargeMapTexels, memory_limit / kBytesHeld) : geo::kLargeMapTexels;
}

/// Loads a scene's files, all of them: what is wrong with any is gathered.
class Loader {
  public:
    Loader(const Scene& scene, std::uint64_t memory_limit, const MapProgress& progress, bool coarse = false)
        : scene_(scene), progress_(progress), coarse_(coarse), most_held_(mostHeld(memory_limit)) {
        result_.memory_limit = memory_limit;
    }

    SceneMaps load() {
        for (const Shape& shape : scene_.shapes) {
            result_.map_of_shape.push_back(-1);
            result_.reliefs.push_back({});
            gather(errors_, [&] { loadMap(shape); });
        }
        for (const Shape& shape : scene_.shapes) {
            const auto* texture = textureAs<ImageMap>(shape.material);
            result_.image_of_shape.push_back(-1);
            gather(errors_, [&] {
                if (texture) result_.image_of_shape.back() = imageIndex(texture->path, texture->where);
            });
        }
        for (const Light& light : scene_.lights)
            if (const auto* infinite = std::get_if<InfiniteLight>(&light))
                gather(errors_, [&] { loadLightImage(*infinite); });
        errors_.throwIfAny();
        return std::move(result_);
    }

  private:
    Heightmap loadOne(const DisplacedSphere& sphere) {
        if (coarse_)
            if (std::optional<Heightmap> map = loadCoarseHeightmap(sphere)) {
                result_.coarse = true;
                return std::move(*map);
            }
        return loadHeightmap(sphere, most_held_, progress_);
    }

    void loadMap(const Shape& shape) {
        const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) return;
        const auto same = [&](const DisplacedSphere* owner) { return sameMap(*owner, *sphere); };
        if (std::ranges::any_of(bad_maps_, same)) return;
        const auto found = std::ranges::find_if(owners_, same);
        const std::size_t index = std::size_t(found - owners_.begin());
        if (found == owners_.end()) {
            bad_maps_.push_back(sphere);
            result_.maps.push_back(loadAt(scene_, shape.where, sphere->map_path, [&] { return loadOne(*sphere); }));
            bad_maps_.pop_back();
            owners_.push_back(sphere);
        }
        result_.map_of_shape.back() = int(index);
        if (const auto scale = trueScaleOf(*sphere, *result_.maps[index]))
            result_.maps[index]->notices.push_back(exaggerationNote(*scale, *result_.maps[index]));
        result_.reliefs.back() = makeRelief(*sphere, *result_.maps[index], shape.where);
    }

    /// The index of the image in `images`, which is read when it is not among them; -1 if it was found bad before.
    int imageIndex(const std::string& path, const SourceLocation& where) {
        auto& images = result_.images;
        const auto found = std::ranges::find_if(images, [&](const auto& image) { return image->path() == path; });
        if (found != images.end()) return int(found - images.begin());
        if (!tried_images_.insert(path).second) return -1;
        images.push_back(loadAt(scene_, where, path, [&] { return loadColourMap(path); }));
        return int(images.size()) - 1;
    }

    // pbrt v4's own images of light are square ones in the equal-area octahedral mapping: read as longitude and
    // latitude they would be garbled, silently.
    void loadLightImage(const InfiniteLight& infinite) {
        if (infinite.map_path.empty()) return;
        result_.light_image = imageIndex(infinite.map_path, infinite.where);
        if (result_.light_image < 0) return;
        const ColourMap& image = *result_.images[std::size_t(result_.light_image)];
        if (image.width() == image.height())
            throwInvalid(
                "{}: {}: the image is square ({}x{}), as pbrt v4's equal-area maps are; supported: equirectangular "
                "ones, longitude by latitude",
                infinite.where.text(), image.path(), image.width(), image.height());
        const auto& values = image.raw().linear;
        const auto negative = std::ranges::find_if(values, [](float value) { return value < 0.0f; });
        if (negative != values.end())
            throwInvalid("{}: {}: the light at column {}, row {} is {}; supported: at least 0", infinite.where.text(),
                         image.path(), (negative - values.begin()) / 3 % image.width(),
                         (negative - values.begin()) / 3 / image.width(), *negative);
    }

    const Scene& scene_;
    const MapProgress& progress_;
    bool coarse_;
    const std::uint64_t most_held_;
    SceneMaps result_;
    ErrorList errors_;
    std::vector<const DisplacedSphere*> owners_;    // of the maps, by index
    std::vector<const DisplacedSphere*> bad_maps_;  // those whose error is told already
    std::set<std::string> tried_images_;
};

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

SceneMaps loadSceneMaps(const Scene& scene, std::uint64_t memory_limit, const MapProgress& progress) {
    return Loader(scene, memory_limit, progress).load();
}

bool anyMapStaysInFile(const Scene& scene, std::uint64_t memory_limit) {
    return std::ranges::any_of(scene.shapes, [&](const Shape& shape) {
        const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        return sphere && staysInFile(*sphere, mostHeld(memory_limit));
    });
}

SceneMaps loadCoarseMaps(const Scene& scene) {
    const MapProgress none;
    return Loader(scene, 0, none, true).load();
}

}  // namespace dsphere
