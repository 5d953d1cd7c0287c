#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>

#include "base/math.h"
#include "base/parallel.h"

namespace dsphere {
namespace {

// Section numbers are the paper's.

using Kernel = std::vector<double>;  ///< 2 radius + 1 weights

struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    double* row(int y) { return &values[std::size_t(y) * std::size_t(width)]; }
    const double* row(int y) const { return &values[std::size_t(y) * std::size_t(width)]; }
};

using Planes = std::array<Plane, 3>;

/// Linear sRGB to XYZ (IEC 61966-2-1 with D65), exact fractions. GLM's columns.
const dmat3 kXyzFromRgb{
    dvec3(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0),
    dvec3(8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0),
    dvec3(4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0),
};
const dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const dvec3 kWhite = kXyzFromRgb * dvec3(1.0);

/// The opponent space in which contrast sensitivity is known (4.1).
dvec3 toOpponent(const dvec3& rgb) {
    const dvec3 c = kXyzFromRgb * rgb / kWhite;
    return {116.0 * c.y - 16.0, 500.0 * (c.x - c.y), 200.0 * (c.y - c.z)};
}

dvec3 fromOpponent(const dvec3& opponent) {
    const double y = (opponent.x + 16.0) / 116.0;
    return kRgbFromXyz * (dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * kWhite);
}

double labCurve(double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

/// L*a*b*, its chroma scaled by lightness for the Hunt effect (4.1).
dvec3 toHuntLab(const dvec3& rgb) {
    const dvec3 c = kXyzFromRgb * rgb / kWhite;
    const double x = labCurve(c.x), y = labCurve(c.y), z = labCurve(c.z), lightness = 116.0 * y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

/// The HyAB distance to the power 0.7 (4.1).
double colourDistance(const dvec3& a, const dvec3& b) {
    const dvec3 d = a - b;
    return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), 0.7);
}

/// Distances to 0.4 of the greatest take 0.95 of the range (4.1).
double compressed(double distance) {
    static const double kGreatest = colourDistance(toHuntLab({0.0, 1.0, 0.0}), toHuntLab({0.0, 0.0, 1.0}));
    const double knee = 0.4 * kGreatest;
    const double value =
        distance < knee ? 0.95 / knee * distance : 0.95 + (distance - knee) / (kGreatest - knee) * 0.05;
    return std::min(value, 1.0);
}

Kernel makeKernel(int radius, const std::function<double(int)>& weight) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) kernel.push_back(weight(x));
    return kernel;
}

void divideBySum(Kernel& kernel) {
    double sum = 0.0;
    for (double weight : kernel) sum += weight;
    for (double& weight : kernel) weight /= sum;
}

/// Scales the negative weights to a sum of -1, the positive ones to 1 (4.2).
void balance(Kernel& kernel) {
    double negative = 0.0, positive = 0.0;
    for (double weight : kernel) (weight < 0.0 ? negative : positive) += std::abs(weight);
    for (double& weight : kernel) weight /= weight < 0.0 ? negative : positive;
}

/// Convolution by `across` along rows and `down` along columns; the edge pixels go on outside.
Plane convolve(const Plane& in, const Kernel& across, const Kernel& down) {
    const int width = in.width, height = in.height;
    Plane middle(width, height), out(width, height);
    const auto radius = [](const Kernel& kernel) { return int(kernel.size() / 2); };
    parallelFor(std::size_t(height), [&](std::size_t task) {
        const int y = int(task);
        for (int x = 0; x < width; ++x)
            for (int k = -radius(across); k <= radius(across); ++k)
                middle.row(y)[x] +=
                    across[std::size_t(k + radius(across))] * in.row(y)[std::clamp(x + k, 0, width - 1)];
    });
    parallelFor(std::size_t(height), [&](std::size_t task) {
        const int y = int(task);
        for (int k = -radius(down); k <= radius(down); ++k) {
            const double* from = middle.row(std::clamp(y + k, 0, height - 1));
            for (int x = 0; x < width; ++x) out.row(y)[x] += down[std::size_t(k + radius(down))] * from[x];
        }
    });
    return out;
}

/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees: a part of a contrast sensitivity function (4.1, table 1).
struct Sensitivity {
    double a, b;
};

/// The plane as the eye at that distance resolves it: each part is separable, their weights sum to 1.
Plane filtered(const Plane& in, const std::vector<Sensitivity>& parts, int radius, double pixels_per_degree) {
    Plane out(in.width, in.height);
    std::vector<Kernel> kernels;
    std::vector<double> weights;
    double total = 0.0;
    for (const Sensitivity& part : parts) {
        kernels.push_back(makeKernel(radius, [&](int x) {
            const double degrees = x / pixels_per_degree;
            return std::exp(-kPi * kPi * degrees * degrees / part.b);
        }));
        double sum = 0.0;
        for (double weight : kernels.back()) sum += weight;
        weights.push_back(part.a * std::sqrt(kPi / part.b) * sum * sum);
        total += weights.back();
        divideBySum(kernels.back());
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const Plane plane = convolve(in, kernels[p], kernels[p]);
        for (std::size_t k = 0; k < out.values.size(); ++k) out.values[k] += weights[p] / total * plane.values[k];
    }
    return out;
}

Planes toOpponentPlanes(const Image& image) {
    const int width = image.data.width(), height = image.data.height();
    Planes planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    const auto clean = [](float value) { return value > 0.0f ? std::min(double(value), 1.0) : 0.0; };
    const auto &r = image.at("R").floats(), &g = image.at("G").floats(), &b = image.at("B").floats();
    for (std::size_t k = 0; k < r.size(); ++k) {
        const dvec3 opponent = toOpponent({clean(r[k]), clean(g[k]), clean(b[k])});
        for (int c = 0; c < 3; ++c) planes[std::size_t(c)].values[k] = opponent[c];
    }
    return planes;
}

/// What the eye resolves of the picture, in Hunt-adjusted L*a*b*.
Planes perceived(const Planes& opponent, double pixels_per_degree) {
    const int radius = int(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixels_per_degree));
    Planes planes{filtered(opponent[0], {{1.0, 0.0047}}, radius, pixels_per_degree),
                  filtered(opponent[1], {{1.0, 0.0053}}, radius, pixels_per_degree),
                  filtered(opponent[2], {{34.1, 0.04}, {13.5, 0.025}}, radius, pixels_per_degree)};
    parallelFor(std::size_t(planes[0].height), [&](std::size_t y) {
        for (int x = 0; x < planes[0].width; ++x) {
            const auto at = [&](std::size_t c) -> double& { return planes[c].row(int(y))[x]; };
            const dvec3 rgb = fromOpponent({at(0), at(1), at(2)});
            const dvec3 lab = toHuntLab(glm::clamp(rgb, 0.0, 1.0));
            for (int c = 0; c < 3; ++c) at(std::size_t(c)) = lab[c];
        }
    });
    return planes;
}

struct Features {
    Plane edges, points;
};

/// Strengths of edges and points in the lightness, at the 0.082 degrees that mark a line (4.2).
Features findFeatures(const Planes& opponent, double pixels_per_degree) {
    Plane grey = opponent[0];
    for (double& value : grey.values) value = (value + 16.0) / 116.0;
    const double sigma = 0.5 * 0.082 * pixels_per_degree;
    const int radius = int(std::ceil(3.0 * sigma));
    const auto gauss = [sigma](int x) { return std::exp(-0.5 * x * x / (sigma * sigma)); };
    Kernel smooth = makeKernel(radius, gauss);
    Kernel first = makeKernel(radius, [&](int x) { return -x * gauss(x); });
    Kernel second = makeKernel(radius, [&](int x) { return (x * x / (sigma * sigma) - 1.0) * gauss(x); });
    divideBySum(smooth);
    balance(first);
    balance(second);
    const auto strength = [&](const Kernel& kernel) {
        Plane across = convolve(grey, kernel, smooth);
        const Plane down = convolve(grey, smooth, kernel);
        for (std::size_t k = 0; k < across.values.size(); ++k)
            across.values[k] = std::hypot(across.values[k], down.values[k]);
        return across;
    };
    return {strength(first), strength(second)};
}

}  // namespace

std::vector<float> flip(const Image& reference, const Image& test, double pixels_per_degree) {
    assert(reference.data.width() == test.data.width() && reference.data.height() == test.data.height());
    const Planes opponent_a = toOpponentPlanes(reference), opponent_b = toOpponentPlanes(test);
    const Features features_a = findFeatures(opponent_a, pixels_per_degree);
    const Features features_b = findFeatures(opponent_b, pixels_per_degree);
    const Planes a = perceived(opponent_a, pixels_per_degree), b = perceived(opponent_b, pixels_per_degree);
    std::vector<float> result(reference.pixelCount());
    for (std::size_t k = 0; k < result.size(); ++k) {
        const auto colour = [k](const Planes& p) { return dvec3(p[0].values[k], p[1].values[k], p[2].values[k]); };
        const double colours = compressed(colourDistance(colour(a), colour(b)));
        const double feature = std::max(std::abs(features_a.edges.values[k] - features_b.edges.values[k]),
                                        std::abs(features_a.points.values[k] - features_b.points.values[k]));
        const double features = std::min(std::sqrt(feature / std::numbers::sqrt2), 1.0);
        result[k] = float(std::pow(colours, 1.0 - features));  // (4.3)
    }
    return result;
}

}  // namespace dsphere
