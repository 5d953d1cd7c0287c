#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace dsphere::viewer {

/// A file with a line a frame, by which tests follow what the window does.
class Journal {
  public:
    /// No file if the name is empty. Error (Failure) if it cannot be made.
    explicit Journal(const std::string& path);

    bool on() const { return file_ != nullptr; }
    void write(const nlohmann::json& line);

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace dsphere::viewer
