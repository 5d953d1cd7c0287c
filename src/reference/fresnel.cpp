#include "reference/fresnel.h"

#include <cmath>
#include <complex>

namespace dsphere::reference {
namespace {

using Complex = std::complex<double>;

double power(const Complex& numerator, const Complex& denominator) {
    return denominator == Complex(0.0) ? 1.0 : std::norm(numerator / denominator);
}

// Born and Wolf, "Principles of Optics", 1.5.2: with m the index of refraction and m cos(theta_t) = sqrt(m^2 - sin^2),
// r_s = (cos - m cos_t) / (cos + m cos_t), r_p = (m^2 cos - m cos_t) / (m^2 cos + m cos_t).
double fresnel(double cosine, const Complex& m) {
    const Complex within = std::sqrt(m * m - (1.0 - cosine * cosine));
    return 0.5 * (power(cosine - within, cosine + within) + power(m * m * cosine - within, m * m * cosine + within));
}

}  // namespace

double fresnelDielectric(double cosine, double eta) {
    return fresnel(cosine, eta);
}

double fresnelConductor(double cosine, double eta, double k) {
    return fresnel(cosine, {eta, k});
}

dvec3 fresnelConductor(double cosine, const dvec3& eta, const dvec3& k) {
    return {fresnelConductor(cosine, eta.r, k.r), fresnelConductor(cosine, eta.g, k.g),
            fresnelConductor(cosine, eta.b, k.b)};
}

}  // namespace dsphere::reference
