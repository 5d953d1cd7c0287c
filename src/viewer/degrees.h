#pragma once

#include <optional>
#include <string>

namespace dsphere::viewer {

/// The letters of an angle's two directions: "NS" of latitudes, "EW" of longitudes. The first is positive.
using Directions = const char*;

/// "45.5° S" of -45.5, with `places` behind the point.
std::string degreesText(double degrees, Directions directions, int places = 5);

/// What somebody typed, "45.5 S", "45.5S" or "-45.5": degrees. Unset: it is no number, goes on with anything else than
/// ° and one of the letters (small ones do), or lies beyond `most` either way.
std::optional<double> degreesIn(const std::string& text, Directions directions, double most);

}  // namespace dsphere::viewer
