#pragma once

#include "surface/scenemaps.h"

#include <string>
#include <vector>

namespace dsphere::bench {

struct View {
    std::string name;
    Camera camera;
    Film film;
};

/// One displaced sphere under one sun, and the views of it.
struct Workload {
    std::string map;            ///< "fractal 4096x2048", or the scene's name
    int width = 0, height = 0;  ///< texels
    double percent = 0.0;       ///< displacement over the radius, as the scene says it or as its heights span
    Scene scene;                ///< film and camera are those of no view
    SceneMaps maps;
    std::vector<View> views;
};

/// The default suite's fractal map, its seed fixed: 16-bit heights, `width` / 2 rows.
RawMap suiteMap(int width);
/// A planet of radius 1 with that map and displacement in percent.
Workload suiteWorkload(RawMap map, double percent);

/// Error (InvalidInput) if the scene has no displaced sphere.
void requirePlanet(const Scene& scene);

/// The first displaced sphere of a scene from its own camera, lit by its first distant light, else by kSun. Error
/// (InvalidInput) without one; errors of loadSceneMaps.
Workload sceneWorkload(Scene scene);

/// The workload's scene with the smooth sphere that lies between its heights: what no method can beat.
Scene smoothScene(const Workload& workload);

}  // namespace dsphere::bench
