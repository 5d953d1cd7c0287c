#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dsphere::viewer {

/// The files that were opened last, kept from one start to the next: $XDG_STATE_HOME/dsphere/recent, else
/// ~/.local/state/dsphere/recent, a path a line.
class RecentFiles {
  public:
    static constexpr std::size_t kMost = 8;

    RecentFiles();

    /// The newest first; those that are gone are left out.
    std::vector<std::string> list() const;
    /// Writes the file; one that cannot be written is not worth a message.
    void add(const std::string& path);

  private:
    std::filesystem::path file_;  ///< empty: there is no place for it
    std::vector<std::string> paths_;
};

/// Scenes that need no file of the user's.
struct Sample {
    const char* name;
    const char* tells;
};
inline constexpr Sample kSamples[] = {
    {"Moon", "A cratered moon, made now: some seconds"},
    {"Fractal planet", "Mountains and plains, coloured by height"},
    {"Ripples", "A closed form without a map, as sharp as one looks"},
};

/// Where the sample's scene lies, in the cache folder.
std::string samplePath(std::size_t sample);
bool isSample(const std::string& path);
/// Writes the scene of that name and its map, if it is a sample's and they are not there yet. Throws Error.
void provideSample(const std::string& path);

}  // namespace dsphere::viewer
