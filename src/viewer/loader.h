#pragma once

#include "viewer/background.h"
#include "viewer/document.h"

#include <functional>
#include <optional>
#include <string>

namespace dsphere::viewer {

/// A file that was read, with what became of the edits that it was to get.
struct Loaded {
    std::unique_ptr<Document> document;
    Edits edits;                    ///< that its scene has
    std::vector<std::string> lost;  ///< edits that no longer fit, in words
};

/// Makes the pipelines ready that such a scene takes, for the window's device to find; takes seconds.
using WarmUp = std::function<void(const SceneTraits& traits)>;

/// Reads and packs on another thread, one piece of work at a time.
class Loader {
  public:
    Loader(OpenScene open, WarmUp warm_up) : open_(std::move(open)), warm_up_(std::move(warm_up)) {}

    bool busy() const { return loading_.busy() || packing_.busy(); }
    /// Whether a document's maps and packing are in use by the work.
    bool packing() const { return packing_.busy(); }
    const std::string& path() const { return path_; }
    /// What is being done, in words; empty: nothing.
    std::string doing() const;

    /// Nothing may be under way for the next four. Reads a file; `kept` edits stay on top of it, unset: all
    /// displacements are multiplied, and a stand-in will do at first.
    void read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels);
    /// Reads again what a document's scene names, after it has become another by edits.
    void remake(const Document& document, const Edits& edits, Levels levels);
    /// The same for a document that a stand-in is drawn of: without one, once its shaders are ready.
    void complete(const Document& document, const Edits& edits, Levels levels);
    /// Makes a document's reliefs those of a scene.
    void retune(Document& document, const Scene& scene);

    /// Once each is there; throws Error, what the work threw.
    std::optional<Loaded> loaded();
    std::optional<PackedScene> packed();
    /// That packed() holds.
    const Scene& packedScene() const { return packed_scene_; }

  private:
    OpenScene open_;
    WarmUp warm_up_;
    bool completing_ = false;
    Background<Loaded> loading_;
    Background<PackedScene> packing_;
    std::string path_;
    Scene packed_scene_;
};

}  // namespace dsphere::viewer
