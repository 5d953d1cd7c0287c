#pragma once

// What a scene may hold, in one place; docs/scene-format.md has the same table. The parser checks all of it with line
// and column, so that `info` refuses what `render` would.

#include <cstddef>

namespace dsphere::limits {

/// Errors that one run lists; what follows them is left out, and the last line says so.
inline constexpr std::size_t kReportedErrors = 20;

// The text. A parse takes time in proportion to it.
inline constexpr std::size_t kTextBytes = std::size_t(16) << 20;  ///< of the scene's file and every Include together
inline constexpr int kIncludeDepth = 16;
inline constexpr int kIncludes = 4096;               ///< in a scene
inline constexpr std::size_t kBlockDepth = 1024;     ///< open AttributeBegin and TransformBegin
inline constexpr std::size_t kParameters = 256;      ///< of one directive
inline constexpr std::size_t kDefaults = 32;         ///< that Attribute holds for one target
inline constexpr std::size_t kDefaultValues = 1024;  ///< of those together
inline constexpr std::size_t kValues = 65536;        ///< of one parameter
inline constexpr std::size_t kDefinitions = 65536;   ///< materials, textures and coordinate systems by name, together

// The world. Device structures have these sizes too (shaders/layout.h).
inline constexpr std::size_t kShapes = 64;
inline constexpr std::size_t kLights = 32;
inline constexpr std::size_t kMarches = 640;  ///< shapes times (lights + 1)
inline constexpr std::size_t kTrianglesOfMesh = 64;
inline constexpr std::size_t kTriangles = 512;  ///< of all meshes together
inline constexpr int kRippleFrequency = 512;

// The range of numbers that single floats hold with room for their squares and products.
struct Span {
    double least, greatest;
};
inline constexpr Span kLength{1e-15, 1e15};          ///< world units: radii and sizes
inline constexpr double kGreatestCoordinate = 1e15;  ///< of a place in the world, the eye's included
inline constexpr double kRadiance = 1e12;            ///< L or I times scale
inline constexpr double kReach = 2e4;                ///< the greatest radius of a displaced sphere over its own radius
inline constexpr double kDisplacement = 1e6;         ///< maxdispl in percent

// The options.
inline constexpr Span kFov{1e-4, 179.99};    ///< degrees over the shorter axis
inline constexpr int kResolution = 1 << 20;  ///< pixels a side
inline constexpr int kPixelSamples = 65536;
inline constexpr int kMaxDepth = 64;  ///< reflections; more is cut down to it

}  // namespace dsphere::limits
