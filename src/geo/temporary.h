#pragma once

#include <filesystem>
#include <string>

namespace dsphere::geo {

/// A file beside its target, for GDAL to write to, that takes the target's place when all is written, or is removed.
class Temporary {
  public:
    /// Error (Failure) when the file cannot be made.
    explicit Temporary(const std::filesystem::path& target);
    ~Temporary();
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const std::string& name() const { return name_; }
    /// Error (Failure) when the target cannot be replaced.
    void commit();

  private:
    std::filesystem::path target_;
    std::string name_;
    bool done_ = false;
};

}  // namespace dsphere::geo
