#pragma once

#include <string>
#include <vector>

namespace dsphere::viewer {

/// What a path that is being typed may go on as.
struct PathCompletions {
    std::vector<std::string>
        paths;           ///< at most 200, folders first with a slash at the end; in the spelling of the text
    std::string common;  ///< the longest text that all of them begin with; the text itself without any
};

/// Names that begin as the text does, hidden ones only where a dot was typed. "~/" is the home folder.
PathCompletions completionsOf(const std::string& text);

/// With the home folder in place of "~".
std::string expandedPath(const std::string& text);

}  // namespace dsphere::viewer
