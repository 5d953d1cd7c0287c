#pragma once

#include <set>

#include "viewer/background.h"
#include "viewer/camera.h"
#include "viewer/display.h"
#include "viewer/journal.h"
#include "viewer/presenter.h"
#include "viewer/schedule.h"
#include "viewer/stage.h"
#include "viewer/ui.h"
#include "viewer/viewer.h"
#include "viewer/watcher.h"
#include "viewer/window.h"

namespace dsphere::viewer {

/// The viewer at work: events change the view, slices of rendering follow it, frames show it. One thread; files are
/// read and packed on another.
class App {
  public:
    App(const ViewerOptions& options, Window& window, gpu::Device& renders, gpu::Device& presents);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    void run();

  private:
    enum class Drag { None, Orbit, Pan, Tilt, Sun, Divider };

    // input.cpp: what events do
    void handle(const Event& event);
    bool onPanel();
    void press(const Event& event);
    void move(const Event& event);
    void scroll(const Event& event);
    void key(const Event& event);
    void resize();
    bool flyStep(double seconds);
    bool onDivider(const dvec2& cursor) const;
    dvec2 share(const dvec2& cursor) const;
    std::optional<dvec3> pointUnder(const dvec2& cursor);
    void turnSun(const dvec2& cursor);

    // loading.cpp: files and repacking
    void open(const std::string& path);
    void startWork();
    void finishWork();
    void show(std::unique_ptr<Document> document);
    void reloadIfChanged();

    // tune.cpp: what the panel shows and changes
    void fillUi();
    void applyUi();
    void applyMaterial(const Texture& material);
    std::optional<SunAngles> sunAngles() const;
    void setSun(const SunAngles& angles);
    void changeLook(bool moving);
    void escape();
    void runCommand(Command command);
    std::string hoverText();

    // keep.cpp: what is written
    void takeScreenshot();
    void saveScene();
    void copyCamera();
    std::filesystem::path freeName(const char* extension) const;

    // app.cpp: the loop
    void listen(double wait);
    bool called() const;
    bool renderSlice();
    void startPicture(bool draft);
    void publish();
    void layOutFrame();
    void drawFrame();
    bool idle() const;
    int targetSamples() const;
    void viewChanged(bool moving) { schedule_.change(window_.now(), moving); }
    void syncCamera();
    void say(const std::string& message, bool error = false);
    void rescale();
    void note(bool shown);

    ViewerOptions options_;
    Window& window_;
    gpu::Device& renders_;
    gpu::Device& presents_;
    Presenter presenter_;
    Display display_;
    std::unique_ptr<Stage> stage_;
    std::optional<CameraControl> control_;
    Schedule schedule_;
    Watcher watcher_;
    Journal journal_;

    Background<std::unique_ptr<Document>> loading_;
    Background<PackedScene> packing_;
    std::string loading_path_, wanted_path_;
    std::unique_ptr<Scene> wanted_scene_;  ///< of the present file, with other images
    Tuning packing_tuning_, wanted_tuning_;
    bool look_changed_ = false;  ///< to be packed when packing_ is done

    ViewSettings view_;
    ToneSettings tone_;
    Ui ui_;
    std::set<int> held_;      ///< keys that went down without Control
    std::vector<int> typed_;  ///< keys that went down while ImGui was typed into, since its last frame
    Drag drag_ = Drag::None;
    SunAngles grabbed_sun_;
    dvec2 grabbed_cursor_{0.0};
    bool camera_is_new_ = true;  ///< the renderer has not got it yet
    bool begun_ = false;         ///< the stage's film is being filled or full
    bool published_ = false;     ///< the window shows what the film holds
    bool screenshot_wanted_ = false;
    double draft_seconds_ = 0.0, draw_seconds_ = 0.0, frame_seconds_ = 0.0;
    std::vector<Event> heard_;   ///< events that wait for the loop's next turn
    double heard_since_ = -1.0;  ///< when the first of them came, at the earliest; -1: none waits
    double input_since_ = -1.0;  ///< the same of events that neither a picture nor a frame has answered yet
    double last_draw_ = -1.0, last_loop_ = 0.0, last_poll_ = 0.0, message_until_ = 0.0, scale_ = 0.0;
    double view_input_ = -1.0;  ///< the same of those that the picture begun last answers, until it is shown
    int frames_due_ = 3;
};

}  // namespace dsphere::viewer
