#pragma once

#include "query/engine.h"
#include "query/suns.h"
#include "render/renderer.h"

#include <array>
#include <vector>

namespace dsphere::query {

/// Texels in longitude and latitude, degrees; row 0 in the north.
struct BakeGrid {
    int width = 0, height = 0;
    double west = -180.0, east = 180.0, south = -90.0, north = 90.0;

    double longitude(double i) const { return west + (i + 0.5) * (east - west) / width; }  ///< of a texel's centre
    double latitude(double j) const { return north - (j + 0.5) * (north - south) / height; }
    std::size_t count() const { return std::size_t(width) * std::size_t(height); }
};

/// What holds at the surface of a scene's body, its first displacedsphere, texel by texel: one plane a quantity,
/// row-major. Rays start 1e-6 R above the ground, straight above it, and meet all shapes of the scene.
class Baker {
  public:
    /// What is given must outlive it. Error (InvalidInput) if the scene has no displacedsphere.
    Baker(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const PackedScene& packed,
          const DeviceScene& device_scene, const BakeGrid& grid, const Progress& progress);

    /// The map's value.
    std::vector<float> height() const;
    /// Degrees. Where patches meet, slopes are the mean of both sides.
    std::vector<float> slope() const;
    /// Where the ground falls to: degrees clockwise from north; NaN where it is flat.
    std::vector<float> aspect() const;
    /// One axis, 0 to 2, of the unit normal in the body's space.
    std::vector<float> normal(int axis) const;
    /// The share of the sun's disc that is seen, of so many samples; of a point that is seen or not, one will do.
    std::vector<float> lit(const Sun& sun, int samples);
    /// The share of the upper half space that is seen, weighed by the cosine from the vertical, of so many samples.
    std::vector<float> sky(int samples);
    /// The elevation of the horizon at an azimuth (clockwise from north), degrees, right to within `bound`. Proven by
    /// rays: one below is blocked, one above is free, and a body is solid from its centre to its ground, so that it
    /// blocks every ray below one that it blocks. Error (InvalidInput) if the scene has more shapes.
    std::vector<float> horizon(double azimuth, double bound);

    /// Red, green and blue: the direct light that a camera straight above sees, as `render` shades it, the mean of four
    /// points a hundredth of a texel to the sides. Lights with an extent, or image skies, are sampled `samples` times.
    std::array<std::vector<float>, 3> colour(int samples);

    /// What the body's map says of its values.
    const MapFacts& facts() const { return *body_->facts; }
    /// Rays traced so far.
    std::uint64_t rays() const { return rays_; }

  private:
    struct Ground;

    Ground groundAt(int i, int j) const;
    template <typename Value>
    std::vector<float> mapped(Value value) const;
    /// Where the rays of a row of texels start, object space.
    std::vector<dvec3> startsOf(int row) const;
    /// Straight down at a place between texel centres.
    QueryRay rayDown(double i, double j) const;
    dvec3 up(int i, int j) const;
    dvec3 inLocalAxes(int i, int j, const dvec3& east_north_up) const;
    /// free(k): ray k of the source meets nothing.
    template <typename Source>
    std::vector<std::uint8_t> freeRays(std::size_t count, const Source& source);
    void report(int row);
    /// Error (Interrupted) when the caller says stop.
    void alive() const;

    gpu::Device& device_;
    const Scene& scene_;
    const SceneMaps& maps_;
    const PackedScene& packed_;
    const DeviceScene& device_scene_;
    const ShapeFrame* body_ = nullptr;
    BakeGrid grid_;
    const Progress& progress_;
    double share_ = 0.0;  ///< of the plane that is done
    Engine engine_;
    std::vector<dvec2> meridians_, parallels_;  ///< sine and cosine, of each column's longitude, each row's latitude
    std::uint64_t rays_ = 0;
};

}  // namespace dsphere::query
