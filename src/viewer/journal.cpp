#include "viewer/journal.h"

#include "base/error.h"

#include <nlohmann/json.hpp>

namespace dsphere::viewer {

Journal::Journal(const std::string& path) {
    if (path.empty()) return;
    file_.reset(std::fopen(path.c_str(), "w"));
    if (!file_) throwFailure("{}: {}", path, lastSystemError());
}

void Journal::write(const nlohmann::json& line) {
    if (!file_) return;
    // File names may hold any bytes.
    std::fputs((line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n").c_str(), file_.get());
    std::fflush(file_.get());
}

}  // namespace dsphere::viewer
