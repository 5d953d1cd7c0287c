#include "query/frames.h"

#include <algorithm>
#include <cmath>

namespace dsphere::query {

std::size_t bodyOf(const Scene& scene) {
    const auto found = std::ranges::find_if(
        scene.shapes, [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); });
    return found == scene.shapes.end() ? 0 : std::size_t(found - scene.shapes.begin());
}

dmat4 frameFromWorld(const Scene& scene, Frame frame) {
    if (frame == Frame::World) return dmat4(1.0);
    return glm::inverse(scene.shapes[bodyOf(scene)].world_from_object);
}

std::vector<ShapeFrame> shapeFrames(const Scene& scene, const SceneMaps& maps, const PackedScene& packed, Frame frame) {
    const std::size_t body = bodyOf(scene);
    const dmat4 world_from_frame = frame == Frame::World ? dmat4(1.0) : scene.shapes[body].world_from_object;
    std::vector<ShapeFrame> frames;
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const Shape& shape = scene.shapes[k];
        ShapeFrame result;
        result.unit = packed.state.objects[k].unit;
        const dmat4 world_from_object = worldFromDevice(shape);
        dmat4 object_from_frame = glm::inverse(world_from_object) * world_from_frame;
        dmat4 frame_from_object = frameFromWorld(scene, frame) * world_from_object;
        // Without a rounding: rays of the body's own frame are often meant to the last bit.
        const bool own = frame == Frame::Body && k == body && !std::holds_alternative<TriangleMesh>(shape.geometry);
        if (own) object_from_frame = frame_from_object = dmat4(1.0);
        for (int c = 0; c < 4; ++c) {
            result.device_from_frame[c] = dvec4(dvec3(object_from_frame[c]) / result.unit, object_from_frame[c].w);
            result.frame_from_device[c] = c < 3 ? frame_from_object[c] * result.unit : frame_from_object[c];
        }
        result.device_from_world_normal = glm::transpose(dmat3(world_from_object));
        result.frame_from_device_normal = glm::transpose(dmat3(object_from_frame));
        result.geometry = &shape.geometry;
        result.in_unit_sphere =
            std::holds_alternative<DisplacedSphere>(shape.geometry) || std::holds_alternative<Sphere>(shape.geometry);
        result.relief = maps.reliefs[k];
        result.base = result.relief.base / result.unit;
        result.scale = result.relief.scale / result.unit;
        if (maps.map_of_shape[k] >= 0) {
            const Heightmap& map = *maps.maps[std::size_t(maps.map_of_shape[k])];
            result.heights.emplace(map, result.relief.filter);
            result.facts = &map.facts;
        }
        frames.push_back(result);
    }
    return frames;
}

}  // namespace dsphere::query
