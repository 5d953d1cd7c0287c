#pragma once

// The readers behind readRawMap and readRawColour, each of which starts at the file's first byte, and what they share.

#include "image/inputfile.h"
#include "image/mapchannels.h"
#include "image/rawcolour.h"
#include "image/rawmap.h"

#include <cstdint>
#include <string_view>

namespace dsphere {

inline constexpr std::int64_t kMaxSide = 1 << 20;
inline constexpr std::int64_t kMaxTexels = std::int64_t(1) << 31;

/// What the first bytes say that a file is.
enum class MapFormat { Empty, Png, Jpeg, Pnm, Pfm, Tiff, Exr, Unknown };

MapFormat formatOf(InputFile& file);
std::string firstBytes(InputFile& file);  ///< the first four for a message: "4d 5a 90 00"

RawMap readPng(InputFile& file);
RawMap readPnm(InputFile& file);  ///< PGM and PPM: P2 P3 P5 P6
RawMap readPfm(InputFile& file);
RawMap readGtx(InputFile& file);
RawMap readTiff(InputFile& file);    ///< the first page; classic or BigTIFF
RawMap readExrMap(InputFile& file);  ///< the first part; channel Y, else R G B, else the only one there is

// Colour images of the same formats. TIFF: no signed integers; EXR: channels R G B, else Y.
RawColour readPngColour(InputFile& file);
RawColour readPnmColour(InputFile& file);
RawColour readPfmColour(InputFile& file);
RawColour readTiffColour(InputFile& file);
RawColour readExrColour(InputFile& file);
RawColour readJpegColour(InputFile& file);  ///< grey or YCbCr, baseline or progressive; no CMYK

/// Throws unless both sides are in 1..kMaxSide and the texels at most kMaxTexels. `format` is for the message: "PNG".
void checkSize(const InputFile& file, std::string_view format, std::int64_t width, std::int64_t height);

/// Throws unless `needed` bytes follow the header just read. `what` is for the message: "8-bit PGM of 4x2 texels".
void checkLength(const InputFile& file, std::string_view what, std::uint64_t needed);

}  // namespace dsphere
