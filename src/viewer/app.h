#pragma once

#include <array>

#include "viewer/camera.h"
#include "viewer/display.h"
#include "viewer/flight.h"
#include "viewer/hand.h"
#include "viewer/journal.h"
#include "viewer/latency.h"
#include "viewer/loader.h"
#include "viewer/presenter.h"
#include "viewer/recent.h"
#include "viewer/recordedpath.h"
#include "viewer/schedule.h"
#include "viewer/stage.h"
#include "viewer/ui.h"
#include "viewer/viewer.h"
#include "viewer/watcher.h"
#include "viewer/window.h"

namespace dsphere::viewer {

/// The viewer at work: events change what is chosen, slices of rendering follow it, frames show it. One thread; files
/// are read and packed on another.
class App {
  public:
    App(const ViewerOptions& options, Window& window, gpu::Device& renders, gpu::Device& presents);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    void run();

  private:
    // input.cpp: what events do
    void handle(const Event& event);
    bool onPanel(const dvec2& cursor);
    void press(const Event& event);
    void move(const Event& event);
    void release();
    void scroll(const Event& event);
    void key(const Event& event);
    void resize();
    void fitView();
    void zoomAt(const dvec2& cursor, double steps);
    void flyTo(const Pose& pose);
    void flyToCursor(const dvec2& cursor);
    bool isDoubleClick(const Event& event);
    bool flyStep(double seconds);
    bool onDivider(const dvec2& cursor) const;
    std::optional<Hit> hitUnder(const dvec2& cursor);
    void turnSun(const dvec2& cursor);

    // command.cpp: what keys and buttons ask for
    void runCommand(Command command);
    bool runForWindow(Command command);
    bool runForFiles(Command command);
    bool runForCamera(Command command);
    void runForView(Command command);
    void openGoTo();
    void escape();
    void undo(int by);
    void cameraMoved(bool moving);

    // waiting.cpp: what is done later, or after a question
    void leave(const std::string& file);
    void leaveNow();
    void dropWaiting();
    void fillLeaving();
    void wantSaved();
    void saveIfDue();
    void wantScreenshot();
    bool screenshotIsDue() const;
    void screenshotBegins(bool draft);

    // follow.cpp: files and repacking, after what is chosen
    void open(const std::string& path);
    void read(const std::string& path);
    void follow();
    void finishWork();
    void show(Loaded loaded);
    void takeBodies();
    void tellNotices(const std::vector<std::string>& lost);
    void tellRefused(const Error& error);
    void reloadIfChanged();

    // chosen.cpp: what the panels show and change
    State state() const;
    void adopt(const State& wanted);
    void fillUi();
    void fillFigures(Figures& figures) const;
    void applyUi();
    void applyDialogs();
    std::string hoverText();
    void note(bool shown);
    void noteState(nlohmann::json& line) const;

    // saving.cpp: what is written
    void takeScreenshot();
    void saveScene();
    void copyCamera();
    std::string freeName() const;

    // play.cpp: keys of the camera
    PathFile pathFile() const;
    void addKey();
    void restoreKeys(const std::vector<std::string>& wanted);
    void play();
    void playStep();
    void stopPlaying();
    bool endsPlaying(const Event& event);

    // app.cpp: the loop
    void listen(double wait);
    bool called() const;
    bool renderSlice();
    bool renderOrFallBack();
    void startPicture(bool draft);
    ShownRange shownRange() const;
    void publish();
    void recolour();
    void convert(ProgressiveFilm& film);
    void layOutFrame();
    void drawFrame();
    bool idle() const;
    int targetSamples() const;   ///< of what is shown
    int pictureSamples() const;  ///< of the picture, also where a value is in its place
    void viewChanged(bool moving) { schedule_.change(window_.now(), moving); }
    void syncCamera();
    void say(const std::string& text, Message::Kind kind = Message::Kind::Said);
    void fadeMessage();
    void rescale();
    /// The part of the window that the picture fills, and the picture's own size: smaller where the device has limits.
    std::array<int, 2> area() const;
    std::array<int, 2> pictureSize() const;
    dvec2 share(const dvec2& cursor) const;

    ViewerOptions options_;
    Window& window_;
    gpu::Device& renders_;
    gpu::Device& presents_;
    Display display_;
    Presenter presenter_;  ///< after what it reads: its end waits for the last frame
    Journal journal_;

    // What is wanted, from which the rest follows. The camera and the target are the control's, once there is one.
    State chosen_;
    std::string wanted_path_;  ///< to be read as soon as nothing else is
    std::optional<CameraControl> control_;
    History history_;
    Edits saved_edits_;  ///< as in the file that was opened or saved last
    Edits shown_edits_;  ///< that the stage's scene has
    Edits tried_edits_;  ///< that the work under way makes a scene of

    Loader loader_;
    Watcher watcher_;
    std::unique_ptr<Stage> stage_;
    Schedule schedule_;
    bool incomplete_ = false;    ///< what the stage's provisional document stands for cannot be shown
    bool camera_is_new_ = true;  ///< the renderer has not got it yet
    bool begun_ = false;         ///< the stage's film is being filled or full
    bool published_ = false;     ///< the window shows what the film holds
    bool drawn_ = false;         ///< a frame has shown a picture of the stage
    ShownRange shown_range_;     ///< of what it shows
    struct Screenshot {
        bool at_once = false;  ///< at the next sample
        bool begun = false;    ///< its picture is under way
    };
    std::optional<Screenshot> screenshot_;  ///< that waits
    bool save_waits_ = false;               ///< the scene, for its changes to be shown
    bool leaves_then_ = false;              ///< as ui_.leaving has it

    Hand hand_;
    std::optional<Flight> flight_;
    struct Playing {
        RecordedPath keys;
        double since;  ///< the window's time
        int frame = 0;
    };
    std::optional<Playing> playing_;
    double last_click_ = -1e9;  ///< when the left button went down last
    dvec2 last_click_at_{0.0};
    bool second_click_ = false;            ///< the button that is down may end a double click
    std::array<int, 2> fitted_area_ = {};  ///< that the camera's picture fills
    RecentFiles recent_;
    std::vector<Event> heard_;  ///< events that wait for the loop's next turn
    dvec2 cursor_{0.0};         ///< as of the last event that was handled
    Ui ui_;

    Latency latency_;
    double draft_seconds_ = 0.0, draw_seconds_ = 0.0, frame_seconds_ = 0.0;
    double last_draw_ = -1.0, last_loop_ = 0.0, last_poll_ = 0.0, scale_ = 0.0, busy_since_ = 0.0;
    int frames_due_ = 3;
    bool closing_ = false;
};

}  // namespace dsphere::viewer
