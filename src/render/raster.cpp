#include "render/raster.h"

#include <cmath>

namespace dsphere {

Raster makeRaster(const Camera& camera, const Film& film) {
    Raster raster;
    raster.camera_from_world = camera.camera_from_world;
    raster.width = film.width;
    raster.height = film.height;
    double aspect = camera.frame_aspect_ratio.value_or(double(film.width) / film.height);
    std::array<double, 4> window =
        aspect > 1.0 ? std::array{-aspect, aspect, -1.0, 1.0} : std::array{-1.0, 1.0, -1.0 / aspect, 1.0 / aspect};
    if (camera.screen_window) window = *camera.screen_window;
    bool perspective = camera.projection == Projection::Perspective;
    double spread = perspective ? std::tan(0.5 * camera.fov_degrees * kPi / 180.0) : 1.0;
    raster.projection = camera.projection;
    raster.screen_min = spread * dvec2(window[0], window[2]);
    raster.screen_max = spread * dvec2(window[1], window[3]);

    dmat4 world_from_camera = glm::inverse(camera.camera_from_world);
    dvec2 pixel = (raster.screen_max - raster.screen_min) / dvec2(film.width, film.height);
    dvec3 corner(raster.screen_min.x, raster.screen_max.y, 0.0), ahead(0.0, 0.0, 1.0);
    dvec3 right = transformVector(world_from_camera, dvec3(pixel.x, 0.0, 0.0));
    dvec3 down = transformVector(world_from_camera, dvec3(0.0, -pixel.y, 0.0));
    if (perspective) {
        raster.start = {transformPoint(world_from_camera, dvec3(0.0)), dvec3(0.0), dvec3(0.0)};
        raster.direction = {transformVector(world_from_camera, corner + ahead), right, down};
    } else {
        raster.start = {transformPoint(world_from_camera, corner), right, down};
        raster.direction = {transformVector(world_from_camera, ahead), dvec3(0.0), dvec3(0.0)};
    }
    return raster;
}

dvec2 Raster::project(const dvec3& world) const {
    dvec3 p = transformPoint(camera_from_world, world);
    bool perspective = projection == Projection::Perspective;
    if (perspective && !(p.z > 0.0)) return {0.5 * width, 0.5 * height};
    dvec2 place = (dvec2(p) / (perspective ? p.z : 1.0) - screen_min) / (screen_max - screen_min);
    return {place.x * width, (1.0 - place.y) * height};
}

Box cropBox(const Film& film) {
    auto edge = [](double fraction, int size) { return int(std::ceil(fraction * size)); };
    return {edge(film.crop[0], film.width), edge(film.crop[2], film.height), edge(film.crop[1], film.width),
            edge(film.crop[3], film.height)};
}

}  // namespace dsphere
