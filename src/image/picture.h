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

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& path);

/// Writes all channels to a scanline OpenEXR file, one part, first row on top: as FLOAT, integer ones too, since many
/// readers misread UINT; UINT only where an integer channel has a value that no float is equal to. Data window and
/// display window as in the image. Whole or not at all, see AtomicFile: "-" is standard output; Error (Failure).
void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata);

/// Writes channels R, G, B as an 8-bit sRGB PNG (linear -> tone curve after multiplying by 2^exposure -> sRGB curve,
/// clamped, NaN black). With a channel A, by which R, G, B are multiplied as everywhere else, the PNG has it too, and
/// colours are divided by it, as PNG demands. Same atomicity and errors as writeExr.
void writePng(const std::filesystem::path& path, const Image& image, const Tone& tone = {});

/// Error (Failure) with the reason where writePng() could not hold so many pixels and channels.
void checkPngSize(const std::filesystem::path& path, int width, int height, int channels);

/// Chooses by the extension, .exr or .png; another one is an Error (Usage).
void writePicture(const std::filesystem::path& path, const Image& image, const Metadata& metadata,
                  const Tone& tone = {});

/// The header's attributes of the types that Metadata holds. Errors as readExr.
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
