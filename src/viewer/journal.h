#pragma once

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
    void write(const std::string& line);

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
};

/// Text as a JSON string.
std::string jsonQuoted(const std::string& text);

}  // namespace dsphere::viewer
