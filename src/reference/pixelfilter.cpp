#include "reference/pixelfilter.h"

#include <cmath>

namespace dsphere::reference {
namespace {

using Kind = PixelFilter::Kind;

double uniform(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>()(random);
}

// By the two polynomials of the paper's equation 8.
double mitchell(double x, double b, double c) {
    const double x2 = x * x, x3 = x2 * x;
    if (x < 1.0) return (12 - 9 * b - 6 * c) * x3 + (-18 + 12 * b + 6 * c) * x2 + (6 - 2 * b);
    return (-b - 6 * c) * x3 + (6 * b + 30 * c) * x2 + (-12 * b - 48 * c) * x + (8 * b + 24 * c);
}

double sinc(double x) {
    return x == 0.0 ? 1.0 : std::sin(kPi * x) / (kPi * x);
}

// Simpson's rule over the half of the axis, by the kernel's mean.
double meanOfKernel(const PixelFilter& filter, double radius) {
    constexpr int kPieces = 4096;
    double sum = 0.0;
    for (int i = 0; i <= kPieces; ++i) {
        const double factor = i == 0 || i == kPieces ? 1.0 : i % 2 ? 4.0 : 2.0;
        sum += factor * filterKernel(filter, radius, radius * i / kPieces);
    }
    return sum / (3.0 * kPieces);
}

// The Gaussian by rejection: its kernel is 1 - exp(-falloff radius^2) at most.
double gaussianPlace(const PixelFilter& filter, double radius, std::mt19937_64& random) {
    const double greatest = filterKernel(filter, radius, 0.0);
    for (;;) {
        const double x = radius * (2.0 * uniform(random) - 1.0);
        if (uniform(random) * greatest <= filterKernel(filter, radius, x)) return x;
    }
}

}  // namespace

double filterKernel(const PixelFilter& filter, double radius, double x) {
    x = std::abs(x);
    if (x > radius) return 0.0;
    switch (filter.kind) {
        case Kind::Box:
            return 1.0;
        case Kind::Gaussian:
            return std::exp(-filter.falloff * x * x) - std::exp(-filter.falloff * radius * radius);
        case Kind::Triangle:
            return radius - x;
        case Kind::Mitchell:
            return mitchell(2.0 * x / radius, filter.b, filter.c);
        case Kind::Sinc:
            return sinc(x) * sinc(x / filter.tau);
    }
    return 0.0;
}

FilterSampler::FilterSampler(const PixelFilter& filter) : filter_(filter) {
    for (int axis = 0; axis < 2; ++axis) mean_[axis] = meanOfKernel(filter, filter.radius[axis]);
}

// Signed kernels take places evenly and weigh them by the kernel.
FilterSample FilterSampler::sample(std::mt19937_64& random) const {
    FilterSample sample;
    for (int axis = 0; axis < 2; ++axis) {
        const double radius = filter_.radius[axis];
        double& x = sample.place[axis];
        switch (filter_.kind) {
            case Kind::Gaussian:
                x = gaussianPlace(filter_, radius, random);
                break;
            case Kind::Triangle:  // the sum of two even places
                x = radius * (uniform(random) + uniform(random) - 1.0);
                break;
            case Kind::Box:
            case Kind::Mitchell:
            case Kind::Sinc:
                x = radius * (2.0 * uniform(random) - 1.0);
                sample.weight *= filterKernel(filter_, radius, x) / mean_[axis];
        }
    }
    return sample;
}

}  // namespace dsphere::reference
