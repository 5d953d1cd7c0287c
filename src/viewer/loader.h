#pragma once

#include "viewer/background.h"
#include "viewer/document.h"

#include <optional>
#include <string>

namespace dsphere::viewer {

/// A file that was read, with what became of the edits that it was to get.
struct Loaded {
    std::unique_ptr<Document> document;
    Edits edits;                    ///< that its scene has
    std::vector<std::string> lost;  ///< edits that no longer fit, in words
};

/// Reads and packs on another thread, one piece of work at a time.
class Loader {
  public:
    explicit Loader(OpenScene open) : open_(std::move(open)) {}

    bool busy() const { return loading_.busy() || packing_.busy(); }
    /// Whether a document's maps and packing are in use by the work.
    bool packing() const { return packing_.busy(); }
    const std::string& path() const { return path_; }
    /// What is being done, in words; empty: nothing.
    std::string doing() const;

    /// Nothing may be under way for the next three. Reads a file; `kept` edits stay on top of it, unset: all
    /// displacements are multiplied.
    void read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels);
    /// Reads again what a document's scene names, after it has become another by edits.
    void remake(const Document& document, const Edits& edits, Levels levels);
    /// Makes a document's reliefs those of a scene.
    void retune(Document& document, const Scene& scene);

    /// Once each is there; throws Error, what the work threw.
    std::optional<Loaded> loaded();
    std::optional<PackedScene> packed();
    /// That packed() holds.
    const Scene& packedScene() const { return packed_scene_; }

  private:
    OpenScene open_;
    Background<Loaded> loading_;
    Background<PackedScene> packing_;
    std::string path_;
    Scene packed_scene_;
};

}  // namespace dsphere::viewer
