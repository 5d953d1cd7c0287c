#pragma once

#include "geo/largemap.h"
#include "image/rawmap.h"
#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace dsphere {

class TiledHeights;

/// Node values of a reconstruction that is watertight at the seam and the poles, in the file's stored units, counted
/// from `zero`.
///
/// Texel registration: node (i, j) stands at u = (i + 0.5) / width, v = (j + 0.5) / height, and the poles are two
/// further nodes whose value is the mean of the first (last) row. Gridline: node (i, j) at u = i / width,
/// v = j / (height - 1); the first and last rows are replaced by their means, which are the pole values.
struct Heightmap {
    int width = 0, height = 0;
    Registration registration = Registration::Texel;
    double longitude_origin = -180.0;  ///< degrees; the u of the left edge is (longitude_origin + 180) / 360
    double full_scale = 1.0;           ///< the stored value that means h = 1 unless the scene says otherwise
    /// The stored value from which samples, poles, extremes and the survey count: 0, but the least where all values lie
    /// far from 0 for their range: floats of such values times a scale would lose the bits that tell them apart.
    /// Whatever is made of the map (grids, bounds, patches, the reference) counts from it too.
    double zero = 0.0;
    std::vector<float> samples;  ///< row-major, first row northmost; all finite; empty where `tiled` is set
    /// Of a map that stays in its file: the samples' place.
    std::shared_ptr<const TiledHeights> tiled;
    float north_pole = 0.0f, south_pole = 0.0f;
    float least = 0.0f, greatest = 0.0f;  ///< of all samples, from `zero` as they are
    std::size_t nodata_count = 0;         ///< texels that held the shape's nodata value, before they were filled
    std::string path, type;
    MapFacts facts;
    Notices notices;                 ///< the reader's, and those of what was made of the map
    std::optional<Ripples> ripples;  ///< the closed form that takes the samples' place, 0 to 1

    /// What the file holds, of a sample or of what lies between samples.
    double stored(double sample) const { return zero + sample; }
    double storedLeast() const { return stored(least); }
    double storedGreatest() const { return stored(greatest); }
    /// What means h = 1 where the map's own range is drawn: a map of one value alone lies at h = 0.
    double ownTop() const { return greatest > least ? storedGreatest() : storedLeast() + 1.0; }

    float at(int i, int j) const {
        return tiled ? tiledAt(i, j) : samples[std::size_t(j) * std::size_t(width) + std::size_t(i)];
    }

  private:
    float tiledAt(int i, int j) const;
};

/// Called while a map that stays in its file is read for the first time: its path, and the share that is done. False:
/// stop, with an Error (Interrupted).
using MapProgress = std::function<bool(const std::string& path, double share)>;

/// Reads the shape's map, prepares it (prepareMap), fills its unknown texels (fillNodata), then blurs it (blurMap),
/// then forms the poles; applies its registration and longitude origin (the scene's, else the file's own, else texel
/// and -180). An empty map path gives a 1x1 map of 0. Throws Error (InvalidInput): unreadable file, nothing but unknown
/// texels, gridline registration with fewer than 2 rows.
///
/// A map of more texels than `most_held` stays in its file (`tiled`) where its format lets it, and the shape does not
/// blur it by more than kMostTiledBlur. One of more than kWidestHeldMap columns is cut into tiles as well
/// (`tiled`), in memory, under the same conditions.
Heightmap loadHeightmap(const DisplacedSphere& shape, std::uint64_t most_held = geo::kLargeMapTexels,
                        const MapProgress& progress = {});

/// Whether loadHeightmap() leaves the map in its file, as far as the file's head tells. Quick, and without errors: a
/// file that cannot be read does not stay.
bool staysInFile(const DisplacedSphere& shape, std::uint64_t most_held = geo::kLargeMapTexels);

/// The map of kCoarseColumns columns that stands in for a map that stays in its file until that is surveyed, which
/// takes seconds. Unset: the map is small, or was surveyed before. Errors as loadHeightmap has them.
std::optional<Heightmap> loadCoarseHeightmap(const DisplacedSphere& shape);
inline constexpr int kCoarseColumns = 1024;

/// Of a map in its file. As loadHeightmap.
Heightmap makeTiledHeightmap(std::shared_ptr<const geo::LargeMap> source, const DisplacedSphere& shape,
                             const MapProgress& progress = {});

/// loadHeightmap() from samples already in memory (tests, generated maps).
Heightmap makeHeightmap(RawMap raw, const DisplacedSphere& shape);

/// How a map given in place of a scene is drawn when it knows its radius and its unit: heights in proportion to the
/// radius, exaggerated by a round number so that they span some 5 % of it (maxdispl 5), and never less than they are.
struct TrueScale {
    double exaggeration = 1.0;
    double height_scale = 0.0, midlevel = 0.0;  ///< as a scene would say them
};

/// Unset: the scene says how heights are drawn, or the map does not know its radius and unit.
std::optional<TrueScale> trueScaleOf(const DisplacedSphere& shape, const Heightmap& map);
Notice exaggerationNote(const TrueScale& scale, const Heightmap& map);

/// The displaced sphere: r = base + scale * sample, object units, a sample being a stored value less the map's `zero`.
struct Relief {
    double base = 1.0;                                 ///< object units
    double scale = 0.0;                                ///< object units per stored unit; may be negative
    double least_radius = 1.0, greatest_radius = 1.0;  ///< over all nodes, object units
    double h_scale = 1.0, h_offset = 0.0;              ///< h = h_offset + h_scale * sample
    Filter filter = Filter::Bilinear;                  ///< how heights run between the map's
    bool smooth_normals = false;                       ///< shading normals are the B-spline's, unlike the filter
};

/// Combines shape and map. Throws Error (InvalidInput), prefixed by `where`, when heightmin = heightmax, when r <= 0
/// at some texel (names its column, row, latitude, longitude and the radius), or when r exceeds limits::kReach radii.
Relief makeRelief(const DisplacedSphere& shape, const Heightmap& map, const SourceLocation& where);

}  // namespace dsphere
