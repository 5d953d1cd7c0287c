#include "render/movingscene.h"

#include <algorithm>

namespace dsphere {

namespace {

bool sameGeometry(const Scene& a, const Scene& b) {
    return std::ranges::equal(a.shapes, b.shapes, {}, &Shape::geometry, &Shape::geometry);
}

/// Whether one takes the other's places on the device.
bool fits(const PackedScene& a, const PackedScene& b) {
    return std::ranges::equal(a.state.objects, b.state.objects, {}, &PackedObject::relief, &PackedObject::relief) &&
           std::ranges::equal(a.reliefs, b.reliefs, {}, &PackedRelief::map, &PackedRelief::map);
}

}  // namespace

MovingScene::MovingScene(MakeRenderer make_renderer, Scene scene, SceneMaps maps, PackedScene packed, Levels levels)
    : make_renderer_(std::move(make_renderer)),
      levels_(levels),
      scene_(std::move(scene)),
      maps_(std::move(maps)),
      packed_(std::move(packed)),
      renderer_(make_renderer_(packed_, scene_)) {}

void MovingScene::change(Scene scene) {
    const bool reshaped = !sameGeometry(scene_, scene), relit = scene_.lights != scene.lights;
    scene_ = std::move(scene);
    if (reshaped) return repack();
    if (relit) renderer_->setLook(scene_, maps_);
    renderer_->setCamera(scene_);
}

// Bounds are those of the displaced surface.
void MovingScene::repack() {
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i)
        if (const auto* sphere = std::get_if<DisplacedSphere>(&scene_.shapes[i].geometry))
            maps_.reliefs[i] =
                makeRelief(*sphere, *maps_.maps[std::size_t(maps_.map_of_shape[i])], scene_.shapes[i].where);
    PackedScene packed = packScene(scene_, maps_, levels_);
    const bool same_places = fits(packed, packed_);
    if (!same_places) renderer_.reset();
    packed_ = std::move(packed);
    if (!same_places) {
        renderer_ = make_renderer_(packed_, scene_);
        return;
    }
    renderer_->setPacking(packed_);
    renderer_->setCamera(scene_);
}

}  // namespace dsphere
