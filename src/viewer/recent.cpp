#include "viewer/recent.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>

#include "base/atomicfile.h"
#include "base/cachefolder.h"
#include "base/error.h"
#include "image/generate.h"
#include "image/greymap.h"

namespace dsphere::viewer {

namespace fs = std::filesystem;

namespace {

fs::path stateFolder() {
    const char *state = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
    if (state && fs::path(state).is_absolute()) return fs::path(state) / "dsphere";
    if (home && fs::path(home).is_absolute()) return fs::path(home) / ".local" / "state" / "dsphere";
    return {};
}

void writeText(const fs::path& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

void makeMap(const fs::path& path, MapKind kind) {
    if (fs::exists(path)) return;
    constexpr int kWidth = 2048;
    const MapGenerator generator(kind, kWidth, kWidth / 2, 1);
    writeGreyMap(
        path, kWidth, kWidth / 2, [&](int j, std::span<std::uint16_t> row) { generator.fillRow(j, row); },
        [](double) { return true; });
}

constexpr const char* kView =
    "Scale -1 1 1\nLookAt 2.1 0.9 2.1   0 0 0   0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
    "Film \"rgb\" \"integer xresolution\" 1280 \"integer yresolution\" 720\n"
    "Sampler \"independent\" \"integer pixelsamples\" 16\nIntegrator \"directlighting\"\nWorldBegin\n"
    "LightSource \"distant\" \"point3 from\" [2 1 -0.3] \"rgb L\" [3 3 3]\n";

constexpr const char* kSampleFiles[std::size(kSamples)] = {"moon.pbrt", "fractal.pbrt", "ripples.pbrt"};
constexpr const char* kSampleShapes[std::size(kSamples)] = {
    "Material \"matte\" \"rgb Kd\" [.5 .49 .47]\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"moon.png\" \"float maxdispl\" 3\n",
    "Texture \"by height\" \"spectrum\" \"heightramp\" \"string ramp\" \"terrain\"\n"
    "Material \"matte\" \"texture Kd\" \"by height\"\n"
    "Shape \"displacedsphere\" \"string displacementmap\" \"fractal.png\" \"float maxdispl\" 8\n",
    "Material \"matte\" \"rgb Kd\" [.75 .5 .35]\n"
    "Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\" \"float maxdispl\" 15\n"};

fs::path samplesFolder() {
    const fs::path cache = cacheFolder();
    return (cache.empty() ? fs::temp_directory_path() / "dsphere" : cache) / "samples";
}

/// The number of kSamples where the path is no sample's.
std::size_t sampleOf(const std::string& path) {
    std::size_t sample = 0;
    while (sample < std::size(kSamples) && path != samplePath(sample)) ++sample;
    return sample;
}

}  // namespace

RecentFiles::RecentFiles() {
    const fs::path folder = stateFolder();
    if (folder.empty()) return;
    file_ = folder / "recent";
    std::ifstream text(file_);
    for (std::string line; std::getline(text, line);)
        if (!line.empty()) paths_.push_back(line);
}

std::vector<std::string> RecentFiles::list() const {
    std::vector<std::string> there;
    std::error_code error;
    for (const std::string& path : paths_)
        if (fs::exists(path, error)) there.push_back(path);
    return there;
}

void RecentFiles::add(const std::string& path) {
    std::error_code error;
    const std::string whole = fs::absolute(path, error).lexically_normal().string();
    if (file_.empty() || error || whole.find('\n') != std::string::npos) return;
    std::erase(paths_, whole);
    paths_.insert(paths_.begin(), whole);
    if (paths_.size() > kMost) paths_.resize(kMost);
    std::string text;
    for (const std::string& one : paths_) text += one + "\n";
    try {
        fs::create_directories(file_.parent_path(), error);
        writeText(file_, text);
    } catch (const Error&) {
        file_.clear();
    }
}

std::string samplePath(std::size_t sample) {
    return (samplesFolder() / kSampleFiles[sample]).string();
}

bool isSample(const std::string& path) {
    return sampleOf(path) < std::size(kSamples);
}

void provideSample(const std::string& path) {
    const fs::path folder = samplesFolder();
    const std::size_t sample = sampleOf(path);
    if (sample == std::size(kSamples)) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throwFailure("{}: {}", folder.string(), error.message());
    if (sample == 0) makeMap(folder / "moon.png", MapKind::Moon);
    if (sample == 1) makeMap(folder / "fractal.png", MapKind::Fractal);
    writeText(path, std::string(kView) + kSampleShapes[sample]);
}

}  // namespace dsphere::viewer
