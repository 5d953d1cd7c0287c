#include "cli/outputs.h"

#include "base/atomicfile.h"
#include "base/error.h"

#include <sys/stat.h>
#include <unistd.h>

#include <optional>

namespace dsphere::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardStream = "-";

/// What makes two files one.
struct Identity {
    dev_t device;
    ino_t inode;
    bool operator==(const Identity&) const = default;
};

/// Of a regular file; nothing else can be replaced.
std::optional<Identity> identityOf(const struct stat& found) {
    if (!S_ISREG(found.st_mode)) return {};
    return Identity{found.st_dev, found.st_ino};
}

std::optional<Identity> inputIdentity(const fs::path& path) {
    struct stat found = {};
    const int failed = path == kStandardStream ? fstat(STDIN_FILENO, &found) : stat(path.c_str(), &found);
    return failed ? std::nullopt : identityOf(found);
}

std::optional<Identity> outputIdentity(const fs::path& path) {
    struct stat found = {};
    return stat(path.c_str(), &found) == 0 ? identityOf(found) : std::nullopt;
}

/// What is equal for two names of a file that does not exist yet.
fs::path placeOf(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(resolveLinks(path), ignored), ignored);
}

void checkWritable(const fs::path& path) {
    checkReplaceable(path);
    const fs::path target = resolveLinks(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        throwFailure("{}: the folder {} does not exist", path.string(), folder.string());
    if (access(folder.c_str(), W_OK) != 0)
        throwFailure("{}: the folder {} cannot be written to: {}", path.string(), folder.string(), lastSystemError());
}

void requireOtherThan(const NamedFile& output, const std::vector<NamedFile>& inputs) {
    const std::optional<Identity> identity = outputIdentity(output.path);
    if (!identity) return;
    for (const NamedFile& input : inputs)
        if (inputIdentity(input.path) == identity)
            throw Error(
                ExitCode::Usage,
                fmt::format("{}: {} would replace {}, which is {} of this run", output.path.string(), output.what,
                            input.path == kStandardStream ? "standard input" : input.path.string(), input.what));
}

}  // namespace

std::vector<NamedFile> inputsOf(const Scene& scene) {
    std::vector<NamedFile> files;
    for (const std::string& path : scene.included) files.push_back({path, "an included file"});
    for (const Shape& shape : scene.shapes) {
        if (const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry); sphere && !sphere->map_path.empty())
            files.push_back({sphere->map_path, "a heightmap"});
        if (const auto* image = textureAs<ImageMap>(shape.material)) files.push_back({image->path, "an image"});
    }
    for (const Light& light : scene.lights)
        if (const auto* infinite = std::get_if<InfiniteLight>(&light); infinite && !infinite->map_path.empty())
            files.push_back({infinite->map_path, "a light's image"});
    files.push_back({scene.name, "the scene"});  // the heightmap where that stands in for one
    return files;
}

void checkOutputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs) {
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const NamedFile& output = outputs[k];
        if (output.path == kStandardStream) continue;
        requireOtherThan(output, inputs);
        checkWritable(output.path);
        for (std::size_t other = 0; other < k; ++other) {
            const auto identity = outputIdentity(output.path);
            const bool same = identity ? identity == outputIdentity(outputs[other].path)
                                       : placeOf(output.path) == placeOf(outputs[other].path);
            if (same)
                throwUsage("{}: {} and {} name the same file", output.path.string(), outputs[other].what, output.what);
        }
    }
}

}  // namespace dsphere::cli
