#pragma once

// What the shaders of shade_paths look up, computed in double: docs/light.md.

#include "scene/scene.h"
#include "surface/scenemaps.h"

#include <map>
#include <vector>

namespace dsphere {

/// Everything that is looked up, and where it lies in `values`. Holds as long as maps, materials' roughness and the
/// pixel filter stay.
struct PathTables {
    struct Loss {
        int place;
        double mean;  ///< 2 int loss c dc
    };

    std::vector<float> values;      ///< first the pixel filter, unless it is a box
    std::map<double, Loss> losses;  ///< of conductors, by GGX's alpha
    int light_image = -1;           ///< place of the infinite light's distribution
    double light_luminance = 0.0;   ///< mean over all directions of its image
};
/// Empty for a scene that needs none.
PathTables makePathTables(const Scene& scene, const SceneMaps& maps);

/// Of GGX facets that reflect all: the share of light that they do not reflect at once.
struct FacetLoss {
    std::vector<float>
        by_cosine;      ///< at cosines (i / LOSS_INTERVALS)^2, i from -1 to LOSS_INTERVALS + 1, the ends prolonged
    double mean = 0.0;  ///< 2 int loss c dc
};
FacetLoss facetLoss(double alpha);

/// Fresnel's reflectance of a conductor, one channel, `cosine` in [0, 1].
double fresnelOf(double cosine, double eta, double k);

/// The distribution that texels of an equirectangular image are drawn by: cumulative, of the rows (height + 1 values),
/// then each row's own (width + 1 values); and the texels' densities over the unit square.
std::vector<float> imageDistribution(const ColourMap& image);

}  // namespace dsphere
