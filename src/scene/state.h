#pragma once

// What a parse carries from directive to directive. Internal to the parser.

#include "scene/lexer.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// One file being read; a directive lies within one file.
struct Source {
    Lexer lexer;
    std::filesystem::path folder;  ///< relative paths in the file start here
    int depth = 0;                 ///< Includes around it

    /// The path as this file means it.
    std::string resolve(const std::string& path) const { return (folder / path).string(); }
};

/// What AreaLightSource says of the shapes that follow.
struct Emission {
    dvec3 radiance{1.0};
    bool two_sided = false;
};

/// What AttributeBegin saves; TransformBegin saves the transform alone.
struct Attributes {
    dmat4 ctm{1.0};
    Material material;
    std::optional<Emission> emission;
};

struct OpenBlock {
    std::string_view opened_by;  ///< "AttributeBegin" or "TransformBegin"
    Attributes saved;
    SourceLocation where;
};

enum class Part { Options, World, Ended };  ///< before WorldBegin, after it, after WorldEnd

struct ParseState {
    Scene scene;
    Part part = Part::Options;
    Attributes attributes;
    std::vector<OpenBlock> blocks;
    std::map<std::string, SourceLocation, std::less<>> given;  ///< directives that may stand only once
    std::map<std::string, Material, std::less<>> materials;    ///< by name
    std::map<std::string, Texture, std::less<>> textures;  ///< by name; products are cut to [0, 1] by who takes them
    int includes = 0;                                      ///< Include directives met so far
};

}  // namespace dsphere
