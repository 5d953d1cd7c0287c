#include "tests/support/testmaps.h"

#include "base/error.h"
#include "base/math.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace dsphere::test {

namespace {

std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ x >> 16;
}

double lattice(int x, int y, int z, std::uint32_t seed) {
    return hash(std::uint32_t(x) + hash(std::uint32_t(y) + hash(std::uint32_t(z) + hash(seed)))) / 4294967296.0;
}

double smooth(double t) {
    return t * t * (3.0 - 2.0 * t);
}

double valueNoise(const dvec3& p, std::uint32_t seed) {
    dvec3 cell = glm::floor(p), t = p - cell;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        double weight = (dx ? smooth(t.x) : 1.0 - smooth(t.x)) * (dy ? smooth(t.y) : 1.0 - smooth(t.y)) *
                        (dz ? smooth(t.z) : 1.0 - smooth(t.z));
        sum += weight * lattice(int(cell.x) + dx, int(cell.y) + dy, int(cell.z) + dz, seed);
    }
    return sum;
}

RawMap emptyMap(int width, int height, const char* type) {
    RawMap map;
    map.width = width;
    map.height = height;
    map.samples.resize(std::size_t(width) * std::size_t(height));
    map.full_scale = 65535.0;
    map.type = type;
    return map;
}

template <typename Fn>
RawMap filledMap(int width, int height, const char* type, Fn height_of) {
    RawMap map = emptyMap(width, height, type);
    parallelFor(std::size_t(height), [&](std::size_t j) {
        for (int i = 0; i < width; ++i)
            map.samples[j * std::size_t(width) + std::size_t(i)] =
                float(std::clamp(std::round(height_of(i, int(j)) * 65535.0), 0.0, 65535.0));
    });
    return map;
}

double fractalHeight(int i, int j, int width, int height, std::uint32_t seed) {
    double phi = 2.0 * kPi * (i + 0.5) / width, theta = kPi * (j + 0.5) / height;
    dvec3 w(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
    double sum = 0.0, amplitude = 0.5;
    for (int octave = 0; octave < 10; ++octave, amplitude *= 0.5)
        sum += amplitude * valueNoise(w * (2.0 * double(1 << octave)), seed + std::uint32_t(octave));
    return 1.6 * (sum - 0.5) + 0.5;
}

}  // namespace

RawMap fractalMap(int width, int height, std::uint32_t seed) {
    return filledMap(width, height, "fractal", [=](int i, int j) { return fractalHeight(i, j, width, height, seed); });
}

RawMap spikeMap(int width, int height, std::uint32_t seed) {
    return filledMap(width, height, "spikes", [=](int i, int j) {
        double chance = lattice(i, j, 0, seed), size = lattice(i, j, 1, seed);
        return chance < 1.0 / 97.0 ? 0.1 + 0.9 * size : 0.02 * size;
    });
}

RawMap checkerboardMap(int width, int height) {
    return filledMap(width, height, "checkerboard", [](int i, int j) { return double((i + j) & 1); });
}

RawMap randomMap(int width, int height, std::uint32_t seed) {
    return filledMap(width, height, "random", [=](int i, int j) { return lattice(i, j, 2, seed); });
}

RawMap terraceMap(int width, int height, std::uint32_t seed) {
    return filledMap(width, height, "terraces",
                     [=](int i, int j) { return std::floor(24.0 * fractalHeight(i, j, width, height, seed)) / 24.0; });
}

RawMap constantMap(int width, int height, float value) {
    return filledMap(width, height, "constant", [=](int, int) { return double(value); });
}

RawMap namedMap(const std::string& name, int width, int height) {
    if (name == "fractal") return fractalMap(width, height);
    if (name == "spikes") return spikeMap(width, height);
    if (name == "checkerboard") return checkerboardMap(width, height);
    if (name == "random") return randomMap(width, height);
    if (name == "terraces") return terraceMap(width, height);
    throw Error(ExitCode::Usage,
                "unknown map '" + name + "'; there are fractal, spikes, checkerboard, random, terraces");
}

void writePgm16(const std::filesystem::path& path, const RawMap& map) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << map.width << ' ' << map.height << "\n65535\n";
    std::string row;
    for (std::size_t k = 0; k < map.samples.size(); ++k) {
        unsigned value = unsigned(map.samples[k]);
        row.push_back(char(value >> 8));
        row.push_back(char(value & 255u));
        if (row.size() >= 1u << 16 || k + 1 == map.samples.size()) {
            file.write(row.data(), std::streamsize(row.size()));
            row.clear();
        }
    }
    if (!file) throwFailure("{}: cannot write", path.string());
}

}  // namespace dsphere::test
