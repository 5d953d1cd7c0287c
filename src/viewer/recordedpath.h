#pragma once

#include "scene/motion.h"

#include <filesystem>
#include <optional>
#include <string>

namespace dsphere::viewer {

/// Keys of the camera as the viewer records them: a path file for `dsphere render --path`.
class RecordedPath {
  public:
    static constexpr int kRate = 30;  ///< frames a second when it is played
    static constexpr int kStep = 60;  ///< frames from key to key

    RecordedPath() = default;
    /// Of a file's text; unset if it is no path file or has other columns than those that are recorded.
    static std::optional<RecordedPath> parse(std::string text, const std::string& name);

    const std::string& text() const { return text_; }
    int keys() const { return motion_ ? motion_->keys() : 0; }
    double lastFrame() const { return motion_ ? motion_->lastFrame() : 0.0; }
    /// The camera of a frame, as `render --path` makes it; there is a key.
    Camera at(const Scene& scene, double frame) const;

    /// A line for the file that makes this camera the next key. A file's first key decides its columns: places above
    /// the scene's only displaced sphere, else the eye and a point that it looks at, `distance` ahead. Error (Usage)
    /// when the columns cannot say the camera.
    std::string lineOf(const Scene& scene, const Camera& camera, double distance) const;
    /// With that line behind the others.
    RecordedPath with(const std::string& line) const;
    /// Without its last line; unset if that is another.
    std::optional<RecordedPath> without(const std::string& line) const;

  private:
    std::string text_;  ///< empty: no key
    std::optional<Motion> motion_;
};

/// Whether a picture would show the same: rounding is left aside.
bool sameView(const Camera& a, const Camera& b);

/// Where the keys of a scene's camera are kept.
struct PathFile {
    std::filesystem::path path;
    RecordedPath keys;
    std::filesystem::path passed_over;  ///< a file of the first choice's name that holds something else; empty: none
};

/// SCENE-path.csv in that folder, else SCENE-path-2.csv and so on: the first that is not there or is a recorded path.
PathFile findPathFile(const std::filesystem::path& folder, const std::string& scene);

/// Writes the keys, or removes the file when there are none. Error (Failure).
void writePathFile(const PathFile& file);

}  // namespace dsphere::viewer
