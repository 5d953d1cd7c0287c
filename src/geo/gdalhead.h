#pragma once

// What a map that is open in GDAL says of itself besides its samples.

#include <string>
#include <vector>

#include "base/error.h"
#include "geo/gdalband.h"
#include "geo/gdalreference.h"
#include "geo/placement.h"
#include "geo/readmap.h"
#include "image/rawmap.h"

namespace dsphere::geo {

struct MapHead {
    RawMap map;  ///< everything but the samples; its size is that of the placed map
    Placement placed;
    std::vector<int> bands;  ///< the bands whose mean is read: one, or red, green and blue
    SampleType sample;       ///< of the first of them
    Unknown unknown;         ///< of the first of them
    Notices ellipsoid;       ///< told unless heights count from a radius that the file gives as its offset
};

/// `placed` false: the file's words about its place and its values are left out, as readRawMap() leaves them out.
/// Throws Error (InvalidInput) when the map is no whole sphere in longitudes and latitudes, has no such band, or has
/// complex samples.
MapHead readHead(const OpenMap& file, std::optional<int> band, bool placed = true);

/// Decides whether the offset is a radius, and adds the notices that depend on it. `greatest` is the greatest absolute
/// value that a sample has or can have.
void completeHead(MapHead& head, const OpenMap& file, double greatest);

/// The error as it is when it names the file, else behind its name and the reason why GDAL reads it.
Error withReason(const Error& error, const FileForGdal& found);

}  // namespace dsphere::geo
