#pragma once

// What the values of a band are.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "geo/gdaldataset.h"

namespace dsphere::geo {

/// The samples of a band: what one stored value may be.
struct SampleType {
    GDALDataType type = GDT_Unknown;
    int bits = 0;
    bool is_float = false, is_signed = false, signed_bytes = false;

    double fullScale() const { return is_float ? 1.0 : std::exp2(is_signed ? bits - 1 : bits) - 1.0; }
    std::string name() const {
        if (is_float) return fmt::format("float{}", bits);
        return fmt::format("{}{}-bit", is_signed ? "signed " : "", bits);
    }
    /// Whether a float holds every such value.
    bool isExact() const { return is_float ? bits <= 32 : bits <= 24; }
};

/// Throws Error (InvalidInput) for complex numbers.
SampleType sampleTypeOf(const OpenMap& map, GDALRasterBandH band);

/// Which values of a band are unknown by the file's own word.
struct Unknown {
    std::optional<double> value;
    bool special_floats = false;     ///< USGS's and JPL's: everything below the least of them
    GDALRasterBandH mask = nullptr;  ///< of bytes, 0 where unknown

    bool is(double stored) const {
        constexpr double kLeastValid = -3.4028226e38;
        if (std::isnan(stored)) return value.has_value() || mask;
        return (value && stored == *value) || (special_floats && stored <= kLeastValid);
    }
    bool any() const { return value || special_floats || mask; }
};

Unknown unknownOf(const OpenMap& map, GDALRasterBandH band, const SampleType& sample);

/// What a stored value means: offset + scale * stored, in `unit`.
struct Units {
    std::optional<double> scale, offset;  ///< both or none; in metres where the unit is a length
    std::string unit;                     ///< "m" for all lengths; empty: unknown
    std::string unit_source;              ///< "tag", "label", or "default" where it is guessed

    bool operator==(const Units& other) const {
        return scale == other.scale && offset == other.offset && unit == other.unit;
    }
};

/// Where the file has no word of a unit, floats of PDS3 are kilometres, and values of more than 8 bits metres if the
/// file knows the radius of its body or a scale.
Units unitsOf(const OpenMap& map, GDALRasterBandH band, const SampleType& sample, bool knows_radius);

}  // namespace dsphere::geo
