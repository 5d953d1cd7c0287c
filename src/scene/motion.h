#pragma once

// What moves from frame to frame.

#include "scene/scene.h"
#include "scene/track.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dsphere {

/// Multiplies the displacement of every displaced sphere.
void exaggerate(Scene& scene, double factor);

/// Turns the first distant light so that it stands above this place of the first displaced sphere, or of the first
/// shape where there is none; degrees. Error (Usage) without a distant light.
void placeSun(Scene& scene, double latitude, double longitude);

/// Turns all shapes about the axis of the first displaced sphere (or of the first shape), before a camera and lights
/// that stay: what the camera and the lights see when they go round the other way. Degrees.
void turnTable(Scene& scene, double degrees);

/// The keys of a path file: a table of comma-separated values. Its first line names the columns: frame; eye_x, eye_y,
/// eye_z, look_x, look_y, look_z, up_x, up_y, up_z; lat, lon, alt, heading, pitch, roll; fov; sun_lon, sun_lat;
/// exaggeration; exposure. Each other line is a key of every column that has a value there. Without `frame` they are
/// frames 0, 1, 2...
class Motion {
  public:
    /// Error (InvalidInput) that names file, line and column.
    static Motion read(const std::filesystem::path& path);
    static Motion parse(std::string_view text, const std::string& name);

    /// The scene as it is at that frame. What the file has no column of is as in `scene`. Error (InvalidInput) where
    /// the columns do not fit the scene or a camera cannot be made of them.
    Scene at(const Scene& scene, double frame) const;
    /// In stops; unset: the file does not say.
    std::optional<double> exposureAt(double frame) const;
    int keys() const { return keys_; }
    double lastFrame() const { return last_frame_; }  ///< of the last key

  private:
    enum Column {
        EyeX,
        EyeY,
        EyeZ,
        LookX,
        LookY,
        LookZ,
        UpX,
        UpY,
        UpZ,
        Latitude,
        Longitude,
        Altitude,
        Heading,
        Pitch,
        Roll,
        Fov,
        SunLongitude,
        SunLatitude,
        Exaggeration,
        Exposure,
        kColumns
    };
    friend class MotionReader;

    bool has(Column column) const { return !tracks_[column].empty(); }
    double value(Column column, double frame) const { return tracks_[column].at(frame); }
    dvec3 vector(Column first, double frame) const;
    void moveCamera(Scene& scene, double frame) const;

    std::string name_;
    std::array<Track, kColumns> tracks_;
    int keys_ = 0;
    double last_frame_ = 0.0;
    double least_fov_ = 180.0, greatest_fov_ = 0.0;  ///< of the keys
};

}  // namespace dsphere
