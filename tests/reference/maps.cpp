#include "tests/reference/maps.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference::test {

namespace {

float mean(const float* row, int count) {
    double sum = 0.0;
    for (int i = 0; i < count; ++i) sum += row[i];
    return float(sum / count);
}

}  // namespace

Heightmap makeMap(int width, int height, Registration registration, const std::function<double(int, int)>& value,
                  double longitude_origin) {
    Heightmap map;
    map.width = width;
    map.height = height;
    map.registration = registration;
    map.longitude_origin = longitude_origin;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) map.samples.push_back(float(value(i, j)));
    float* last = map.samples.data() + std::ptrdiff_t(height - 1) * width;
    map.north_pole = mean(map.samples.data(), width);
    map.south_pole = mean(last, width);
    if (registration == Registration::Gridline) {
        std::fill_n(map.samples.data(), width, map.north_pole);
        std::fill_n(last, width, map.south_pole);
    }
    map.least = *std::min_element(map.samples.begin(), map.samples.end());
    map.greatest = *std::max_element(map.samples.begin(), map.samples.end());
    return map;
}

Relief makeRelief(double radius, double percent, double midlevel) {
    Relief relief;
    relief.scale = radius * percent / 100.0;
    relief.base = radius - relief.scale * midlevel;
    relief.least_radius = std::min(relief.base, relief.base + relief.scale);
    relief.greatest_radius = std::max(relief.base, relief.base + relief.scale);
    return relief;
}

Heightmap flatMap(int width, int height, Registration registration, double value) {
    return makeMap(width, height, registration, [=](int, int) { return value; });
}

Heightmap noiseMap(int width, int height, Registration registration, std::uint64_t seed) {
    Random random(seed);
    return makeMap(width, height, registration, [&](int, int) { return uniform(random, 0.0, 1.0); });
}

Heightmap checkerboard(int width, int height, Registration registration) {
    return makeMap(width, height, registration, [](int i, int j) { return (i + j) % 2; });
}

Heightmap fractalMap(int width, int height, std::uint64_t seed) {
    Random random(seed);
    std::vector<float> sum(std::size_t(width) * std::size_t(height), 0.0f);
    double weight = 0.5;
    for (int octave = 0, cells = std::max(1, width >> 8); octave < 8; ++octave, cells *= 2, weight *= 0.5) {
        const int step = std::max(1, width / (8 * cells)), across = width / step, down = height / step + 2;
        std::vector<float> knots(std::size_t(across) * std::size_t(down));
        for (float& knot : knots) knot = float(uniform(random, 0.0, weight));
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const int x = i / step % across, next = (x + 1) % across, y = j / step;
                const float a = float(i % step) / float(step), b = float(j % step) / float(step);
                const float* top = knots.data() + std::ptrdiff_t(y) * across;
                const float* bottom = top + across;
                sum[std::size_t(j) * std::size_t(width) + std::size_t(i)] +=
                    (top[x] * (1 - a) + top[next] * a) * (1 - b) + (bottom[x] * (1 - a) + bottom[next] * a) * b;
            }
    }
    return makeMap(width, height, Registration::Texel,
                   [&](int i, int j) { return sum[std::size_t(j) * std::size_t(width) + std::size_t(i)]; });
}

dvec3 direction(double u, double v) {
    const double longitude = 2.0 * kPi * (u - 0.5), colatitude = kPi * v;
    return {std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
            std::sin(colatitude) * std::cos(longitude)};
}

double uniform(Random& random, double low, double high) {
    return low + (high - low) * (double(random() >> 11) * 0x1p-53);
}

dvec3 randomUnit(Random& random) {
    for (;;) {
        const dvec3 v(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
        const double length = glm::length(v);
        if (length > 0.1 && length < 1.0) return v / length;
    }
}

Ray randomRay(Random& random, double distance, double reach) {
    const dvec3 origin = distance * randomUnit(random);
    const dvec3 target = reach * std::cbrt(uniform(random, 0.0, 1.0)) * randomUnit(random);
    return {.origin = origin, .direction = uniform(random, 0.5, 2.0) * (target - origin)};
}

}  // namespace dsphere::reference::test
