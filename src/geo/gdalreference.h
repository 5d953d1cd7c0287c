#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/notice.h"
#include "geo/gdaldataset.h"
#include "geo/placement.h"

namespace dsphere::geo {

/// What a file says of its coordinates.
struct Reference {
    std::optional<LatLonGrid> grid;  ///< unset: it says nothing
    std::string projection;          ///< "geographic", "equirectangular"; another's name where `grid` is unset
    bool other_projection = false;   ///< neither of the two, or rotated: `grid` is unset
    std::optional<double> radius;    ///< metres: of an ellipsoid the mean
    std::string radius_source;       ///< "tag" or "label"
    Notices notices;                 ///< the error of taking an ellipsoid for a sphere
};

Reference referenceOf(const OpenMap& map);

/// Longitudes and latitudes of a sphere of that radius in metres; unset: of the Earth's mean. To be destroyed.
OGRSpatialReferenceH newSphere(std::optional<double> radius);

std::string wktOf(OGRSpatialReferenceH crs);

/// Metres in a unit of length: 1 for "m", "meters", "METRE"; 1000 for kilometres; unset for what is no length.
std::optional<double> metresIn(const std::string& unit);

}  // namespace dsphere::geo
