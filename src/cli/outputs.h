#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dsphere::cli {

/// A file that a run reads or writes.
struct NamedFile {
    std::filesystem::path path;  ///< "-": standard input or output
    std::string what;            ///< for messages: "the scene", "a heightmap", "--outfile"
};

/// What rendering the scene reads: its own file, what it includes, its maps and images.
std::vector<NamedFile> inputsOf(const Scene& scene);

/// To be called before any work is done. Error (Usage) if an output would replace an input or another output: they
/// count as one file when they are by device and inode, whatever their names and links. Error (Failure) if an output
/// could not be written: its folder is missing or read-only, or what is there must not be replaced.
void checkOutputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);

}  // namespace dsphere::cli
