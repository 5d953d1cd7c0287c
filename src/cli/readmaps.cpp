#include "cli/readmaps.h"

#include "cli/terminal.h"

#include <filesystem>
#include <optional>

namespace dsphere::cli {

SceneMaps readMaps(const Scene& scene, const SceneOptions& options, const CommonOptions& common) {
    std::optional<ProgressLine> line;
    return loadSceneMaps(scene, options.memory_limit, [&](const std::string& path, double share) {
        if (!line)
            line.emplace(common.progress, common.quiet, "reading " + std::filesystem::path(path).filename().string());
        return line->update(share);
    });
}

}  // namespace dsphere::cli
