#pragma once

#include "base/image.h"
#include "image/tone.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <variant>

namespace dsphere {

/// EXR header attributes besides the standard ones.
using Metadata = std::map<std::string, std::variant<std::string, int, float, std::array<float, 16>>>;

/// Writes all channels to a scanline OpenEXR file, one part, first row on top: FLOAT, or UINT for integer channels,
/// data window and display window as in the image. Written under a temporary name, then renamed; on failure the
/// temporary is removed and Error (Failure) thrown.
void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata);

/// Writes channels R, G, B as an 8-bit sRGB PNG (linear -> tone curve after multiplying by 2^exposure -> sRGB curve,
/// clamped, NaN black). Same atomicity and errors as writeExr.
void writePng(const std::filesystem::path& path, const Image& image, const Tone& tone = {});

/// Chooses by the extension, .exr or .png; another one is an Error (Usage).
void writePicture(const std::filesystem::path& path, const Image& image, const Metadata& metadata,
                  const Tone& tone = {});

/// The header's attributes of the types that Metadata holds, matrices left out. Errors as readExr.
Metadata readExrMetadata(const std::filesystem::path& path);

/// Reads back every channel of an EXR file (tests, comparisons), of the first part if there are several; HALF ones are
/// widened to float. Throws Error (InvalidInput) when it cannot: no EXR, truncated, subsampled channels, absurd size.
Image readExr(const std::filesystem::path& path);

/// Reads a PNG of any kind as linear R, G, B: decoded from sRGB, on black where transparent. Throws Error
/// (InvalidInput) when it cannot.
Image readPngPicture(const std::filesystem::path& path);

/// Chooses by the extension, .exr or .png; another one is an Error (Usage).
Image readPicture(const std::filesystem::path& path);

}  // namespace dsphere
