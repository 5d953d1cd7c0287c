#include "bench/views.h"

#include "scene/transforms.h"

namespace dsphere::bench {

// The camera of the last stands just above the highest peak and looks along the ground.
std::span<const StandardView> standardViews() {
    static const StandardView kViews[] = {{"whole planet", "whole", {2.4, 1.2, 1.6}, {0.0, 0.0, 0.0}, 45.0},
                                          {"limb", "limb", {1.25, 0.35, 0.2}, {0.3, 0.85, -0.35}, 35.0},
                                          {"horizon", "horizon", {0.0, 0.3515, 0.9407}, {0.9, 0.25, 0.75}, 60.0}};
    return kViews;
}

Camera cameraOf(const StandardView& view, double greatest_radius) {
    Camera camera;
    camera.camera_from_world =
        lookAtMatrix(view.eye * greatest_radius, view.target * greatest_radius, dvec3(0.0, 1.0, 0.0)).value();
    camera.fov_degrees = view.fov;
    return camera;
}

}  // namespace dsphere::bench
