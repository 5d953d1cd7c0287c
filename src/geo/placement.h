#pragma once

// Where a grid of longitudes and latitudes lies on the sphere; no file, no library.

#include <string>

#include "base/notice.h"
#include "image/rawmap.h"

namespace dsphere::geo {

/// A grid as a file describes it: texel (i, j) covers longitudes west + i dx to west + (i + 1) dx and latitudes
/// north + j dy to north + (j + 1) dy, in degrees, east positive. dx < 0: columns run westward; dy > 0: rows run from
/// the south.
struct LatLonGrid {
    int width = 0, height = 0;
    double west = 0.0, north = 0.0, dx = 0.0, dy = 0.0;
};

/// How such a grid becomes a map of the whole sphere whose first row is in the north.
struct Placement {
    int columns = 0;        ///< distinct ones, which are kept
    int rows = 0;           ///< from pole to pole
    int rows_above = 0;     ///< unknown rows north of the file's first
    bool mirrored = false;  ///< the file's columns run westward
    bool flipped = false;   ///< the file's rows run northward
    bool gridline = false;  ///< values stand on parallels from pole to pole
    double longitude_origin = -180.0;
    MapExtent extent;
    Notices notices;
};

/// Throws Error (InvalidInput), naming the file and `dsphere import`, when the grid does not go all around, when it
/// goes beyond the poles, or when neither rows of texels nor gridlines from pole to pole fall on its rows.
Placement placeOnSphere(const std::string& file, const LatLonGrid& grid);

}  // namespace dsphere::geo
