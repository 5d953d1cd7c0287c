#include "viewer/watcher.h"

namespace dsphere::viewer {

void Watcher::watch(const std::vector<std::filesystem::path>& files) {
    files_ = files;
    known_ = last_ = look();
}

// A file that is missing, as between the steps of some editors' saving, has the least of times.
Watcher::Times Watcher::look() const {
    Times times;
    for (const auto& file : files_) {
        std::error_code error;
        times.push_back(std::filesystem::last_write_time(file, error));
        if (error) times.back() = std::filesystem::file_time_type::min();
    }
    return times;
}

bool Watcher::changed(double now) {
    if (now < next_look_) return false;
    next_look_ = now + kInterval;
    Times seen = look();
    bool settled = seen == last_;
    last_ = seen;
    if (!settled || seen == known_) return false;
    for (auto time : seen)
        if (time == std::filesystem::file_time_type::min()) return false;
    known_ = seen;
    return true;
}

}  // namespace dsphere::viewer
