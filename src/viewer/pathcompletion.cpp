#include "viewer/pathcompletion.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace dsphere::viewer {

namespace fs = std::filesystem;

std::string expandedPath(const std::string& text) {
    const char* home = std::getenv("HOME");
    return home && (text == "~" || text.starts_with("~/")) ? home + text.substr(1) : text;
}

PathCompletions completionsOf(const std::string& text) {
    constexpr std::size_t kMost = 200;
    const std::size_t slash = text.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : text.substr(0, slash + 1);
    const std::string begun = text.substr(folder.size());
    std::vector<std::string> folders, files;
    std::error_code error;
    const fs::directory_iterator entries(folder.empty() ? fs::path(".") : fs::path(expandedPath(folder)), error);
    for (const fs::directory_entry& entry : entries) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(begun) || (begun.empty() && name.starts_with("."))) continue;
        std::error_code ignored;
        if (entry.is_directory(ignored))
            folders.push_back(folder + name + "/");
        else
            files.push_back(folder + name);
    }
    std::ranges::sort(folders);
    std::ranges::sort(files);
    PathCompletions result{std::move(folders), text};
    result.paths.insert(result.paths.end(), files.begin(), files.end());
    if (result.paths.empty()) return result;
    result.common = result.paths[0];
    for (const std::string& path : result.paths) {
        const auto [end, other] = std::ranges::mismatch(result.common, path);
        result.common.erase(end, result.common.end());
    }
    result.paths.resize(std::min(result.paths.size(), kMost));
    return result;
}

}  // namespace dsphere::viewer
