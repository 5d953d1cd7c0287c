#include "viewer/journal.h"

#include "base/error.h"

namespace dsphere::viewer {

Journal::Journal(const std::string& path) {
    if (path.empty()) return;
    file_.reset(std::fopen(path.c_str(), "w"));
    if (!file_) throwFailure("{}: {}", path, lastSystemError());
}

void Journal::write(const std::string& line) {
    if (!file_) return;
    std::fputs((line + "\n").c_str(), file_.get());
    std::fflush(file_.get());
}

std::string jsonQuoted(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (c == '\n')
            result += "\\n";
        else
            result += c;
    }
    return result + '"';
}

}  // namespace dsphere::viewer
