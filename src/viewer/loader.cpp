#include "viewer/loader.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <future>

#include "viewer/recent.h"

namespace dsphere::viewer {

namespace {

/// Edits that the new file's scene cannot be shown with are given up.
Loaded load(const std::string& path, const Scene& original, const Edits& wanted, double exaggeration, Levels levels,
            bool quick, const MapProgress& progress) {
    Loaded loaded;
    loaded.edits = refit(wanted, original, exaggeration, loaded.lost);
    try {
        loaded.document = makeDocument(path, original, edited(original, loaded.edits), levels, quick, progress);
    } catch (const Error& error) {
        const Edits none = noEdits(original, exaggeration);
        if (loaded.edits == none) throw;
        loaded.document = makeDocument(path, original, edited(original, none), levels, quick, progress);
        loaded.edits = none;
        loaded.lost.push_back(error.what());
    }
    return loaded;
}

/// The calling thread and those that it starts: input and drawing come first.
void yieldToOthers() {
#ifdef __linux__
    constexpr int kNice = 10;
    setpriority(PRIO_PROCESS, 0, kNice);  // on Linux of the thread alone; without effect at worst
#endif
}

}  // namespace

std::string Loader::doing() const {
    if (packing_.busy()) return "Changing the relief";
    if (!loading_.busy()) return "";
    return share() >= 0.0 ? "Surveying the map" : task_;
}

// The progress of the work that begins: it outlives the loader's interest in it.
MapProgress Loader::begin(const char* task, const std::string& path) {
    task_ = task;
    path_ = path;
    progress_ = std::make_shared<Progress>();
    return [progress = progress_](const std::string&, double share) {
        progress->share = share;
        return !progress->cancelled;
    };
}

void Loader::read(const std::string& path, const std::optional<Edits>& kept, double exaggeration, Levels levels) {
    loading_.start([=, open = open_, progress = begin("Loading", path)] {
        provideSample(path);
        const Scene original = open(path);
        return load(path, original, kept.value_or(noEdits(original, exaggeration)), exaggeration, levels, !kept,
                    progress);
    });
}

void Loader::remake(const Document& document, const Edits& edits, Levels levels) {
    loading_.start([path = document.path, original = document.original, edits, levels,
                    progress = begin("Loading", document.path)] {
        return Loaded{makeDocument(path, original, edited(original, edits), levels, false, progress), edits, {}};
    });
}

void Loader::complete(const Document& document, const Edits& edits, Levels levels) {
    const bool shaders = document.stand_in.has_value();
    loading_.start([path = document.path, original = document.original, edits, levels, shaders, warm_up = warm_up_,
                    progress = begin(shaders ? "Preparing the full light" : "Preparing the map", document.path)] {
        yieldToOthers();
        const Scene scene = edited(original, edits);
        std::future<void> warm;
        if (shaders) warm = std::async(std::launch::async, warm_up, traitsOf(scene));
        Loaded loaded{makeDocument(path, original, scene, levels, false, progress), edits, {}};
        if (shaders) warm.get();
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
