#pragma once

#include "query/query.h"
#include "render/pack.h"
#include "surface/interpolator.h"

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
    const MapFacts* facts = nullptr;      ///< what the map says of its values; of a displaced sphere
};

/// The shape that "body" and geographic coordinates mean: the first displaced sphere, else the first shape.
std::size_t bodyOf(const Scene& scene);

/// From the world to the body's object space; the identity for Frame::World.
dmat4 frameFromWorld(const Scene& scene, Frame frame);

/// One per shape.
std::vector<ShapeFrame> shapeFrames(const Scene& scene, const SceneMaps& maps, const PackedScene& packed, Frame frame);

/// A ray in a shape's space on the device: p(s) = point + s direction, direction unit, point nearest the centre.
struct DeviceRay {
    dvec3 point, direction;
    double origin;  ///< s of the ray's own origin
    double length;  ///< of its direction: s = origin + length t
};

DeviceRay deviceRay(const ShapeFrame& shape, const QueryRay& ray);

}  // namespace dsphere::query
