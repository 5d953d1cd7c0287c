#pragma once

// What a parse carries from directive to directive. Internal to the parser.

#include "scene/diagnostics.h"
#include "scene/lexer.h"
#include "scene/parameters.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// One file being read; a directive lies within one file.
struct Source {
    Lexer lexer;
    std::filesystem::path folder;  ///< relative paths in the file start here
    int depth = 0;                 ///< Includes around it
    std::string how_to_get{};      ///< the files that the current directive names: the text's own `# get:`
};

/// What AreaLightSource says of the shapes that follow.
struct Emission {
    dvec3 radiance{1.0};
    bool two_sided = false;
};

/// The parameters that Attribute gives to the directives that follow, by target; shared by the blocks that saved them.
struct Defaults {
    using List = std::shared_ptr<const std::vector<Parameter>>;

    List shape, light, material, texture;
};

/// What AttributeBegin saves; TransformBegin saves the transform alone.
struct Attributes {
    dmat4 ctm{1.0};
    Material material;
    std::optional<Emission> emission;
    bool reversed = false;  ///< by ReverseOrientation
    Defaults defaults;
};

struct OpenBlock {
    std::string_view opened_by;  ///< "AttributeBegin" or "TransformBegin"
    Attributes saved;
    SourceLocation where;
};

enum class Part { Options, World, Ended };  ///< before WorldBegin, after it, after WorldEnd

/// What failed earlier: mistakes that follow from it are not told.
struct Recovery {
    bool world_assumed = false;    ///< a directive of the world came without WorldBegin
    bool blocks_unsound = false;   ///< some AttributeBegin or End was wrong
    bool file_missing = false;     ///< an Include failed: names may be defined there
    bool objects_refused = false;  ///< ObjectBegin was
};

struct ParseState {
    Scene scene;
    Report report;
    Recovery recovery;
    std::filesystem::path folder;  ///< of the scene's first file: paths are sought there second
    Part part = Part::Options;
    Attributes attributes;
    std::vector<OpenBlock> blocks;
    std::map<std::string, SourceLocation, std::less<>> given;  ///< directives that may stand only once
    std::map<std::string, Material, std::less<>> materials;    ///< by name
    std::map<std::string, Texture, std::less<>> textures;  ///< by name; products are cut to [0, 1] by who takes them
    std::map<std::string, dmat4, std::less<>> coordinate_systems;  ///< by name
    std::set<std::string, std::less<>> media;                      ///< names of those that were refused
    bool transformed = false;                                      ///< a transform stood before Camera
    std::optional<int> default_seed;                               ///< Option's
    std::size_t triangles = 0;                                     ///< of all meshes so far
    int includes = 0;                                              ///< Include directives met so far
    std::size_t bytes = 0;                                         ///< of all files so far
};

}  // namespace dsphere
