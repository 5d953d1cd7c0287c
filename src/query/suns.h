#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dsphere::query {

/// A light in the sky of the body.
struct Sun {
    double longitude = 0.0, latitude = 0.0;  ///< degrees, of the point that it stands above
    std::optional<double> distance = {};     ///< from the body's centre, in R; none: infinitely far away
    double radius = 0.0;                     ///< of its disc, degrees as seen from the body's centre; 0: a point
    std::string name = {};                   ///< of its layer; empty: its number
};

/// What is wrong with a sun: "a latitude of 91, expected -90 to 90"; empty: nothing.
std::string faultOf(const Sun& sun);

/// The suns of a CSV file, one a line: columns lon, lat, and if wanted distance (R, or inf), radius and name. Error
/// (InvalidInput) with the line where something is wrong, a name stands twice, or there are no lines.
std::vector<Sun> readSuns(const std::string& file);

}  // namespace dsphere::query
