#pragma once

#include "query/query.h"
#include "render/pack.h"
#include "surface/interpolator.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dsphere::query {

using Frame = QueryOptions::Frame;

/// One shape of the scene as rays of a frame (world or body) meet it, in double.
struct ShapeFrame {
    dmat4 device_from_frame, frame_from_device;  ///< device: the shape's own space in units of R
    double unit = 1.0;                           ///< R, object units
    dmat3 device_from_world_normal{1.0};         ///< what it gives is not normalised; nor the next
    dmat3 frame_from_device_normal{1.0};
    const Geometry* geometry = nullptr;
    std::optional<Interpolator> heights;  ///< of a displaced sphere
    Relief relief;                        ///< in object units
    double base = 1.0, scale = 0.0;   ///< of a displaced sphere: the ground is base + scale * sample R from the centre
    bool in_unit_sphere = false;      ///< nothing of the shape lies farther than 1 R from its centre
    const MapFacts* facts = nullptr;  ///< what the map says of its values; of a displaced sphere
};

/// The shape that "body" and geographic coordinates mean: the first displaced sphere, else the first shape.
std::size_t bodyOf(const Scene& scene);

/// From the world to the body's object space; the identity for Frame::World.
dmat4 frameFromWorld(const Scene& scene, Frame frame);

/// One per shape.
std::vector<ShapeFrame> shapeFrames(const Scene& scene, const SceneMaps& maps, const PackedScene& packed, Frame frame);

/// A ray in a shape's space on the device: p(t) = origin + t direction, the ray's own t.
struct ShapeLine {
    dvec3 origin, direction{0.0};

    ShapeLine(const ShapeFrame& shape, const QueryRay& ray) : origin(dvec3(shape.device_from_frame[3])) {
        for (int c = 0; c < 3; ++c) {
            const dvec3 column(shape.device_from_frame[c]);
            origin += ray.origin[std::size_t(c)] * column;
            direction += ray.direction[std::size_t(c)] * column;
        }
    }
};

/// The same, counted from its point nearest the centre: p(s) = point + s direction, direction unit, point nearest the
/// centre.
struct DeviceRay {
    dvec3 point, direction;
    double origin;  ///< s of the ray's own origin
    double length;  ///< of its direction: s = origin + length t
};

// Of every ray that is asked about: inline.
inline DeviceRay deviceRay(const ShapeFrame& shape, const QueryRay& ray) {
    const ShapeLine line(shape, ray);
    dvec3 d = line.direction;
    double square = glm::dot(d, d), scale = 1.0;
    if (!(square > 1e-200 && square < 1e200)) {  // scaled first, so that no square overflows or vanishes
        scale = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        d /= scale;
        square = glm::dot(d, d);
    }
    const double size = std::sqrt(square);
    DeviceRay result;
    result.direction = d * (1.0 / size);
    result.point = glm::cross(result.direction, glm::cross(line.origin, result.direction));
    result.origin = glm::dot(line.origin, result.direction);
    result.length = size * scale;
    return result;
}

}  // namespace dsphere::query
