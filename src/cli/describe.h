#pragma once

// The parts of a scene as JSON, for `dsphere info`.

#include "scene/scene.h"
#include "surface/scenemaps.h"

#include <nlohmann/json.hpp>

namespace dsphere::cli {

using Json = nlohmann::ordered_json;

Json describeIntegrator(const Integrator& integrator);
Json describePixelFilter(const PixelFilter& filter);
Json describeCamera(const Camera& camera);
Json describeShape(const Scene& scene, const SceneMaps& maps, std::size_t index);
/// An image is told by its index in `maps`.
Json describeLight(const Light& light, const SceneMaps& maps);

}  // namespace dsphere::cli
