#pragma once

// The map formats written the plain way, for tests.

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/pngwriter.h"

namespace dsphere::test {

/// P5 (one channel) or P6 (three).
inline std::string pnmFile(int width, int height, int maxval, const std::vector<unsigned>& samples) {
    const bool colour = samples.size() != std::size_t(width) * std::size_t(height);
    std::string out = std::string(colour ? "P6\n" : "P5\n") + std::to_string(width) + " " + std::to_string(height) +
                      "\n" + std::to_string(maxval) + "\n";
    for (const unsigned sample : samples) {
        if (maxval > 255) out += char(sample >> 8);
        out += char(sample);
    }
    return out;
}

inline std::string floatBytes(float value, bool little) {
    std::string bytes = big32(std::bit_cast<std::uint32_t>(value));
    return little ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string doubleBytes(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return big32(std::uint32_t(bits >> 32)) + big32(std::uint32_t(bits));
}

/// `samples` north row first, as RawMap has them.
inline std::string pfmFile(int width, int height, const std::vector<float>& samples, bool little) {
    const std::size_t row = samples.size() / std::size_t(height);
    std::string out = std::string(row == std::size_t(width) ? "Pf\n" : "PF\n") + std::to_string(width) + " " +
                      std::to_string(height) + "\n" + (little ? "-1.0" : "1.0") + "\n";
    for (std::size_t j = std::size_t(height); j-- > 0;)
        for (std::size_t k = 0; k < row; ++k) out += floatBytes(samples[j * row + k], little);
    return out;
}

struct GtxHeader {
    double south = -90.0, west = -180.0, latitude_step = 45.0, longitude_step = 45.0;
    int rows = 5, columns = 8;

    std::string bytes() const {
        return doubleBytes(south) + doubleBytes(west) + doubleBytes(latitude_step) + doubleBytes(longitude_step) +
               big32(std::uint32_t(rows)) + big32(std::uint32_t(columns));
    }
};

/// `samples` north row first.
inline std::string gtxFile(const GtxHeader& header, const std::vector<float>& samples) {
    std::string out = header.bytes();
    const std::size_t row = std::size_t(header.columns);
    for (std::size_t j = std::size_t(header.rows); j-- > 0;)
        for (std::size_t i = 0; i < row; ++i) out += floatBytes(samples[j * row + i], false);
    return out;
}

/// 0, 1, 2 ...: every value of 16 bits from 256 columns and 256 rows.
inline std::vector<unsigned> ramp(std::size_t count) {
    std::vector<unsigned> samples(count);
    for (std::size_t k = 0; k < count; ++k) samples[k] = unsigned(k);
    return samples;
}

/// Floats of all magnitudes and both signs, none of them round.
inline std::vector<float> floatRamp(std::size_t count) {
    std::vector<float> samples(count);
    for (std::size_t k = 0; k < count; ++k)
        samples[k] =
            std::bit_cast<float>(std::uint32_t(0x00800000u + 0x7e000000u / count * k) ^ (k % 2 ? 0x80000000u : 0u));
    return samples;
}

}  // namespace dsphere::test
