#include "viewer/stage.h"

#include <chrono>
#include <cmath>

namespace dsphere::viewer {

namespace {

MarchMethod withoutShadows(MarchMethod method) {
    method.shadows = false;
    return method;
}

}  // namespace

Stage::Stage(gpu::Device& device, std::unique_ptr<Document> document, const MarchMethod& method)
    : device_(device),
      document_(std::move(document)),
      renderer_(device, document_->packed, document_->scene, method),
      method_(method) {
    translating_ = makeAhead(device_, document_->packed.traits, withoutShadows(method_), planesOf(Show::Colour));
}

void Stage::setCamera(const Camera& camera, int width, int height) {
    Scene& scene = document_->scene;
    scene.camera = camera;
    scene.film.width = width;
    scene.film.height = height;
    scene.film.crop = {0.0, 1.0, 0.0, 1.0};
    packCamera(document_->packed, scene);
    renderer_.setCamera(scene);
}

void Stage::updateLook(const Scene& scene) {
    Scene& shown = document_->scene;
    shown.lights = scene.lights;
    for (std::size_t i = 0; i < shown.shapes.size(); ++i) shown.shapes[i].material = scene.shapes[i].material;
    packLook(document_->packed, shown, document_->maps);
    renderer_.update(false);
}

void Stage::updateRelief(PackedScene packed, const Scene& scene) {
    Document& document = *document_;
    document.packed = std::move(packed);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) document.scene.shapes[i] = scene.shapes[i];
    document.scene.lights = scene.lights;
    document.locate();
    packCamera(document.packed, document.scene);
    film_.reset();  // it may hold a pipeline that goes
    renderer_.update(true);
}

bool Stage::prepareFilm(Show show, int width, int height) {
    const std::uint32_t mask = planesOf(show);
    if (film_ && film_->film().mask() == mask && int(film_->film().image().width()) >= width &&
        int(film_->film().image().height()) >= height)
        return false;
    film_.reset();
    film_.emplace(device_, renderer_, width, height, mask);
    return true;
}

void Stage::begin(const ViewSettings& view, Sampling sampling, bool shadows) {
    const int width = renderer_.crop().width();
    const int middle = view.split ? std::clamp(int(std::lround(view.divider * width)), 0, width) : 0;
    std::vector<LivePart> parts;
    if (middle > 0) parts.push_back({Marcher::Naive, 0, middle});
    if (middle < width) parts.push_back({view.method, middle, width});
    for (LivePart& part : parts) part.method.shadows = shadows;
    film_->begin(parts, sampling, std::uint32_t(document_->scene.sampler.seed));
}

void Stage::makeDraftsReady(const ViewSettings& view) {
    if (!translating_.valid() || translating_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    translating_.get();
    if (view.method == method_ && view.show == Show::Colour) film_->prepare(withoutShadows(method_));
}

std::optional<Pick> Stage::pick(const dvec2& share) {
    if (!picker_) picker_.emplace(device_, renderer_);
    const Box& crop = renderer_.crop();
    return picker_->at(int(std::floor(share.x * crop.width())), int(std::floor(share.y * crop.height())));
}

}  // namespace dsphere::viewer
