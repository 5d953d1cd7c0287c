#include "render/filtertable.h"

#include "shaders/layout.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr int kSteps = 1 << 14;  // across the filter, in which the kernel counts as constant

double sinc(double x) {
    const double angle = kPi * x;
    return std::abs(angle) < 1e-5 ? 1.0 : std::sin(angle) / angle;
}

// Mitchell and Netravali 1988, "Reconstruction filters in computer graphics", up to a factor.
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x < 1.0) return ((12.0 - 9.0 * b - 6.0 * c) * x + (-18.0 + 12.0 * b + 6.0 * c)) * x * x + (6.0 - 2.0 * b);
    return (((-b - 6.0 * c) * x + (6.0 * b + 30.0 * c)) * x + (-12.0 * b - 48.0 * c)) * x + (8.0 * b + 24.0 * c);
}

double kernel(const PixelFilter& filter, double radius, double x) {
    switch (filter.kind) {
        case PixelFilter::Kind::Box:
            return 1.0;
        case PixelFilter::Kind::Gaussian:
            return std::exp(-filter.falloff * x * x) - std::exp(-filter.falloff * radius * radius);
        case PixelFilter::Kind::Triangle:
            return radius - std::abs(x);
        case PixelFilter::Kind::Mitchell:
            return mitchell(2.0 * x / radius, filter.b, filter.c);
        case PixelFilter::Kind::Sinc:
            return sinc(x) * sinc(x / filter.tau);
    }
    return 0.0;
}

/// A run of steps on which the kernel keeps its sign.
struct Lobe {
    int begin = 0, end = 0;
    double mass = 0.0;  ///< of the kernel, with its sign
    int intervals = 0;
};

std::vector<Lobe> lobesOf(const std::vector<double>& values) {
    std::vector<Lobe> lobes;
    for (int i = 0; i < int(values.size()); ++i) {
        const double value = values[std::size_t(i)];
        if (lobes.empty() || value * lobes.back().mass < 0.0) lobes.push_back({i, i, 0.0});
        lobes.back().end = i + 1;
        lobes.back().mass += value;
    }
    return lobes;
}

// As their masses ask, one at least; the largest lobe takes the rest.
void shareIntervals(std::vector<Lobe>& lobes) {
    double all = 0.0;
    for (const Lobe& lobe : lobes) all += std::abs(lobe.mass);
    int given = 0;
    for (Lobe& lobe : lobes) {
        lobe.intervals = std::max(1, int(std::lround(FILTER_INTERVALS * std::abs(lobe.mass) / all)));
        given += lobe.intervals;
    }
    const auto size = [](const Lobe& lobe) { return std::abs(lobe.mass); };
    std::ranges::max_element(lobes, {}, size)->intervals += FILTER_INTERVALS - given;
}

}  // namespace

FilterTable filterTable(const PixelFilter& filter, double radius) {
    const auto place = [&](double step) { return radius * (2.0 * step / kSteps - 1.0); };
    std::vector<double> values;
    for (int i = 0; i < kSteps; ++i) values.push_back(kernel(filter, radius, place(i + 0.5)));
    std::vector<Lobe> lobes = lobesOf(values);
    shareIntervals(lobes);
    double sum = 0.0;
    for (const Lobe& lobe : lobes) sum += lobe.mass;
    FilterTable table;
    for (const Lobe& lobe : lobes) {
        int step = lobe.begin;
        double before = 0.0;
        for (int k = 0; k < lobe.intervals; ++k) {
            const double wanted = std::abs(lobe.mass) * k / lobe.intervals;
            double here = std::abs(values[std::size_t(step)]);
            while (step + 1 < lobe.end && before + here <= wanted) {
                before += here;
                here = std::abs(values[std::size_t(++step)]);
            }
            const double share = here > 0.0 ? (wanted - before) / here : 0.0;
            table.places.push_back(float(place(step + share)));
            table.weights.push_back(float(lobe.mass / sum * FILTER_INTERVALS / lobe.intervals));
        }
    }
    table.places.push_back(float(radius));
    return table;
}

int filterKind(const PixelFilter& filter) {
    switch (filter.kind) {
        case PixelFilter::Kind::Box:
            return FILTER_BOX;
        case PixelFilter::Kind::Gaussian:
        case PixelFilter::Kind::Triangle:
            return FILTER_POSITIVE;
        case PixelFilter::Kind::Mitchell:
        case PixelFilter::Kind::Sinc:
            return FILTER_SIGNED;
    }
    return FILTER_SIGNED;
}

}  // namespace dsphere
