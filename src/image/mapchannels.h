#pragma once

// What colour and alpha channels say of a file that is read as a heightmap: whether it holds heights at all, and which
// texels are unknown. Readers put every texel through these and call `report` at the end.

#include "image/rawmap.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace dsphere {

/// The grey of a colour: exactly the value when all are equal, else the mean, rounded once.
inline float meanOf(float r, float g, float b) {
    if (r == g && g == b) return r;
    return float((double(r) + double(g) + double(b)) / 3.0);
}

/// The red, green and blue of a map's texels, which are equal in a grey map that was saved as colour.
class ColourCensus {
  public:
    /// To be called before the first texel of each row (or of each run of texels of one row).
    void startRow() { has_previous_ = false; }

    /// Counts a texel and returns its height, the mean.
    float grey(float r, float g, float b) {
        const Colour colour{r, g, b};
        if (std::isfinite(r) && std::isfinite(g) && std::isfinite(b)) count(colour);
        return meanOf(r, g, b);
    }

    /// Says in the map's notices when the channels differ, and by how much. Throws Error (InvalidInput) when they look
    /// like one height spread over several 8-bit channels (Terrarium, Terrain-RGB), whose mean is noise.
    void report(RawMap& map, const std::string& path) const;

  private:
    using Colour = std::array<float, 3>;

    /// Steps from texel to texel of two neighbouring channels, taken as the high and the low byte of one number.
    struct BytePair {
        double high = 0.0, low = 0.0;        ///< sums of the channels' absolute steps
        double together = 0.0, apart = 0.0;  ///< the same of 256 high + low, and of the two parts of that sum
        std::size_t steps = 0;               ///< in which either channel changed

        void add(double high_step, double low_step);
        bool isOneNumber() const;
    };

    void count(const Colour& colour);
    bool isTerrainRgb() const;

    Colour least_{HUGE_VALF, HUGE_VALF, HUGE_VALF}, greatest_{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}, previous_{};
    bool has_previous_ = false;
    float difference_ = 0.0f;  ///< the greatest between two channels of a texel
    BytePair red_green_, green_blue_;
};

/// The alpha of a map's texels. 0 means that a texel's height is unknown.
class AlphaCensus {
  public:
    explicit AlphaCensus(double opaque) : opaque_(float(opaque)) {}

    /// Counts a texel; false where its height is unknown, so that its sample is to be NaN.
    bool isKnown(float alpha) {
        const bool known = alpha > 0.0f;
        hidden_ += !known;
        partial_ += known && alpha < opaque_;
        return known;
    }

    /// Sets the map's `unknown_are_nan` when there are such texels, and says how many are partly transparent.
    void report(RawMap& map, const std::string& path) const;

  private:
    float opaque_;
    std::size_t hidden_ = 0, partial_ = 0;
};

}  // namespace dsphere
