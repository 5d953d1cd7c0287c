#pragma once

#include "render/pack.h"
#include "surface/scenemaps.h"
#include "viewer/globe.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsphere::viewer {

/// Makes a scene of a file: parses it, or makes the one that shows a heightmap. Throws Error.
using OpenScene = std::function<Scene(const std::string& path)>;

/// What the panel changes of the displaced spheres.
struct Tuning {
    double exaggeration = 1.0;
    double midlevel = 0.0;
    Filter filter = Filter::Bilinear;  ///< of the globe, unless it ripples
    Levels levels = Levels::Finest;    ///< that its packing holds

    /// Whether a packing under the other takes the place of this one's on the device as it is.
    bool fits(const Tuning& other) const { return filter == other.filter && levels == other.levels; }
    bool operator==(const Tuning&) const = default;
};

/// An opened file and everything made of it on the host. `packed` refers to `maps`.
struct Document {
    std::string path;
    Scene original;  ///< as the file says it
    Scene scene;     ///< as tuned; its camera and film are the window's
    SceneMaps maps;
    PackedScene packed;
    Tuning tuning;
    std::optional<Globe> globe_of_packing;

    /// Made by locate(), so that it may be used while a retune() changes the maps' reliefs.
    const Globe& globe() const { return *globe_of_packing; }
    void locate();
    /// The files that it came from.
    std::vector<std::filesystem::path> files() const;
    /// The globe as the file says it, null if it is another shape.
    const DisplacedSphere* originalGlobe() const;
};

/// Everything but the device: reads and packs. Throws Error. Takes seconds for large maps.
std::unique_ptr<Document> openDocument(const OpenScene& open, const std::string& path);

/// The same after a change of images, or under a tuning that does not fit(): reads again what the scene says.
std::unique_ptr<Document> remakeDocument(const Document& old, const Scene& scene, const Tuning& tuning);

/// The scene of a document under another tuning.
Scene tuned(const Scene& original, const Tuning& tuning);

/// A new packing of the document's maps under another tuning, which fits(). While it is made the document's maps and
/// packing may not be used. Throws Error (InvalidInput), and leaves the document as it was, if a radius would not be
/// positive.
PackedScene retune(Document& document, const Tuning& tuning);

}  // namespace dsphere::viewer
