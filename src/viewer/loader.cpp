#include "viewer/loader.h"

#include <future>

#include "viewer/recent.h"

namespace dsphere::viewer {

namespace {

/// Edits that the new file's scene cannot be shown with are given up.
Loaded load(const std::string& path, const Scene& original, const Edits& wanted, double exaggeration, Levels levels,
            bool quick) {
    Loaded loaded;
    loaded.edits = refit(wanted, original, exaggeration, loaded.lost);
    try {
        loaded.document = makeDocument(path, original, edited(original, loaded.edits), levels, quick);
    } catch (const Error& error) {
        const Edits none = noEdits(original, exaggeration);
        if (loaded.edits == none) throw;
        loaded.document = makeDocument(path, original, edited(original, none), levels, quick);
        loaded.edits = none;
        loaded.lost.push_back(error.what());
    }
    return loaded;
}

}  // namespace

std::string Loader::doing() const {
    if (packing_.busy()) return "Changing the relief";
    if (loading_.busy()) return completing_ ? "Preparing the full light" : "Loading";
    return "";
}

void Loader::read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels) {
    path_ = path;
    completing_ = false;
    loading_.start([=, open = open_] {
        provideSample(path);
        const Scene original = open(path);
        return load(path, original, kept.value_or(noEdits(original, exaggeration)), exaggeration, levels, !kept);
    });
}

void Loader::remake(const Document& document, const Edits& edits, Levels levels) {
    path_ = document.path;
    completing_ = false;
    loading_.start([path = document.path, original = document.original, edits, levels] {
        return Loaded{makeDocument(path, original, edited(original, edits), levels), edits, {}};
    });
}

void Loader::complete(const Document& document, const Edits& edits, Levels levels) {
    path_ = document.path;
    completing_ = true;
    loading_.start([path = document.path, original = document.original, edits, levels, warm_up = warm_up_] {
        const Scene scene = edited(original, edits);
        std::future<void> warm = std::async(std::launch::async, warm_up, traitsOf(scene));
        Loaded loaded{makeDocument(path, original, scene, levels), edits, {}};
        warm.get();
        return loaded;
    });
}

void Loader::retune(Document& document, const Scene& scene) {
    packed_scene_ = scene;
    packing_.start([&document, scene] { return viewer::retune(document, scene); });
}

std::optional<Loaded> Loader::loaded() {
    if (!loading_.ready()) return {};
    return loading_.take();
}

std::optional<PackedScene> Loader::packed() {
    if (!packing_.ready()) return {};
    return packing_.take();
}

}  // namespace dsphere::viewer
