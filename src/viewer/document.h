#pragma once

#include "render/pack.h"
#include "surface/scenemaps.h"
#include "viewer/edits.h"
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

/// An opened file and everything made of it on the host. `packed` refers to `maps`.
struct Document {
    std::string path;
    Scene original;  ///< as the file says it
    Scene scene;     ///< as edited; its camera and film are the window's
    /// Drawn while the shaders of paths are being made, which take seconds: see standIn(). Edits wait meanwhile.
    std::optional<Scene> stand_in;
    Levels levels = Levels::Finest;
    SceneMaps maps;  ///< of the scene that is drawn, as all that follows
    PackedScene packed;
    std::shared_ptr<const Bodies>
        bodies;  ///< made by locate(), of `scene`: used while retune() changes the maps' reliefs

    Scene& drawn() { return stand_in ? *stand_in : scene; }
    const Scene& drawn() const { return stand_in ? *stand_in : scene; }
    /// What is drawn stands in for the scene itself, which takes seconds to make ready: by standIn(), or with maps that
    /// are coarse because they have yet to be surveyed.
    bool provisional() const { return stand_in || maps.coarse; }
    void locate();
    /// Whether heights of some map are read while it is drawn.
    bool hasMapsInFiles() const;
    /// The files that it came from.
    std::vector<std::filesystem::path> files() const;
};

/// Reads the maps of a file's scene and packs them: everything but the device. `original` is the scene as the file says
/// it, `scene` as it is shown; `quick`: a provisional one will do. Scenes with maps that stay in their files have all
/// levels of detail. Throws Error. Takes seconds for large maps: `progress` is told of those that are surveyed.
std::unique_ptr<Document> makeDocument(const std::string& path, const Scene& original, const Scene& scene,
                                       Levels levels, bool quick = false, const MapProgress& progress = {});

/// A new packing of the document's maps under the reliefs of another scene, which differs in Rework::Relief at most.
/// While it is made the document's maps and packing may not be used. Throws Error (InvalidInput), and leaves the
/// document as it was, if a radius would not be positive.
PackedScene retune(Document& document, const Scene& scene);

}  // namespace dsphere::viewer
