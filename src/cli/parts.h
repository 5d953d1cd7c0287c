#pragma once

// Parts of a picture: what their headers say, and whether they make one together.

#include "base/notice.h"
#include "image/exrstream.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dsphere::cli {

/// What a picture is a part of, as its header tells it.
struct PartOf {
    Box picture;      ///< the whole picture's pixels
    int samples = 0;  ///< of the whole picture, a pixel
    int first = 0;    ///< of the part's own samples
    int turns = 1;    ///< pixels that an invocation takes one after the other: see NEXT_PIXEL_STEPS

    bool operator==(const PartOf&) const = default;
};

/// Adds them, and the commit that this program was built from, to a header.
void tellPart(Metadata& metadata, const PartOf& part);
/// Takes them out of one.
void forgetPart(Metadata& metadata);
/// The first of the samples that a picture has: 0 unless it is a part.
int firstSampleOf(const Metadata& metadata);

/// A file that holds samples first to last - 1 of the pixels of `data`.
struct Part {
    std::filesystem::path path;
    Box data, display;
    int first = 0, last = 0;
    PartOf of;
    std::vector<ChannelKind> channels;
    Metadata metadata;
};

/// Reads the header. Error (InvalidInput) when the file is no part.
Part readPart(const std::filesystem::path& path);

/// The parts, ordered by their pixels, then by their samples. Error (InvalidInput) when they are not of one scene,
/// program and set of options, when two hold the same samples of a pixel, or when some are missing: it names them.
std::vector<Part> orderedParts(std::vector<Part> parts);

/// What may make the merged picture another one than an undivided render, in its last bits.
Notices noticesOf(const std::vector<Part>& ordered);

}  // namespace dsphere::cli
