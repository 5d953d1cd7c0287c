#pragma once

#include "viewer/background.h"
#include "viewer/document.h"

#include <atomic>
#include <functional>
#include <memory>
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
    /// Waits for the work, which ends early where it can.
    ~Loader() { cancel(); }

    bool busy() const { return loading_.busy() || packing_.busy(); }
    /// Whether a document's maps and packing are in use by the work.
    bool packing() const { return packing_.busy(); }
    const std::string& path() const { return path_; }
    /// What is being done, in words; empty: nothing.
    std::string doing() const;
    /// Of the maps that are surveyed, 0 to 1; -1: none is.
    double share() const { return loading_.busy() ? progress_->share.load() : -1.0; }
    /// A survey ends at once, with an Error (Interrupted); other work goes on.
    void cancel() { progress_->cancelled = true; }

    /// Nothing may be under way for the next four. Reads a file; `kept` edits stay on top of it, unset: all
    /// displacements are multiplied, and a provisional document will do at first.
    void read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels);
    /// Reads again what a document's scene names, after it has become another by edits.
    void remake(const Document& document, const Edits& edits, Levels levels);
    /// The same for a document that is provisional: its maps surveyed, once the shaders of its scene are ready. Takes
    /// less of the processor's time than the window does.
    void complete(const Document& document, const Edits& edits, Levels levels);
    /// Makes a document's reliefs those of a scene.
    void retune(Document& document, const Scene& scene);

    /// Once each is there; throws Error, what the work threw.
    std::optional<Loaded> loaded();
    std::optional<PackedScene> packed();
    /// That packed() holds.
    const Scene& packedScene() const { return packed_scene_; }

  private:
    MapProgress begin(const char* task, const std::string& path);

    OpenScene open_;
    WarmUp warm_up_;
    const char* task_ = "";  ///< of loading_, in words
    struct Progress {
        std::atomic<double> share = -1.0;
        std::atomic<bool> cancelled = false;
    };
    std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();  ///< of loading_
    Background<Loaded> loading_;
    Background<PackedScene> packing_;
    std::string path_;
    Scene packed_scene_;
};

}  // namespace dsphere::viewer
