#include "scene/heightmapscene.h"

#include "scene/parser.h"

#include <limits>

namespace dsphere {

namespace {

// The eye is 3.41 away: the silhouette of radius 1.05 spans 0.9 of the picture's height.
constexpr const char* kScene = R"(
Scale -1 1 1
LookAt 0.6 1.05 3.19   0 0 0   0 1 0
Camera "perspective" "float fov" 39.5
Integrator "directlighting"
WorldBegin
LightSource "distant" "point3 from" [-2 1.5 2.2] "point3 to" [0 0 0] "rgb L" [4.5 4.5 4.5]
Shape "displacedsphere" "float maxdispl" 5
)";

}  // namespace

Scene heightmapScene(const std::string& map_path) {
    Scene scene = parseScene(kScene, map_path, {});
    auto& planet = std::get<DisplacedSphere>(scene.shapes[0].geometry);
    planet.map_path = map_path;
    planet.own_range = true;
    planet.true_scale = true;
    planet.nodata = std::numeric_limits<double>::quiet_NaN();
    scene.shapes[0].where.line = 0;
    return scene;
}

}  // namespace dsphere
