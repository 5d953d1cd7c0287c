#include "viewer/app.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "viewer/displayworld.h"
#include "viewer/picturesize.h"

namespace dsphere::viewer {

namespace {

// A draft is shown whole; a still gives way to the hand, which is looked at after each of its submissions.
constexpr double kDraftSlice = 0.060, kStillSlice = 0.012;
constexpr double kDraftSubmit = kDraftSlice, kStillSubmit = 0.006;  ///< one submission's aim
constexpr double kIdleWait = 0.25, kBusyWait = 0.02, kRefiningRedraw = 0.25;
constexpr double kMessageSeconds = 5.0, kFade = 0.5;

}  // namespace

App::App(const ViewerOptions& options, Window& window, gpu::Device& renders, gpu::Device& presents)
    : options_(options),
      window_(window),
      renders_(renders),
      presents_(presents),
      display_(renders),
      presenter_(presents, renders),
      journal_(options.journal),
      loader_(options.open,
              [this](const SceneTraits& traits) { warmUp(renders_, options_.device, traits, options_.method); }) {
    chosen_.view.method = options.method;
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForVulkan(window.handle(), false);  // Hand tells it of events
    rescale();
    presenter_.resize(window.width(), window.height());
    wanted_path_ = options.path;
}

App::~App() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void App::rescale() {
    if (window_.scale() == scale_) return;
    scale_ = window_.scale();
    applyStyle(scale_);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    presenter_.finish();
    presenter_.setFont(pixels, width, height);
    ImGui::GetIO().Fonts->SetTexID(reinterpret_cast<ImTextureID>(Overlay::kFont));
}

void App::say(const std::string& text, Message::Kind kind) {
    ui_.message = {text, kind, window_.now() + kMessageSeconds, 1.0};
    frames_due_ = std::max(frames_due_, 2);
}

std::array<int, 2> App::area() const {
    const int beside = ui_.docked && ui_.panel_open ? panelWidth(scale_) : 0;
    return {std::max(1, window_.width() - beside), std::max(1, window_.height() - statusHeight(scale_))};
}

std::array<int, 2> App::pictureSize() const {
    return boundedPicture(area(), renders_.limits(), presents_.limits());
}

dvec2 App::share(const dvec2& cursor) const {
    return cursor / dvec2(area()[0], area()[1]);
}

int App::targetSamples() const {
    return chosen_.view.show != Show::Colour || stage_->document().provisional() ? 1 : pictureSamples();
}

int App::pictureSamples() const {
    return options_.samples.value_or(std::clamp(stage_->document().original.sampler.pixel_samples, 16, 65536));
}

bool App::idle() const {
    if (frames_due_ > 0 || !window_.visible()) return !window_.visible();
    if (!ui_.message.text.empty() && !ui_.message.stays() && window_.now() > ui_.message.until - kFade) return false;
    if (!stage_) return true;
    if (flight_ || playing_) return false;
    if (begun_ && schedule_.draft() && stage_->film().samples() == 0) return false;
    return schedule_.want(window_.now(), targetSamples()) == Schedule::Want::Nothing && !schedule_.draft();
}

// Before a ray is traced for the cursor: the picture under way is of an older camera then, and given up.
void App::syncCamera() {
    if (!stage_ || !camera_is_new_) return;
    stage_->setCamera(control_->camera(), area()[0], area()[1]);
    camera_is_new_ = begun_ = false;
}

void App::startPicture(bool draft) {
    double scale = draft ? schedule_.scale() : 1.0;
    const auto [most_width, most_height] = pictureSize();
    const int width = std::max(1, int(std::ceil(scale * most_width)));
    const int height = std::max(1, int(std::ceil(scale * most_height)));
    if (stage_->prepareFilm(chosen_.view.show, draft, width, height)) display_.forget();
    stage_->setCamera(control_->camera(), width, height);
    camera_is_new_ = false;
    const Sampling sampling = draft || chosen_.view.show != Show::Colour ? Sampling::Centres : Sampling::Jittered;
    screenshotBegins(draft);
    stage_->begin(chosen_.view, sampling, !draft || schedule_.shadows());
    draft ? schedule_.beginDraft() : schedule_.beginStill();
    begun_ = true;
    published_ = false;
    draft_seconds_ = 0.0;
    latency_.pictureBegins();
}

// True if there is something new to show.
bool App::renderSlice() {
    if (!stage_ || !window_.visible()) return false;
    const double start = window_.now();
    bool under_way = begun_ && stage_->film().samples() == 0;
    if (!(under_way && schedule_.draft())) {
        Schedule::Want want = schedule_.want(start, targetSamples());
        if (want == Schedule::Want::Nothing) return false;
        bool go_on = want == Schedule::Want::Still && begun_ && !schedule_.draft() && schedule_.current();
        if (!go_on) startPicture(want == Schedule::Want::Draft);
    }
    const bool draft = schedule_.draft();
    ProgressiveFilm& film = stage_->film();
    bool done = false;
    while (!done && (draft || !called()) && window_.now() - start < (draft ? kDraftSlice : kStillSlice)) {
        done = film.step(draft ? kDraftSubmit : kStillSubmit);
        if (!draft) listen(0.0);
    }
    draft_seconds_ += window_.now() - start;
    if (!done) return false;
    if (draft) schedule_.draftTook(draft_seconds_, draw_seconds_);
    if (!draft) {
        schedule_.sampleDone();
        if (stage_->document().hasMapsInFiles() ||
            film.sampleSeconds() * Schedule::kLeastScale * Schedule::kLeastScale > Schedule::kFrameTarget)
            stage_->makeDraftsReady(chosen_.view);
    }
    if (screenshotIsDue()) takeScreenshot();
    // Doubling is when the eye sees a difference.
    int samples = film.samples();
    if (!draft && (samples & (samples - 1)) != 0 && samples != targetSamples()) return false;
    publish();
    return true;
}

// A marcher that cannot march this scene gives way to the exact one.
bool App::renderOrFallBack() {
    try {
        return renderSlice();
    } catch (const Error& error) {
        if (chosen_.view.method.marcher == Marcher::Exact) throw;
        chosen_.view.method.marcher = Marcher::Exact;
        begun_ = false;
        viewChanged(false);
        say(error.what());
        return false;
    }
}

ShownRange App::shownRange() const {
    const Globe& globe = control_->globe();
    const CursorRay middle = control_->rayAt(0.5 * dvec2(area()[0], area()[1]));
    const double distance = glm::length(middle.origin - globe.centre()), radius = globe.radius();
    ShownRange range;
    range.near = std::max(0.0, distance - radius);
    range.far = std::sqrt(std::max(distance * distance - 0.8 * radius * radius, 0.01 * radius * radius));
    std::tie(range.least_height, range.greatest_height) = heightRange(stage_->document(), control_->target());
    // The nearer, the closer the lines.
    const double share = std::min(control_->altitude() / radius, 1.0);
    const double heights = std::max(range.greatest_height - range.least_height, 1e-12);
    range.contour_spacing = roundStep(heights / 8.0 * std::max(std::sqrt(std::max(share, 0.0)), 0.01));
    constexpr double kDegrees[] = {15.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1};
    for (const double degrees : kDegrees)
        if (degrees == kDegrees[0] || degrees >= 20.0 * share) range.graticule_spacing = degrees;
    return range;
}

void App::publish() {
    shown_range_ = shownRange();
    convert(stage_->film());
    published_ = true;
}

// The newest picture of which there is a sample; while its first one is made, what was shown before.
void App::recolour() {
    ProgressiveFilm* film = begun_ && stage_->film().samples() > 0 ? &stage_->film() : display_.film();
    if (film && film->samples() > 0 && film->mask() == planesOf(chosen_.view.show)) convert(*film);
}

void App::convert(ProgressiveFilm& film) {
    presenter_.finish();
    display_.convert(film, {chosen_.view.show, chosen_.tone, shown_range_}, displayWorld(stage_->document()));
    presenter_.setPicture(display_.pixels(), film.width(), film.height());
}

void App::layOutFrame() {
    rescale();
    ImGui_ImplGlfw_NewFrame();
    ImGui::GetIO().DisplaySize = ImVec2(float(window_.width()), float(window_.height()));
    ImGui::GetIO().DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    hand_.prepare(cursor_, window_.cursorWithin());
    fillUi();
    ImGui::NewFrame();
    layOut(ui_, {window_.width(), window_.height(), scale_, area()[0]});
    const bool dividing = hand_.drag == Hand::Drag::Divider;
    if (chosen_.view.split && (dividing || (!ImGui::GetIO().WantCaptureMouse && onDivider(cursor_))))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::Render();
    hand_.laidOut();
}

void App::drawFrame() {
    if (!window_.visible()) return;
    const double start = window_.now();
    ui_.figures.hover = hoverText();
    layOutFrame();
    bool shown = presenter_.draw(*ImGui::GetDrawData());
    presenter_.finish();
    const double now = window_.now();
    draw_seconds_ = draw_seconds_ > 0.0 ? 0.8 * draw_seconds_ + 0.2 * (now - start) : now - start;
    double since = now - last_draw_;
    if (last_draw_ > 0.0 && since < 1.0)
        frame_seconds_ = frame_seconds_ > 0.0 ? 0.8 * frame_seconds_ + 0.2 * since : since;
    last_draw_ = now;
    drawn_ = drawn_ || published_;
    note(shown);
    frames_due_ = shown ? frames_due_ - 1 : frames_due_;
    applyUi();
}

// An event ends a wait at once, but may have come right after the last look if there was none: the times kept are the
// earliest that are possible.
void App::listen(double wait) {
    const double polled = last_poll_, start = window_.now();
    const std::vector<Event> events = window_.poll(wait);
    last_poll_ = window_.now();
    if (!events.empty()) latency_.heard(last_poll_, polled, wait > 0.0 && last_poll_ - start > 0.002);
    heard_.insert(heard_.end(), events.begin(), events.end());
}

// Whether what was heard may ask for another picture: a mouse that only moves does not.
bool App::called() const {
    const bool held = hand_.drag != Hand::Drag::None || ImGui::IsAnyItemActive();
    return std::ranges::any_of(heard_, [&](const Event& event) {
        return event.kind == Event::Move ? held : event.kind != Event::KeyUp && event.kind != Event::Leave;
    });
}

void App::fadeMessage() {
    if (ui_.message.text.empty() || ui_.message.stays()) return;
    const double left = ui_.message.until - window_.now();
    ui_.message.alpha = std::clamp(left / kFade, 0.05, 1.0);
    if (left > 0.0) return;
    ui_.message.text.clear();
    frames_due_ = std::max(frames_due_, 1);
}

void App::run() {
    last_loop_ = last_poll_ = window_.now();
    while (!closing_ && !options_.interrupted()) {
        listen(!idle() || !heard_.empty() ? 0.0 : loader_.busy() ? kBusyWait : kIdleWait);
        const std::vector<Event> events = std::exchange(heard_, {});
        latency_.handled();
        for (const Event& event : events) handle(event);
        if (window_.closing()) {
            window_.close(false);
            leave({});
        }
        const bool flew = flyStep(std::min(last_poll_ - last_loop_, 0.1));
        last_loop_ = last_poll_;
        finishWork();
        reloadIfChanged();
        follow();
        saveIfDue();
        if (!events.empty()) frames_due_ = std::max(frames_due_, 4);  // what ImGui takes to open a list
        const bool fresh = renderOrFallBack();
        if (fresh) listen(0.0);  // between the two long parts of a turn, to know better when events came
        const bool late = window_.now() - last_draw_ > kRefiningRedraw;
        const bool fading = !ui_.message.text.empty() && !ui_.message.stays();
        // A still that is about to be dropped need not be drawn first.
        if (fresh && !schedule_.draft() && !late && called())
            frames_due_ = std::max(frames_due_, 1);
        else if (fresh || flew || frames_due_ > 0 || (late && (!idle() || fading || loader_.busy())))
            drawFrame();
        fadeMessage();
        const bool at_rest = !flight_ && !playing_ && hand_.drag == Hand::Drag::None && !ImGui::IsAnyItemActive();
        if (stage_ && at_rest && !schedule_.moving(window_.now())) history_.add(state());
    }
}

}  // namespace dsphere::viewer
