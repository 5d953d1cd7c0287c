#pragma once

#include "image/rawmap.h"

#include <string>

namespace dsphere {

/// Reads what GeographicLib's geoids in PGM say in their header's comments ("Geoid file in PGM format" in its manual):
///     Offset -108              metres = Offset + Scale x stored
///     Scale 0.003
///     Origin 90N 0E            the first texel's place
///     AREA_OR_POINT Point      values stand on the grid's lines
/// and notes it. Comments without both Offset and Scale say nothing. Throws Error (InvalidInput) for an Origin that is
/// not at the north pole.
void applyGeoidComments(const std::string& comments, RawMap& map, const std::string& path);

}  // namespace dsphere
