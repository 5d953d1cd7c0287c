#pragma once

#include "viewer/camera.h"

namespace dsphere::viewer {

/// A way of the camera about a globe from one pose to another, in about a second.
class Flight {
  public:
    static constexpr double kSeconds = 1.2;

    /// Neither eye is at the centre. Times are seconds on any clock.
    Flight(const Pose& from, const Pose& to, const dvec3& centre, double start);

    bool over(double now) const { return now >= start_ + kSeconds; }
    /// `to` itself once it is over.
    Pose at(double now) const;

  private:
    Pose from_, to_;
    dvec3 centre_;
    double start_;
};

}  // namespace dsphere::viewer
