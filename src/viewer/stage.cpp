#include "viewer/stage.h"

#include <chrono>
#include <cmath>

#include "base/error.h"
#include "gpu/device.h"
#include "render/marchpipeline.h"
#include "viewer/schedule.h"

namespace dsphere::viewer {

namespace {

constexpr std::size_t kStillFilm = 0, kDraftFilm = 1;

}  // namespace

Stage::Stage(gpu::Device& device, std::unique_ptr<Document> document, const MarchMethod& method)
    : device_(device),
      document_(std::move(document)),
      renderer_(device, document_->packed, document_->drawn(), method),
      method_(method) {
    if (document_->provisional()) return;  // the first picture needs all cores
    translating_ = makeAhead(device_, document_->packed.traits, draftMethod(method_), planesOf(Show::Colour));
}

void Stage::setCamera(const Camera& camera, int width, int height) {
    Scene& scene = document_->drawn();
    scene.camera = camera;
    scene.film.width = width;
    scene.film.height = height;
    scene.film.crop = {0.0, 1.0, 0.0, 1.0};
    renderer_.setCamera(scene);
}

void Stage::updateLook(const Scene& scene) {
    Scene& shown = document_->scene;
    shown.lights = scene.lights;
    for (std::size_t i = 0; i < shown.shapes.size(); ++i) shown.shapes[i].material = scene.shapes[i].material;
    renderer_.setLook(shown, document_->maps);
}

void Stage::updateRelief(PackedScene packed, const Scene& scene) {
    Document& document = *document_;
    document.packed = std::move(packed);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) document.scene.shapes[i] = scene.shapes[i];
    document.scene.lights = scene.lights;
    document.locate();
    for (auto& film : films_) film.reset();  // they may hold pipelines that go
    renderer_.setPacking(document.packed);
    renderer_.setCamera(document.scene);
}

// The cheapest way. Levels of detail are held, so that drafts wait for no heights from files.
MarchMethod Stage::draftMethod(MarchMethod method) const {
    method.shadows = false;
    const bool whole = method.marcher == Marcher::Exact && method.detail == 0.0f;
    if (whole && document_->hasMapsInFiles()) method.detail = 1.0f;
    return method;
}

bool Stage::makeRoom(std::size_t film, std::uint32_t mask, int width, int height) {
    std::optional<ProgressiveFilm>& room = films_[film];
    if (room && room->fits(mask, width, height)) return false;
    room.reset();
    room.emplace(device_, renderer_, width, height, mask);
    return true;
}

bool Stage::prepareFilm(Show show, bool draft, int width, int height) {
    film_in_use_ = draft ? kDraftFilm : kStillFilm;
    return makeRoom(film_in_use_, planesOf(show), width, height);
}

// Pictures without light have no shadows to leave out. Shaders of a stand-in have to be made quickly: they have none.
void Stage::begin(const ViewSettings& view, Sampling sampling, bool shadows) {
    shadows_ = (shadows && !document_->stand_in) || (planesOf(view.show) & kColourPlanes) == 0;
    const int width = renderer_.crop().width();
    const int middle = view.split ? std::clamp(int(std::lround(view.divider * width)), 0, width) : 0;
    std::vector<FilmPart> parts;
    if (middle > 0) parts.push_back({Marcher::Naive, 0, middle});
    if (middle < width) parts.push_back({view.method, middle, width});
    for (FilmPart& part : parts) part.method.shadows = shadows_;
    const bool quick = film_in_use_ == kDraftFilm && !view.split && document_->hasMapsInFiles();
    if (quick) parts.front().method = draftMethod(view.method), shadows_ = false;
    film().begin(parts, sampling, std::uint32_t(document_->scene.sampler.seed));
}

void Stage::makeDraftsReady(const ViewSettings& view) {
    if (!translating_.valid() || translating_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    translating_.get();
    if (view.method != method_ || view.show != Show::Colour) return;
    const auto least = [](int side) { return int(std::ceil(Schedule::kLeastScale * side)); };
    const ProgressiveFilm& still = *films_[kStillFilm];
    makeRoom(kDraftFilm, planesOf(Show::Colour), least(still.mostWidth()), least(still.mostHeight()));
    films_[kDraftFilm]->prepare(draftMethod(method_));
}

std::optional<Pick> Stage::pick(const dvec2& share) {
    if (!picker_) picker_.emplace(device_, renderer_);
    const Box& crop = renderer_.crop();
    return picker_->at(int(std::floor(share.x * crop.width())), int(std::floor(share.y * crop.height())));
}

void warmUp(gpu::Device& device, const std::string& selector, const SceneTraits& traits, const MarchMethod& method) {
    const std::uint32_t mask = planesOf(Show::Colour);
    std::future<void> made;
    if (!runsOnCpu(device)) {
        made = makeAhead(device, traits, method, mask);
        if (made.valid()) made.get();
        return;
    }
    try {
        gpu::Device other({selector, false, nullptr});
        made = warmAhead(other, traits, method, mask);
        if (made.valid()) made.get();
    } catch (const Error&) {
        // The window's own device will make them, or say why not.
    }
}

}  // namespace dsphere::viewer
