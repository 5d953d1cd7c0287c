#include "reference/ggx.h"

#include "reference/quadrature.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {
namespace {

constexpr double kLeastCosine = 1e-5;  // E is taken as constant beyond

/// cos (1 + 2 Lambda) = sqrt(cos^2 + alpha^2 sin^2).
double stretched(double cosine, double alpha) {
    return std::sqrt(cosine * cosine + alpha * alpha * (1.0 - cosine * cosine));
}

/// D of a normal parallel to h, of any length. The sine is that of the cross product: 1 - cos^2 would lose it.
double distribution(const dvec3& h, double alpha) {
    const double length2 = glm::dot(h, h), a2 = alpha * alpha;
    const double cos2 = h.z * h.z / length2, sin2 = (h.x * h.x + h.y * h.y) / length2;
    const double bulge = a2 * cos2 + sin2;
    return a2 / (kPi * bulge * bulge);
}

}  // namespace

// G / (4 c_l c_v) with G = 1 / (1 + Lambda(l) + Lambda(v)) and 1 + 2 Lambda(x) = stretched(c_x) / c_x.
double Facets::reflection(const dvec3& l, const dvec3& v) const {
    if (!(l.z > 0.0 && v.z > 0.0)) return 0.0;
    return distribution(l + v, alpha) / (2.0 * (v.z * stretched(l.z, alpha) + l.z * stretched(v.z, alpha)));
}

// G1 = 1 / (1 + Lambda) = 2 c / (c + stretched).
double Facets::visibleDensity(const dvec3& l, const dvec3& v) const {
    if (!(l.z > 0.0 && v.z > 0.0)) return 0.0;
    return distribution(l + v, alpha) / (2.0 * (v.z + stretched(v.z, alpha)));
}

// Heitz 2018, "Sampling the GGX distribution of visible normals": seen from the stretched v, the facets are a
// hemisphere, whose projection is sampled.
dvec3 Facets::visibleNormal(const dvec3& v, const dvec2& u) const {
    const dvec3 seen = glm::normalize(dvec3(alpha * v.x, alpha * v.y, v.z));
    const double across = std::hypot(seen.x, seen.y);
    const dvec3 x = across > 0.0 ? dvec3(-seen.y, seen.x, 0.0) / across : dvec3(1.0, 0.0, 0.0);
    const dvec3 y = glm::cross(seen, x);
    const double r = std::sqrt(u.x), turn = 2.0 * kPi * u.y, share = 0.5 * (1.0 + seen.z);
    const double t1 = r * std::cos(turn);
    const double t2 = (1.0 - share) * std::sqrt(1.0 - t1 * t1) + share * r * std::sin(turn);
    const dvec3 h = t1 * x + t2 * y + std::sqrt(std::max(0.0, 1.0 - t1 * t1 - t2 * t2)) * seen;
    return glm::normalize(dvec3(alpha * h.x, alpha * h.y, std::max(0.0, h.z)));
}

// E = int D(h) G dot(v, h) / c_v dh over the normals h whose reflection l is above the surface. With tan(theta_h) =
// alpha T, D cos(theta_h) dh = 2 T dT dphi / (2 pi (1 + T^2)^2), and dot(v, h) / (c_v cos(theta_h)) = 1 + tan(theta_v)
// tan(theta_h) cos(phi). All phi have their l above up to theta_h = (pi / 2 - theta_v) / 2, none from (pi / 2 +
// theta_v) / 2 on; in between phi's end runs as a square root does at both ends, hence the cosine there. Something
// happens where T is about 1 and where it is about 1 / alpha: ln T sees both.
double Facets::albedo(double cosine) const {
    static const GaussLegendre rule(64);
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine)), tan_v = sine / cosine;
    auto ring = [&](double t) {  // for the integral over ln T
        const double tan_h = alpha * t, cos2_h = 1.0 / (1.0 + tan_h * tan_h);
        const double least = sine > 0.0 ? (0.5 / cos2_h - 1.0) / (tan_v * tan_h) : -2.0;
        const double end = std::acos(std::clamp(least, -1.0, 1.0));
        auto at = [&](double phi) {
            const double towards = 1.0 + tan_v * tan_h * std::cos(phi);  // dot(v, h) / (c_v cos_h)
            const double c_l = cosine * (2.0 * towards * cos2_h - 1.0);
            if (!(c_l > 0.0)) return 0.0;
            const double shadowing =
                2.0 * c_l * cosine / (c_l * stretched(cosine, alpha) + cosine * stretched(c_l, alpha));
            return shadowing * towards;
        };
        return 2.0 / kPi * std::pow(t / (1.0 + t * t), 2) * rule.integral(0.0, end, at);
    };
    auto logRing = [&](double y) { return ring(std::exp(y)); };
    const double theta_v = std::atan2(sine, cosine);
    const double whole = std::tan(0.5 * (0.5 * kPi - theta_v)) / alpha;
    const double low = std::min(whole, std::sqrt(1.0 / alpha));
    auto psiRing = [&](double psi) {  // T = tan(psi)
        const double t = std::tan(psi);
        return ring(t) * (1.0 + t * t) / t;
    };
    const double middle = std::log(1.0 / alpha), half = middle - std::log(whole);
    auto bentRing = [&](double x) {
        return kPi * half * std::sin(kPi * x) * logRing(middle - half * std::cos(kPi * x));
    };
    return rule.integral(0.0, std::atan(low), psiRing) + rule.integral(std::log(low), std::log(whole), logRing) +
           rule.integral(0.0, 1.0, bentRing);
}

LostLight::LostLight(double alpha) {
    constexpr int kNodes = 257;
    const Facets facets{alpha};
    auto cosineAt = [](double x) { return std::max(x * x * x, kLeastCosine); };
    for (int k = 0; k < kNodes; ++k)
        lost_.push_back(std::max(0.0, 1.0 - facets.albedo(cosineAt(double(k) / (kNodes - 1)))));
    // 2 int (1 - E) c dc with c = x^3.
    mean_lost_ = GaussLegendre(64).integral(
        0.0, 1.0, [&](double x) { return 6.0 * std::pow(x, 5) * (1.0 - facets.albedo(cosineAt(x))); });
}

// Lagrange's cubic through the four nodes about x.
double LostLight::at(double cosine) const {
    const int last = int(lost_.size()) - 1;
    const double x = std::cbrt(std::clamp(cosine, 0.0, 1.0)) * last;
    const int first = std::clamp(int(x) - 1, 0, last - 3);
    double sum = 0.0;
    for (int j = 0; j < 4; ++j) {
        double weight = 1.0;
        for (int m = 0; m < 4; ++m)
            if (m != j) weight *= (x - first - m) / (j - m);
        sum += weight * lost_[std::size_t(first + j)];
    }
    return std::max(0.0, sum);
}

}  // namespace dsphere::reference
