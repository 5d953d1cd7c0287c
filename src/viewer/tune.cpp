#include <cmath>
#include <filesystem>

#include "viewer/app.h"

namespace dsphere::viewer {

namespace {

DistantLight* firstSun(Scene& scene) {
    for (Light& light : scene.lights)
        if (auto* distant = std::get_if<DistantLight>(&light)) return distant;
    return nullptr;
}

}  // namespace

std::optional<SunAngles> App::sunAngles() const {
    const Globe& globe = stage_->document().globe();
    const DistantLight* sun = firstSun(const_cast<Scene&>(stage_->document().scene));
    if (!sun) return {};
    double up = glm::dot(sun->direction, globe.north());
    return SunAngles{
        glm::degrees(std::asin(std::clamp(up, -1.0, 1.0))),
        glm::degrees(std::atan2(glm::dot(sun->direction, globe.east()), glm::dot(sun->direction, globe.origin())))};
}

void App::setSun(const SunAngles& angles) {
    const Globe& globe = stage_->document().globe();
    double lat = glm::radians(angles.latitude), lon = glm::radians(angles.longitude);
    DistantLight* sun = firstSun(stage_->document().scene);
    if (!sun) return;
    sun->direction = glm::normalize(std::cos(lat) * (std::cos(lon) * globe.origin() + std::sin(lon) * globe.east()) +
                                    std::sin(lat) * globe.north());
    changeLook(true);
}

void App::changeLook(bool moving) {
    look_changed_ = true;
    viewChanged(moving);
    if (packing_.busy() || loading_.busy()) return;
    stage_->updateLook();
    look_changed_ = false;
}

void App::applyMaterial(const Texture& material) {
    Document& document = stage_->document();
    Texture& present = *textureOf(document.scene.shapes[Globe::shapeOf(document.scene)].material);
    bool images = std::holds_alternative<ImageMap>(material) || std::holds_alternative<ImageMap>(present);
    if (!images) {
        present = material;
        changeLook(true);
        return;
    }
    wanted_scene_ = std::make_unique<Scene>(document.scene);
    *textureOf(wanted_scene_->shapes[Globe::shapeOf(document.scene)].material) = material;
}

std::string App::hoverText() {
    if (!stage_ || !begun_ || drag_ != Drag::None || packing_.busy()) return {};
    std::optional<Pick> pick = stage_->pick(share(window_.cursor()));
    if (!pick) return {};
    const Document& document = stage_->document();
    std::string distance = fmt::format("distance {:.6g}", pick->distance);
    if (pick->shape != int(Globe::shapeOf(document.scene)))
        return fmt::format("shape {}   {}", pick->shape + 1, distance);
    Place place = document.globe().placeOf(pick->point);
    std::string text = fmt::format("{:.4f}° {}  {:.4f}° {}", std::abs(place.latitude), place.latitude < 0.0 ? "S" : "N",
                                   std::abs(place.longitude), place.longitude < 0.0 ? "W" : "E");
    if (place.stored) text += fmt::format("   height {:.6g}", *place.stored);
    return text + "   " + distance;
}

void App::fillUi() {
    ui_.view = view_;
    ui_.tone = tone_;
    ui_.has_picture = presenter_.hasPicture();
    Figures& figures = ui_.figures;
    figures.u = presenter_.u();
    figures.v = presenter_.v();
    figures.busy = loading_.busy() || packing_.busy();
    figures.device = renders_.info().name;
    figures.frame_seconds = frame_seconds_;
    if (!stage_) {
        figures.file = std::filesystem::path(loading_path_).filename().string();
        return;
    }
    const Document& document = stage_->document();
    const Shape& shape = document.scene.shapes[Globe::shapeOf(document.scene)];
    figures.file = std::filesystem::path(document.path).filename().string();
    figures.target_samples = targetSamples();
    figures.moving = schedule_.draft();
    if (begun_) {
        figures.samples = schedule_.draft() ? 0 : stage_->film().samples();
        figures.width = stage_->film().width();
        figures.height = stage_->film().height();
        double seconds = stage_->film().sampleSeconds();
        figures.rays_per_second = seconds > 0.0 ? double(figures.width) * figures.height / seconds : 0.0;
    }
    figures.hover = hoverText();
    ui_.tuning = wanted_tuning_;
    const auto* globe = std::get_if<DisplacedSphere>(&shape.geometry);
    ui_.displaced = globe != nullptr;
    ui_.ripples = globe && globe->ripples;
    const Texture* texture = textureOf(shape.material);
    ui_.material = texture ? std::optional(*texture) : std::nullopt;
    ui_.sun = sunAngles();
    const Material& original = document.original.shapes[Globe::shapeOf(document.original)].material;
    ui_.image.reset();
    if (const auto* image = textureAs<ImageMap>(original)) ui_.image = *image;
}

void App::applyUi() {
    Command command = std::exchange(ui_.command, Command::None);
    if (!stage_) return;
    const bool view_changed = !(ui_.view == view_), tone_changed = !(ui_.tone == tone_);
    view_ = ui_.view;
    tone_ = ui_.tone;
    if (view_changed) viewChanged(false);
    // The shown values are recoloured without a ray, if they are all there.
    if (tone_changed && !view_changed && begun_ && stage_->film().between() && stage_->film().samples() > 0) publish();
    if (!(ui_.tuning == wanted_tuning_)) wanted_tuning_ = ui_.tuning;
    if (view_.method.detail > 0.0f) wanted_tuning_.levels = Levels::All;
    if (ui_.sun && !(*ui_.sun == *sunAngles())) setSun(*ui_.sun);
    const Document& document = stage_->document();
    const Texture* present = textureOf(document.scene.shapes[Globe::shapeOf(document.scene)].material);
    if (ui_.material && present && !(*ui_.material == *present)) applyMaterial(*ui_.material);
    if (command != Command::None) runCommand(command);
}

void App::runCommand(Command command) {
    try {
        switch (command) {
            case Command::Close:
                window_.close();
                break;
            case Command::CopyCamera:
                if (stage_) copyCamera();
                break;
            case Command::SaveScene:
                if (stage_) saveScene();
                break;
            case Command::Screenshot:
                screenshot_wanted_ = true;
                // A full picture is written at once, a growing one at its next sample.
                if (begun_ && !schedule_.draft() && schedule_.current() && stage_->film().between() &&
                    stage_->film().samples() > 0)
                    takeScreenshot();
                break;
            case Command::Reset:
                control_->reset();
                camera_is_new_ = true;
                viewChanged(false);
                break;
            case Command::None:
                break;
        }
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

}  // namespace dsphere::viewer
