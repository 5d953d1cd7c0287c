#include "image/generate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "image/moon.h"
#include "image/noise.h"

namespace dsphere {
namespace {

double fractalHeight(int i, int j, int width, int height, std::uint32_t seed) {
    const double phi = 2.0 * kPi * (i + 0.5) / width, theta = kPi * (j + 0.5) / height;
    const dvec3 w(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
    double sum = 0.0, amplitude = 0.5;
    for (int octave = 0; octave < 10; ++octave, amplitude *= 0.5)
        sum += amplitude * valueNoise(w * (2.0 * double(1 << octave)), seed + std::uint32_t(octave));
    return 1.6 * (sum - 0.5) + 0.5;
}

double spikeHeight(int i, int j, std::uint32_t seed) {
    const double chance = latticeNoise(i, j, 0, seed), size = latticeNoise(i, j, 1, seed);
    return chance < 1.0 / 97.0 ? 0.1 + 0.9 * size : 0.02 * size;
}

template <typename Height>
void fill(std::span<std::uint16_t> row, Height height_at) {
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = std::uint16_t(std::clamp(std::round(height_at(int(i)) * 65535.0), 0.0, 65535.0));
}

}  // namespace

MapGenerator::MapGenerator(MapKind kind, int width, int height, std::uint32_t seed)
    : kind_(kind), width_(width), height_(height), seed_(seed) {
    assert(width >= 1 && height >= 1);
    if (kind == MapKind::Moon) moon_ = std::make_unique<Moon>(width, height, seed);
}

MapGenerator::~MapGenerator() = default;
MapGenerator::MapGenerator(MapGenerator&&) noexcept = default;

void MapGenerator::fillRow(int j, std::span<std::uint16_t> row) const {
    assert(j >= 0 && j < height_ && row.size() == std::size_t(width_));
    const auto fractal = [&](int i) { return fractalHeight(i, j, width_, height_, seed_); };
    switch (kind_) {
        case MapKind::Moon: {
            const std::vector<double> heights = moon_->row(j);
            return fill(row, [&](int i) { return heights[std::size_t(i)]; });
        }
        case MapKind::Fractal:
            return fill(row, fractal);
        case MapKind::Terraces:
            return fill(row, [&](int i) { return std::floor(24.0 * fractal(i)) / 24.0; });
        case MapKind::Spikes:
            return fill(row, [&](int i) { return spikeHeight(i, j, seed_); });
        case MapKind::Checkerboard:
            return fill(row, [&](int i) { return double((i + j) & 1); });
        case MapKind::Random:
            return fill(row, [&](int i) { return latticeNoise(i, j, 2, seed_); });
    }
}

}  // namespace dsphere
