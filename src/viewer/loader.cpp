#include "viewer/loader.h"

namespace dsphere::viewer {

namespace {

/// Edits that the new file's scene cannot be shown with are given up.
Loaded load(const std::string& path, const Scene& original, const Edits& wanted, double exaggeration, Levels levels) {
    Loaded loaded;
    loaded.edits = refit(wanted, original, exaggeration, loaded.lost);
    try {
        loaded.document = makeDocument(path, original, edited(original, loaded.edits), levels);
    } catch (const Error& error) {
        const Edits none = noEdits(original, exaggeration);
        if (loaded.edits == none) throw;
        loaded.document = makeDocument(path, original, edited(original, none), levels);
        loaded.edits = none;
        loaded.lost.push_back(error.what());
    }
    return loaded;
}

}  // namespace

std::string Loader::doing() const {
    if (packing_.busy()) return "Changing the relief";
    return loading_.busy() ? "Loading" : "";
}

void Loader::read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels) {
    path_ = path;
    loading_.start([=, open = open_] {
        const Scene original = open(path);
        return load(path, original, kept.value_or(noEdits(original, exaggeration)), exaggeration, levels);
    });
}

void Loader::remake(const Document& document, const Edits& edits, Levels levels) {
    path_ = document.path;
    loading_.start([path = document.path, original = document.original, edits, levels] {
        return Loaded{makeDocument(path, original, edited(original, edits), levels), edits, {}};
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
