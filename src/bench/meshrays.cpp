#include "bench/meshrays.h"

#include "base/error.h"
#include "reference/camera.h"
#include "render/raster.h"

namespace dsphere::bench {

RaySet cameraRays(const Workload& workload, const View& view, const std::vector<std::uint32_t>& order) {
    const dmat4 object_from_world = glm::inverse(workload.scene.shapes[0].world_from_object);
    const double unit = workload.maps.reliefs[0].greatest_radius;
    const Box box = cropBox(view.film);
    RaySet rays;
    for (std::uint32_t i : order) {
        const int x = int(i) % box.width(), y = int(i) / box.width();
        const reference::CameraRay ray =
            reference::cameraRay(view.camera, view.film, box.x0 + x + 0.5, box.y0 + y + 0.5);
        rays.add(transformPoint(object_from_world, ray.origin) / unit,
                 transformVector(object_from_world, ray.direction) / unit);
    }
    rays.fillPackets();
    return rays;
}

void requireNodes(const Workload& workload) {
    if (workload.maps.maps[0]->ripples || workload.maps.reliefs[0].filter != Filter::Bilinear)
        throwInvalid("{}: meshes have the nodes of bilinear maps; for B-splines and ripples take --methods exact,naive",
                     workload.map);
}

}  // namespace dsphere::bench
