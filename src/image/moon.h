#pragma once

// A cratered moon with the sizes and shapes of our own's craters.
//
// Sizes: N(> r) ~ r^-2, the saturated highlands' law. Shapes: depth and rim height of fresh craters as Pike measured
// them (Size-dependence in the shape of fresh impact craters on the moon, 1977), ejecta falling with the cube of the
// distance (McGetchin, Settle and Head 1973). Craters are put on in the order of their age, so that the young cut the
// old; plains of lava drown the low lands before the youngest tenth.

#include "base/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dsphere {

/// An impact. Lengths across are chords of the unit sphere, heights in km.
struct Crater {
    dvec3 centre{0.0};
    double radius = 0.0;
    double age = 0.0;       ///< 0 the youngest, 1 the oldest
    double depth = 0.0;     ///< from the rim's crest to the floor
    double rim = 0.0;       ///< crest above the land around
    double floor = 0.0;     ///< the flat floor's radius as a share of the crater's
    double peak = 0.0;      ///< height of the central peak
    double rounding = 0.0;  ///< height over which the crest is rounded off
    double base = 0.0;      ///< height of the land that it struck
    int octave = 0;         ///< of the noise that bends its outline
};

class Moon {
  public:
    Moon(int width, int height, std::uint32_t seed);

    /// Heights of the row's texels, 0 for -11 km and 1 for 9 km, hardly ever outside; thread-safe.
    std::vector<double> row(int j) const;

  private:
    struct RowState;
    double groundNoise(dvec3 direction, int octave) const;
    /// Height in km before the first crater; leaves the octaves in `noise` unless that is null.
    double ground(const dvec3& direction, int octaves, double* noise) const;
    void listCraters(double least_radius);
    void sortIntoBands();
    void findBases();
    std::span<const std::uint32_t> cratersNear(double colatitude) const;
    void flood(RowState& state) const;
    void strike(const Crater& crater, RowState& state) const;

    int width_, height_, octaves_;
    std::uint32_t seed_;
    std::vector<Crater> craters_;              ///< the oldest first
    std::vector<std::uint32_t> band_first_;    ///< of each band of latitude, its first entry in band_craters_
    std::vector<std::uint32_t> band_craters_;  ///< indices of the craters that reach into the band, the oldest first
    std::vector<dvec2> meridians_;             ///< of each column, sine and cosine of the longitude
};

}  // namespace dsphere
