#pragma once

// First hits of the plain shapes in closed form. `position`, t_low <= t_high and the rules of Ray as for the displaced
// sphere; verdicts are Hit or Miss, and least_f is not set.

#include "reference/ray.h"
#include "scene/scene.h"

namespace dsphere::reference {

/// A solid sphere about the origin, radius > 0: a camera ray from inside hits at t_min.
FirstHit hitSphere(double radius, const Ray& ray);

/// The ring, from either side; it has no inside. A root at t_min itself counts unless may_start_inside is false.
FirstHit hitDisk(const Disk& disk, const Ray& ray);

}  // namespace dsphere::reference
