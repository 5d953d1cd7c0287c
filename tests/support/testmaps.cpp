#include "tests/support/testmaps.h"

#include "base/error.h"
#include "base/parallel.h"
#include "image/generate.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace dsphere::test {

namespace {

RawMap generate(MapKind kind, int width, int height, const char* type, std::uint32_t seed) {
    RawMap map;
    map.width = width;
    map.height = height;
    map.samples.resize(std::size_t(width) * std::size_t(height));
    map.full_scale = 65535.0;
    map.type = type;
    const MapGenerator generator(kind, width, height, seed);
    parallelFor(std::size_t(height), [&](std::size_t j) {
        std::vector<std::uint16_t> row(std::size_t(width), 0);
        generator.fillRow(int(j), row);
        std::ranges::copy(row, map.samples.begin() + std::ptrdiff_t(j * row.size()));
    });
    return map;
}

}  // namespace

RawMap fractalMap(int width, int height, std::uint32_t seed) {
    return generate(MapKind::Fractal, width, height, "fractal", seed);
}

RawMap spikeMap(int width, int height, std::uint32_t seed) {
    return generate(MapKind::Spikes, width, height, "spikes", seed);
}

RawMap checkerboardMap(int width, int height) {
    return generate(MapKind::Checkerboard, width, height, "checkerboard", 1);
}

RawMap randomMap(int width, int height, std::uint32_t seed) {
    return generate(MapKind::Random, width, height, "random", seed);
}

RawMap terraceMap(int width, int height, std::uint32_t seed) {
    return generate(MapKind::Terraces, width, height, "terraces", seed);
}

RawMap constantMap(int width, int height, float value) {
    RawMap map = checkerboardMap(width, height);
    const double stored = std::clamp(std::round(double(value) * 65535.0), 0.0, 65535.0);
    std::ranges::fill(map.samples, float(stored));
    map.type = "constant";
    return map;
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
