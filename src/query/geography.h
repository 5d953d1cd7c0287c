#pragma once

#include "query/frames.h"

namespace dsphere::query {

/// Places and directions given by latitude, longitude (degrees, east positive) and altitude (object units) about the
/// scene's body, in the frame of the rays.
class Geography {
  public:
    enum class Above { Sphere, Ground };  ///< the sphere of the shape's radius, or the surface straight below

    /// What is given must outlive it.
    Geography(const Scene& scene, const SceneMaps& maps, Frame frame);

    /// Error (InvalidInput), prefixed by `where`, if the body is no sphere, or the latitude is outside -90 to 90.
    dvec3 point(double latitude, double longitude, double altitude, Above above, const std::string& where) const;
    /// Of object length 1. Azimuth clockwise from north, elevation above the horizontal plane, degrees.
    dvec3 direction(double latitude, double longitude, double azimuth, double elevation) const;

  private:
    double groundRadius(double latitude, double longitude) const;

    dmat4 frame_from_object_;
    double radius_ = 0.0;  ///< 0: the body is no sphere
    std::optional<Interpolator> heights_;
    Relief relief_;
};

/// The axes of a place, object space: outward, east and north, unit.
struct LocalAxes {
    dvec3 up, east, north;

    LocalAxes(double latitude, double longitude);  ///< degrees
};

}  // namespace dsphere::query
