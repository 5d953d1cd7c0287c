#include "viewer/app.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsphere::viewer {

namespace {

// A draft is shown whole; a still gives way to the hand, which is looked at after each of its submissions.
constexpr double kDraftSlice = 0.060, kStillSlice = 0.012;
constexpr double kDraftSubmit = kDraftSlice, kStillSubmit = 0.006;  ///< one submission's aim
constexpr double kIdleWait = 0.1, kRefiningRedraw = 0.25;
constexpr double kMessageSeconds = 5.0, kFade = 0.5;

}  // namespace

App::App(const ViewerOptions& options, Window& window, gpu::Device& renders, gpu::Device& presents)
    : options_(options),
      window_(window),
      renders_(renders),
      presents_(presents),
      presenter_(presents, renders),
      display_(renders),
      journal_(options.journal) {
    view_.method = options.method;
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
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

void App::say(const std::string& message, bool error) {
    ui_.message = message;
    ui_.message_is_error = error;
    message_until_ = window_.now() + kMessageSeconds;
    frames_due_ = std::max(frames_due_, 2);
}

int App::targetSamples() const {
    if (view_.show != Show::Colour) return 1;
    return options_.samples.value_or(std::clamp(stage_->document().original.sampler.pixel_samples, 16, 65536));
}

bool App::idle() const {
    if (frames_due_ > 0 || !window_.visible()) return !window_.visible();
    if (!ui_.message.empty() && !ui_.message_is_error && window_.now() > message_until_ - kFade) return false;
    if (!stage_) return true;
    if (begun_ && schedule_.draft() && stage_->film().samples() == 0) return false;
    return schedule_.want(window_.now(), targetSamples()) == Schedule::Want::Nothing && !schedule_.draft();
}

// Before a ray is traced for the cursor: the picture under way is of an older camera then, and given up.
void App::syncCamera() {
    if (!stage_ || !camera_is_new_) return;
    stage_->setCamera(control_->camera(), window_.width(), window_.height());
    camera_is_new_ = begun_ = false;
}

void App::startPicture(bool draft) {
    double scale = draft ? schedule_.scale() : 1.0;
    int width = std::max(1, int(std::ceil(scale * window_.width())));
    int height = std::max(1, int(std::ceil(scale * window_.height())));
    if (stage_->prepareFilm(view_.show, window_.width(), window_.height())) display_.forget();
    stage_->setCamera(control_->camera(), width, height);
    camera_is_new_ = false;
    const Sampling sampling = draft || view_.show != Show::Colour ? Sampling::Centres : Sampling::Jittered;
    stage_->begin(view_, sampling, !draft || schedule_.shadows());
    draft ? schedule_.beginDraft() : schedule_.beginStill();
    begun_ = true;
    published_ = false;
    draft_seconds_ = 0.0;
    if (view_input_ < 0.0) view_input_ = input_since_;
    input_since_ = -1.0;
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
    LiveFilm& film = stage_->film();
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
        if (film.sampleSeconds() * Schedule::kLeastScale * Schedule::kLeastScale > Schedule::kFrameTarget)
            stage_->makeDraftsReady(view_);
    }
    if (screenshot_wanted_ && !draft) takeScreenshot();
    // Doubling is when the eye sees a difference.
    int samples = film.samples();
    if (!draft && (samples & (samples - 1)) != 0 && samples != targetSamples()) return false;
    publish();
    return true;
}

void App::publish() {
    presenter_.finish();
    const Globe& globe = stage_->document().globe();
    CursorRay middle = control_->rayAt(0.5 * dvec2(window_.width(), window_.height()));
    double distance = glm::length(middle.origin - globe.centre()), radius = globe.radius();
    double horizon = std::sqrt(std::max(distance * distance - 0.8 * radius * radius, 0.01 * radius * radius));
    display_.convert(stage_->film(), view_.show, tone_, std::max(0.0, distance - radius), horizon);
    presenter_.setPicture(display_.pixels(), stage_->film().width(), stage_->film().height());
    published_ = true;
}

void App::layOutFrame() {
    rescale();
    ImGui_ImplGlfw_NewFrame();
    ImGui::GetIO().DisplaySize = ImVec2(float(window_.width()), float(window_.height()));
    ImGui::GetIO().DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    ImGui::GetIO().MousePos = ImVec2(float(window_.cursor().x), float(window_.cursor().y));
    fillUi();
    // ImGui 1.86 looks at keys once a frame, and would miss those that are up again by then.
    for (int code : typed_) ImGui::GetIO().KeysDown[code] = true;
    ImGui::NewFrame();
    layOut(ui_, window_.width(), window_.height(), scale_);
    if (view_.split && (drag_ == Drag::Divider || (!ImGui::GetIO().WantCaptureMouse && onDivider(window_.cursor()))))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::Render();
    for (int code : std::exchange(typed_, {})) ImGui::GetIO().KeysDown[code] = window_.isDown(code);
}

void App::drawFrame() {
    if (!window_.visible()) return;
    const double start = window_.now();
    layOutFrame();
    bool shown = presenter_.draw(*ImGui::GetDrawData());
    presenter_.finish();
    const double now = window_.now();
    draw_seconds_ = draw_seconds_ > 0.0 ? 0.8 * draw_seconds_ + 0.2 * (now - start) : now - start;
    double since = now - last_draw_;
    if (last_draw_ > 0.0 && since < 1.0)
        frame_seconds_ = frame_seconds_ > 0.0 ? 0.8 * frame_seconds_ + 0.2 * since : since;
    last_draw_ = now;
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
    const bool waited = wait > 0.0 && last_poll_ - start > 0.002;
    if (!events.empty() && heard_since_ < 0.0) heard_since_ = waited ? last_poll_ : polled;
    heard_.insert(heard_.end(), events.begin(), events.end());
}

// Whether what was heard may ask for another picture: a mouse that only moves does not.
bool App::called() const {
    const bool held = drag_ != Drag::None || ImGui::IsAnyItemActive();
    return std::ranges::any_of(
        heard_, [&](const Event& event) { return event.kind == Event::Move ? held : event.kind != Event::KeyUp; });
}

void App::run() {
    last_loop_ = last_poll_ = window_.now();
    while (!window_.closing() && !options_.interrupted()) {
        listen(idle() && heard_.empty() ? kIdleWait : 0.0);
        const std::vector<Event> events = std::exchange(heard_, {});
        if (input_since_ < 0.0) input_since_ = heard_since_;
        heard_since_ = -1.0;
        for (const Event& event : events) handle(event);
        bool flew = flyStep(std::min(last_poll_ - last_loop_, 0.1));
        last_loop_ = last_poll_;
        finishWork();
        reloadIfChanged();
        startWork();
        if (!events.empty()) frames_due_ = std::max(frames_due_, 4);  // what ImGui takes to open a list
        bool fresh = renderSlice();
        if (fresh) listen(0.0);  // between the two long parts of a turn, to know better when events came
        bool late = window_.now() - last_draw_ > kRefiningRedraw;
        bool fading = !ui_.message.empty() && !ui_.message_is_error;
        // A still that is about to be dropped need not be drawn first.
        if (fresh && !schedule_.draft() && !late && called())
            frames_due_ = std::max(frames_due_, 1);
        else if (fresh || flew || frames_due_ > 0 || (late && (!idle() || fading || loading_.busy())))
            drawFrame();
        if (fading && window_.now() > message_until_) {
            ui_.message.clear();
            frames_due_ = std::max(frames_due_, 1);
        }
        ui_.message_alpha =
            ui_.message_is_error ? 1.0 : std::clamp((message_until_ - window_.now()) / kFade, 0.05, 1.0);
    }
}

void App::note(bool shown) {
    // Answered once a picture begun after the input is on the screen, or where it asks for none, the next frame.
    double latency = -1.0;
    const bool settled = !stage_ || (published_ && schedule_.current());
    double& answered = view_input_ >= 0.0 ? view_input_ : input_since_;
    if (shown && answered >= 0.0 && settled) latency = window_.now() - std::exchange(answered, -1.0);
    if (!journal_.on()) return;
    const dvec2 at = share(window_.cursor());
    const Figures& figures = ui_.figures;
    journal_.write(fmt::format(
        "{{\"time\": {:.4f}, \"shown\": {}, \"file\": {}, \"busy\": {}, \"samples\": {}, \"target\": {}, \"draft\": "
        "{}, "
        "\"film\": [{}, {}], \"window\": [{}, {}], \"frame_ms\": {:.2f}, \"draw_ms\": {:.2f}, \"latency_ms\": {:.2f}, "
        "\"altitude\": {:.9g}, \"marcher\": {}, \"split\": {}, \"divider\": {:.4f}, \"value\": {}, \"panel\": {}, "
        "\"keys\": {}, \"hover\": {}, \"message\": {}, \"error\": {}, \"cursor\": [{:.4f}, {:.4f}], \"scale\": {:.2f}, "
        "\"exaggeration\": {:.4f}, \"detail\": {}, \"filter\": {}, \"capture\": {}, \"render_ms\": {:.2f}, "
        "\"device_ms\": {:.2f}}}",
        window_.now(), shown, jsonQuoted(figures.file), figures.busy, figures.samples, figures.target_samples,
        schedule_.draft(), figures.width, figures.height, window_.width(), window_.height(), 1e3 * frame_seconds_,
        1e3 * draw_seconds_, latency < 0.0 ? -1.0 : 1e3 * latency, control_ ? control_->altitude() : 0.0,
        int(view_.method.marcher), view_.split, view_.divider, int(view_.show), ui_.panel_open, ui_.keys_open,
        jsonQuoted(figures.hover), jsonQuoted(ui_.message), ui_.message_is_error, at.x, at.y, scale_,
        ui_.tuning.exaggeration, view_.method.detail, int(ui_.tuning.filter), ImGui::GetIO().WantCaptureMouse,
        1e3 * draft_seconds_, stage_ && begun_ ? 1e3 * stage_->film().sampleSeconds() : 0.0));
}

}  // namespace dsphere::viewer
