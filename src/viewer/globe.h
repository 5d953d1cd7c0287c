#pragma once

#include "base/math.h"
#include "scene/scene.h"
#include "surface/nodes.h"

#include <optional>

namespace dsphere::viewer {

/// A place on the planet as people name it: degrees, and what the map stores there.
struct Place {
    double latitude, longitude;
    std::optional<double> stored;  ///< in the map's units; unset without a map
};

/// The body that the camera moves about: a scene's first displaced sphere, else its first shape. World space.
class Globe {
  public:
    /// `nodes` (null: no map) must outlive the globe; of the chosen shape, as is the relief.
    Globe(const Shape& shape, const NodeGrid* nodes, const Relief& relief);
    /// The shape of a scene that is its globe.
    static std::size_t shapeOf(const Scene& scene);

    const dvec3& centre() const { return centre_; }
    double radius() const { return radius_; }        ///< R: the greatest, as the longest axis of the transform shows it
    const dvec3& north() const { return north_; }    ///< unit
    const dvec3& origin() const { return origin_; }  ///< unit: towards latitude 0, longitude 0
    const dvec3& east() const { return east_; }      ///< unit: towards latitude 0, longitude 90

    /// Distance of the ground from the centre in a direction of any length but 0.
    double ground(const dvec3& direction) const;
    /// Of a point above the ground; below it is negative.
    double altitude(const dvec3& point) const;
    /// `point` is not the centre.
    Place placeOf(const dvec3& point) const;

  private:
    dvec3 objectDirection(const dvec3& world) const;
    double rippleAt(const dvec3& object_direction) const;
    double storedAt(const dvec3& object_direction) const;

    const NodeGrid* nodes_;
    Relief relief_;
    dmat4 object_from_world_;
    dvec3 centre_, north_, origin_, east_;
    double radius_ = 1.0;
};

}  // namespace dsphere::viewer
