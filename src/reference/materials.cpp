#include "reference/materials.h"

#include "base/overloads.h"
#include "reference/fresnel.h"
#include "reference/quadrature.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {
namespace {

constexpr double kPlasticEta = 1.5;

double sineOf(const dvec3& w) {
    return std::hypot(w.x, w.y);
}

/// dot(l, h) = dot(v, h) for the half vector h.
double halfCosine(const dvec3& l, const dvec3& v) {
    return std::min(1.0, 0.5 * glm::length(l + v));
}

// Malley: the projection of a uniform disk.
dvec3 cosineDirection(const dvec2& u) {
    const double r = std::sqrt(u.x), turn = 2.0 * kPi * u.y;
    return {r * std::cos(turn), r * std::sin(turn), std::sqrt(1.0 - u.x)};
}

// F_ms of Kulla and Conty 2017, "Revisiting physically based shading at Imageworks": a geometric series of bounces, at
// each of which 1 - E_mean stays between the facets.
dvec3 bouncedFresnel(const Conductor& metal, double mean_lost) {
    dvec3 mean(0.0);
    const GaussLegendre rule(64);
    for (int c = 0; c < 3; ++c)
        mean[c] = rule.integral(
            0.0, 1.0, [&](double cosine) { return 2.0 * cosine * fresnelConductor(cosine, metal.eta[c], metal.k[c]); });
    return mean * mean * (1.0 - mean_lost) / (1.0 - mean * mean_lost);
}

}  // namespace

Material softened(Material material) {
    using Found = double*;
    double* const alpha = std::visit(
        Overloads{[](Matte&) -> Found { return nullptr; }, [](Conductor& metal) -> Found { return &metal.alpha; },
                  [](Mirror&) -> Found { return nullptr; }, [](Plastic& plastic) -> Found { return &plastic.alpha; }},
        material);
    if (alpha && *alpha < 0.05)
        *alpha = 0.1;
    else if (alpha && *alpha < 0.3)
        *alpha = std::min(2.0 * *alpha, 0.3);
    return material;
}

// Oren and Nayar 1994, "Generalization of Lambert's reflectance model", the simple form (their equation 30).
double orenNayar(double sigma_degrees, const dvec3& l, const dvec3& v) {
    if (sigma_degrees == 0.0) return 1.0;
    const double sigma2 = glm::radians(sigma_degrees) * glm::radians(sigma_degrees);
    const double a = 1.0 - sigma2 / (2.0 * (sigma2 + 0.33)), b = 0.45 * sigma2 / (sigma2 + 0.09);
    const double sine_l = sineOf(l), sine_v = sineOf(v);
    if (!(v.z > 0.0) || sine_l == 0.0 || sine_v == 0.0) return a;
    const double same_side = std::max(0.0, (l.x * v.x + l.y * v.y) / (sine_l * sine_v));
    const double tan_lesser = l.z > v.z ? sine_l / l.z : sine_v / v.z;
    return a + b * same_side * std::max(sine_l, sine_v) * tan_lesser;
}

Reflector::Reflector(const Material& material) : material_(material) {
    const auto prepare =
        Overloads{[](const Matte&) {},
                  [&](const Conductor& metal) {
                      facets_ = Facets{metal.alpha};
                      lost_ = std::make_shared<LostLight>(metal.alpha);
                      bounced_fresnel_ = bouncedFresnel(metal, lost_->mean());
                  },
                  [](const Mirror&) {}, [&](const Plastic& plastic) { facets_ = Facets{plastic.alpha}; }};
    std::visit(prepare, material);
}

dvec3 Reflector::bounced(double c_l, double c_v) const {
    if (!(lost_->mean() > 0.0)) return dvec3(0.0);
    return bounced_fresnel_ * (lost_->at(c_l) * lost_->at(c_v) / (kPi * lost_->mean()));
}

dvec3 Reflector::f(const dvec3& l, const dvec3& v, const dvec3& colour) const {
    if (!(l.z > 0.0)) return dvec3(0.0);
    const auto reflect = Overloads{
        [&](const Matte& matte) { return colour / kPi * orenNayar(matte.sigma, l, v); },
        [&](const Conductor& metal) {
            if (!(v.z > 0.0)) return dvec3(0.0);
            const dvec3 fresnel = fresnelConductor(halfCosine(l, v), metal.eta, metal.k);
            return fresnel * facets_->reflection(l, v) + bounced(l.z, v.z);
        },
        [](const Mirror&) { return dvec3(0.0); },
        [&](const Plastic& plastic) {
            const double facets = facets_->reflection(l, v);
            return colour / kPi + plastic.specular * (facets * fresnelDielectric(halfCosine(l, v), kPlasticEta));
        }};
    return std::visit(reflect, material_);
}

double Reflector::facetShare(const dvec3& v) const {
    if (!facets_ || !(v.z > 0.0)) return 0.0;
    return lost_ ? 1.0 - lost_->at(v.z) : 0.5;
}

double Reflector::density(const dvec3& l, const dvec3& v) const {
    if (mirror() || !(l.z > 0.0)) return 0.0;
    const double share = facetShare(v), diffuse = (1.0 - share) * l.z / kPi;
    return share > 0.0 ? diffuse + share * facets_->visibleDensity(l, v) : diffuse;
}

dvec3 Reflector::sample(const dvec3& v, const dvec2& u, double lobe) const {
    if (mirror()) return {-v.x, -v.y, v.z};
    if (lobe >= facetShare(v)) return cosineDirection(u);
    const dvec3 h = facets_->visibleNormal(v, u);
    return 2.0 * glm::dot(v, h) * h - v;
}

const dvec3* Reflector::mirror() const {
    const auto* mirror = std::get_if<Mirror>(&material_);
    return mirror ? &mirror->reflectance : nullptr;
}

}  // namespace dsphere::reference
