#pragma once

#include "surface/colourmap.h"
#include "surface/heightmap.h"

#include <memory>
#include <vector>

namespace dsphere {

/// The heightmaps and images of a scene, each distinct one loaded once, and what each shape makes of its map.
struct SceneMaps {
    std::vector<std::unique_ptr<Heightmap>> maps;
    std::vector<int> map_of_shape;  ///< index in `maps`; -1 for shapes that are no displaced sphere
    std::vector<Relief> reliefs;    ///< one a shape; defaults for shapes without a map
    std::vector<std::unique_ptr<ColourMap>> images;
    std::vector<int> image_of_shape;  ///< index in `images`, -1: no image; may be shorter than the shapes
    int light_image = -1;             ///< index in `images` of the infinite light's, -1: it has none
    std::uint64_t memory_limit = 0;   ///< loadSceneMaps'
    bool coarse = false;              ///< loadCoarseMaps(): some map is a coarse one

    /// Those of all maps, in the maps' order.
    Notices notices() const;
    /// One pointer a shape, nullptr without a map.
    std::vector<const Heightmap*> perShape() const;
    /// The image of a shape's texture, or nullptr.
    const ColourMap* image(std::size_t shape) const;
    /// One pointer a shape, nullptr without an image.
    std::vector<const ColourMap*> imagePerShape() const;
    /// The infinite light's image, or nullptr.
    const ColourMap* lightImage() const { return light_image < 0 ? nullptr : images[std::size_t(light_image)].get(); }
};

/// Loads every map and image of the scene; what is wrong with several comes in one error. Errors as loadHeightmap,
/// makeRelief and loadColourMap, prefixed by the place in the scene of the shape or the image's name; also for an
/// infinite light's image that is square or negative.
///
/// `memory_limit`: bytes that a map and its copy on the device may take together, else it stays in its file (see
/// loadHeightmap), and that heights on the device take at most; 0: as many as are there.
SceneMaps loadSceneMaps(const Scene& scene, std::uint64_t memory_limit = 0, const MapProgress& progress = {});

/// Whether loadSceneMaps() leaves one of the maps in its file; see staysInFile().
bool anyMapStaysInFile(const Scene& scene, std::uint64_t memory_limit = 0);

/// To look at meanwhile: like loadSceneMaps(), but with loadCoarseHeightmap() in place of each map that has yet to be
/// surveyed.
SceneMaps loadCoarseMaps(const Scene& scene);

}  // namespace dsphere
