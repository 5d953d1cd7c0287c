#pragma once

// Many pictures by one process.

#include "cli/commands.h"
#include "scene/motion.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dsphere::cli {

struct FrameOptions {
    std::string frames;  ///< --frames as it was given
    std::string path;    ///< --path
    int turntable = 0;   ///< frames of a whole turn; 0: none
    bool skip_existing = false;

    bool wanted() const { return !frames.empty() || !path.empty() || turntable != 0; }
};

void addFrameOptions(CLI::App& command, FrameOptions& options);

/// A file's name with one place for a frame's number, as printf has it: %d, or %04d for at least four digits.
class FrameName {
  public:
    /// Error (Usage) when the pattern has no such place, or several.
    explicit FrameName(const std::string& pattern);

    std::filesystem::path of(int frame) const;

  private:
    std::string before_, after_;
    int digits_ = 0;
};

/// Frames first, first + step ... up to last.
struct FrameRange {
    int first = 0, last = 0, step = 1;

    /// Of "A", "A-B" or "A-B:STEP". Error (Usage).
    static FrameRange parse(const std::string& text);
    int count() const { return (last - first) / step + 1; }
};

/// What is rendered and where it goes.
struct FramePlan {
    FrameRange range;
    FrameName name;
    std::optional<Motion> motion;
    int turntable = 0;
    bool skip_existing = false;

    /// Reads the path file. Error (Usage, InvalidInput).
    FramePlan(const FrameOptions& options, const std::string& outfile);
    Scene sceneAt(const Scene& scene, int frame) const;
    /// The frames that are to be rendered.
    std::vector<int> missing() const;
};

struct Frame {
    int number;
    std::filesystem::path path;
    Scene scene;
    std::optional<double> exposure;  ///< stops, from the path file
};

/// Called with the share of the frame that is done; returns true, or throws Error (Interrupted) when it is to end.
using FrameProgress = std::function<bool(double)>;
/// Renders a frame and returns what writes its picture, to be run on another thread beside the next frame's rendering.
using RenderFrame = std::function<std::function<void()>(Frame frame, const FrameProgress& progress)>;

struct FrameCounts {
    int written = 0, skipped = 0;
    double seconds = 0.0;          ///< from the first frame's start until the last is written
    double writing_seconds = 0.0;  ///< of encoding and writing alone
};

/// The notices of many frames, told once: those of the first frame that has any, and how many others have some.
class FrameNotices {
  public:
    void add(int frame, const Notices& notices);
    Notices all() const;

  private:
    Notices first_;  ///< begin with the frame
    int first_frame_ = -1;
    std::set<int> others_;
};

/// Renders and writes the frames `numbers` of the plan in their order, and counts them. When it is interrupted, the
/// frames that are rendered are written, and the Error says which is the first that is missing.
void renderFrames(const FramePlan& plan, const std::vector<int>& numbers, const Scene& scene, ProgressLine& line,
                  FrameCounts& counts, const RenderFrame& render);

}  // namespace dsphere::cli
