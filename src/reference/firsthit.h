#pragma once

// The first hit of a ray with the displaced sphere, proven by interval exclusion front to back.

#include "reference/ray.h"
#include "reference/surface.h"

#include <vector>

namespace dsphere::reference {

/// The contract's tangency: a move of the ray sideways by this much, in units of the greatest radius R, may change the
/// answer.
inline constexpr double kSideways = 1e-6;

/// Hit or Miss. Everything before the root is proven to lie outside, for the ray as rounded to double about its point
/// nearest the centre (moved by less than 1e-15 R + 1e-19 |origin|), wherever that can be proven in double: pieces that
/// are shorter than 1e-13 R, or on which f varies by less than its rounding error, go by the sign of f in their middle.
/// Takes bounded time on any ray and map. Does not set least_f.
FirstHit firstHit(const Surface& surface, const Ray& ray);

/// firstHit() with least_f, and with Tangent if moving the ray sideways by at most kSideways R turns hit into miss,
/// miss into hit, or makes the root jump to another one. `hit`, t_low ... stay those of the ray itself. About 40 times
/// the cost of firstHit.
FirstHit classify(const Surface& surface, const Ray& ray);

/// The ray with its origin moved; the offset is in object units.
Ray movedSideways(Ray ray, const dvec3& offset);

/// The ray's neighbours that decide tangency: 16 directions perpendicular to it at kSideways R and at half of it, and
/// the same along the surface's normal at the hit, or at the point nearest the surface on a miss. Whatever firstHit
/// says of any of these is a right answer for the ray.
std::vector<Ray> sidewaysRays(const Surface& surface, const Ray& ray);

}  // namespace dsphere::reference
