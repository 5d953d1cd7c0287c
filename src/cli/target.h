#pragma once

// Where the picture of a render goes.

#include "cli/renderoptions.h"
#include "image/picture.h"
#include "render/devicefilm.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace dsphere::cli {

inline constexpr const char* kStandardOutput = "-";

/// A file, or standard output, and the planes that its picture is made of.
struct Target {
    std::filesystem::path path;  ///< or kStandardOutput
    Format format = Format::Png;
    std::uint32_t aovs = 0, colours = kColourPlanes;

    /// What the first pass renders.
    std::uint32_t planes() const { return aovs ? aovs : colours; }
    bool isOutput() const { return path == kStandardOutput; }
    std::string name() const { return isOutput() ? "standard output" : path.string(); }
};

/// Wrong options must not cost a render first. Error (Usage) when they contradict each other or the file's format, or
/// when it would replace what the scene reads; Error (Failure) when it cannot be written.
Target checkTarget(const RenderOptions& options, const Scene& scene, const std::filesystem::path& path);

void writeTarget(const Target& target, const Image& picture, const Metadata& metadata, const RenderOptions& options);

}  // namespace dsphere::cli
