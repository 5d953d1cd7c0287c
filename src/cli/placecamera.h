#pragma once

#include "cli/sceneoptions.h"
#include "surface/scenemaps.h"

namespace dsphere::cli {

/// --lookat-latlon, --heading and --pitch: moves the camera to a place above the ground of the first displaced sphere.
/// Without them nothing. Error (Usage) for values out of range and a scene without a displaced sphere.
void placeCamera(Scene& scene, const SceneMaps& maps, const SceneOptions& options);

/// What is to be said of where the camera ended up; see reference::warnOfBuriedEye.
void printCameraNotices(const Scene& scene, const SceneMaps& maps);

}  // namespace dsphere::cli
