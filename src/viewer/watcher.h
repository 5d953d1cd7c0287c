#pragma once

#include <filesystem>
#include <vector>

namespace dsphere::viewer {

/// Tells when one of a few files has changed on disk and has then been left alone for a moment.
class Watcher {
  public:
    static constexpr double kInterval = 0.3;  ///< seconds between looks

    void watch(const std::vector<std::filesystem::path>& files);
    /// True once for each change.
    bool changed(double now);

  private:
    using Times = std::vector<std::filesystem::file_time_type>;
    Times look() const;

    std::vector<std::filesystem::path> files_;
    Times known_, last_;
    double next_look_ = 0.0;
};

}  // namespace dsphere::viewer
