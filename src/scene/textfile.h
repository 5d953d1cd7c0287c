#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace dsphere {

/// Whether the path names a file that the program was started with open: standard input or a shell's <(...).
bool isOpenDescriptor(const std::filesystem::path& path);

/// What readText() throws when there is more than was asked for.
struct TextTooLong : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The text of a regular file or, if it isOpenDescriptor(), of what flows from it to its end. Throws std::runtime_error
/// with a part of a sentence ("cannot open a.pbrt: No such file or directory") for a folder, FIFO, socket or device
/// (refused at once, since a FIFO without a writer never ends) and an unreadable file; TextTooLong;
/// Error (Interrupted) when a signal comes while nothing flows.
std::string readText(const std::filesystem::path& path, std::size_t most);
std::string readStandardInput(std::size_t most);

}  // namespace dsphere
