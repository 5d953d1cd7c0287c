#pragma once

#include "image/rawmap.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace dsphere::test {

/// Heights in 0..65535, as a 16-bit file would hold them; fixed seeds, so always the same map.

/// Ten octaves of value noise on the sphere itself: no seam, no pole, natural slopes.
RawMap fractalMap(int width, int height, std::uint32_t seed = 1);
/// Low noise with one texel in 97 at a random greater height, up to full scale: needles.
RawMap spikeMap(int width, int height, std::uint32_t seed = 1);
/// Texels alternate between 0 and full scale.
RawMap checkerboardMap(int width, int height);
/// Independent random texels.
RawMap randomMap(int width, int height, std::uint32_t seed = 1);
/// The fractal in 24 steps: plateaus and cliffs, as an 8-bit map makes them.
RawMap terraceMap(int width, int height, std::uint32_t seed = 1);
RawMap constantMap(int width, int height, float value);

/// By name: fractal, spikes, checkerboard, random, terraces.
RawMap namedMap(const std::string& name, int width, int height);

/// Writes integer samples as a 16-bit binary PGM.
void writePgm16(const std::filesystem::path& path, const RawMap& map);

}  // namespace dsphere::test
