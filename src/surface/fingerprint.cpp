#include "surface/fingerprint.h"

#include <bit>
#include <concepts>
#include <type_traits>

#include "surface/tiledheights.h"

namespace dsphere {

namespace {

// One function for each type of the model. The bindings name every member, so that one that is added to the model does
// not compile here until it is told of.
struct SceneHash {
    Hash hash;

    void add(double x) { hash.word(std::bit_cast<std::uint64_t>(x)); }
    template <typename T>
    requires std::integral<T> || std::is_enum_v<T>
    void add(T x) { hash.word(std::uint64_t(x)); }
    void add(const std::string& text) { hash.bytes(text.data(), text.size()); }
    template <glm::length_t N>
    void add(const glm::vec<N, double>& v) {
        for (glm::length_t i = 0; i < N; ++i) add(v[i]);
    }
    template <glm::length_t N>
    void add(const glm::mat<N, N, double>& m) {
        for (glm::length_t i = 0; i < N; ++i) add(m[i]);
    }
    template <typename T>
    void add(const std::optional<T>& maybe) {
        add(maybe.has_value());
        if (maybe) add(*maybe);
    }
    template <typename T>
    void add(const std::vector<T>& list) {
        add(list.size());
        for (const T& item : list) add(item);
    }
    template <typename T, std::size_t N>
    void add(const std::array<T, N>& list) {
        for (const T& item : list) add(item);
    }
    template <typename... T>
    void add(const std::variant<T...>& one) {
        add(one.index());
        std::visit([this](const auto& value) { this->add(value); }, one);
    }
    template <typename... T>
    void addAll(const T&... values) {
        (add(values), ...);
    }

    void add(const Camera& camera) {
        const auto& [projection, from_world, fov, window, aspect] = camera;
        addAll(projection, from_world, fov, window, aspect);
    }
    void add(const Film& film) {
        const auto& [filename, width, height, crop] = film;
        addAll(width, height, crop);
    }
    void add(const Integrator& integrator) {
        const auto& [kind, depth, clamp, regularize, hide_distance] = integrator;
        addAll(kind, depth, clamp, regularize, hide_distance);
    }
    void add(const PixelFilter& filter) {
        const auto& [kind, radius, falloff, b, c, tau] = filter;
        addAll(kind, radius, falloff, b, c, tau);
    }
    void add(const Ripples& ripples) { addAll(ripples.u_frequency, ripples.v_frequency); }
    void add(const DisplacedSphere& sphere) {
        const auto& [radius, displacement, path, midlevel, scale, least, greatest, own, in_proportion, registration,
                     longitude, blur, nodata, band, filter, ripples, smooth] = sphere;
        addAll(radius, displacement, midlevel, scale, least, greatest, own, in_proportion, registration, longitude,
               blur, nodata, band, filter, ripples, smooth);
    }
    void add(const Sphere& sphere) { add(sphere.radius); }
    void add(const Disk& disk) {
        const auto& [height, radius, inner] = disk;
        addAll(height, radius, inner);
    }
    void add(const TriangleMesh& mesh) {
        const auto& [points, triangles, uvs] = mesh;
        addAll(points, triangles, uvs);
    }
    void add(const ConstantColour& constant) { add(constant.rgb); }
    void add(const HeightRamp& ramp) { addAll(ramp.ramp, ramp.scale); }
    void add(const ImageMap& image) { addAll(image.scale, image.longitude_origin); }
    void add(const Checkerboard& board) {
        const auto& [even, odd, u, v] = board;
        addAll(even, odd, u, v);
    }
    void add(const Matte& matte) { addAll(matte.reflectance, matte.sigma); }
    void add(const Conductor& metal) {
        const auto& [eta, k, alpha] = metal;
        addAll(eta, k, alpha);
    }
    void add(const Mirror& mirror) { add(mirror.reflectance); }
    void add(const Plastic& plastic) {
        const auto& [diffuse, specular, alpha] = plastic;
        addAll(diffuse, specular, alpha);
    }
    void add(const Shape& shape) {
        const auto& [geometry, from_object, material, where] = shape;
        addAll(geometry, from_object, material);
    }
    void add(const DistantLight& light) { addAll(light.direction, light.radiance); }
    void add(const PointLight& light) { addAll(light.position, light.intensity); }
    void add(const InfiniteLight& light) {
        const auto& [radiance, path, from_light, where] = light;
        addAll(radiance, from_light);
    }
    void add(const AreaLight& light) {
        const auto& [shape, radiance, two_sided] = light;
        addAll(shape, radiance, two_sided);
    }
    void add(const Heightmap& map) {
        addAll(map.width, map.height, map.registration, map.longitude_origin, map.full_scale, map.zero);
        if (map.tiled)
            add(map.tiled->source().identity());
        else
            hash.bytes(map.samples.data(), map.samples.size() * sizeof(float));
    }
    void add(const ColourMap& image) {
        addAll(image.width(), image.height());
        hash.bytes(image.raw().srgb.data(), image.raw().srgb.size());
        hash.bytes(image.raw().linear.data(), image.raw().linear.size() * sizeof(float));
    }
};

}  // namespace

std::uint64_t fingerprint(const Scene& scene, const SceneMaps& maps) {
    SceneHash hash;
    const auto& [name, camera, film, sampler, integrator, pixel_filter, shapes, lights, included, missing, notices] =
        scene;
    hash.addAll(camera, film, integrator, pixel_filter, shapes, lights);
    for (const auto& map : maps.maps) hash.add(*map);
    for (const auto& image : maps.images) hash.add(*image);
    hash.addAll(maps.map_of_shape, maps.image_of_shape, maps.light_image);
    return hash.hash.value();
}

}  // namespace dsphere
