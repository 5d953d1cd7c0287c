#pragma once

#include "base/math.h"

namespace dsphere::reference {

/// The share of unpolarised light that a plane face reflects, met at the angle whose cosine is given, 0 to 1.
double fresnelDielectric(double cosine, double eta);  ///< eta > 1: from air into glass
/// Of a metal with complex index of refraction eta + i k, both 0 or greater; eta = 0 reflects all.
double fresnelConductor(double cosine, double eta, double k);
dvec3 fresnelConductor(double cosine, const dvec3& eta, const dvec3& k);

}  // namespace dsphere::reference
