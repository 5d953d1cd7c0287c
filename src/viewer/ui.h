#pragma once

#include "viewer/gauges.h"
#include "viewer/globe.h"
#include "viewer/keytable.h"
#include "viewer/pathcompletion.h"
#include "viewer/state.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsphere::viewer {

/// A direction as seen from a globe's centre: degrees.
struct SunAngles {
    double latitude = 0.0, longitude = 0.0;

    bool operator==(const SunAngles&) const = default;
};

SunAngles anglesOf(const Globe& globe, const dvec3& direction);
dvec3 directionOf(const Globe& globe, const SunAngles& angles);

/// What the status bar and the panel tell.
struct Figures {
    std::string file, device;
    int samples = 0, target_samples = 0, width = 0, height = 0;
    double frame_seconds = 0.0, rays_per_second = 0.0;
    bool moving = false;
    std::string busy;               ///< what is being done on another thread; empty: nothing
    double busy_seconds = 0.0;      ///< since when
    double busy_share = -1.0;       ///< of that, 0 to 1; -1: unknown
    double sample_share = -1.0;     ///< of a first sample that takes long, 0 to 1; -1: there is none
    bool screenshot_waits = false;  ///< for the target's samples
    float u = 1.0f, v = 1.0f;       ///< the part of the picture's texture that is in use
    std::string hover;              ///< of what is under the cursor; empty beside all objects
    Gauges gauges;
    ShownRange range;         ///< of the values that are shown
    std::string height_unit;  ///< of the target's heights; empty: unknown
    /// Of the target where it is coloured by height: what the ramp's ends stand for.
    struct RampScale {
        std::string ramp, unit;
        double low, high;
    };
    std::optional<RampScale> ramp;
};

/// A message that came up; warnings and errors stay until they are dismissed.
struct Message {
    enum class Kind { Said, Warning, Error };

    std::string text;
    Kind kind = Kind::Said;
    double until = 0.0;  ///< the window's time when it goes, of what was only said
    double alpha = 1.0;

    bool stays() const { return kind != Kind::Said; }
};

/// Where a control of the last frame is, by its label, in pixels: x0, y0, x1, y1.
using Places = std::vector<std::pair<std::string, std::array<float, 4>>>;

/// What the panel's rows show and change.
struct Subject {
    State state;
    const Scene* original = nullptr;  ///< as the file says it; null before one is open
    const Globe* globe = nullptr;     ///< of the target

    const Shape& shape() const { return original->shapes[state.target]; }
    ShapeEdits& edits() { return state.edits.shapes[state.target]; }
    const ShapeEdits& edits() const { return state.edits.shapes[state.target]; }
};

/// A place that is being typed.
struct GoTo {
    bool open = false, go = false;
    double latitude = 0.0, longitude = 0.0;                        ///< degrees
    double altitude = 0.0;                                         ///< above the ground, in the gauges' unit
    std::array<char, 32> latitude_text = {}, longitude_text = {};  ///< as it is typed
};

/// A path that is being typed.
struct PathBox {
    bool open = false;
    std::array<char, 1024> text = {};
    std::string completed;  ///< the text that `completions` are of
    PathCompletions completions;
    std::string chosen;  ///< to be opened
};

/// The question before changes are lost that are in no scene file.
struct Leaving {
    bool asked = false;
    std::string file;     ///< that is to be opened; empty: the window is to be closed
    std::string changes;  ///< in words
    std::string save_as;  ///< what saving writes, and where
};

/// All that the panels show and change. The viewer takes what comes back as the new state.
struct Ui {
    Subject subject;
    State untouched;  ///< as the file was opened: what reset goes back to
    bool panel_open = false, keys_open = false;
    bool let_go = false;  ///< the next frame closes open lists
    bool has_picture = false;
    bool starting = false;            ///< no file is open or being read
    std::vector<std::string> recent;  ///< offered then
    bool docked = false;              ///< the panel takes the window's right side, and the picture ends beside it
    GoTo go_to;
    PathBox path;
    Leaving leaving;
    Message message;
    Command command = Command::None;
    Figures figures;
    Places places;
    std::array<float, 4> panel_box = {};    ///< of the last frame, pixels: x0, y0, x1, y1
    std::array<int, 2> panel_window = {};   ///< the window's size then
    std::array<float, 2> message_end = {};  ///< the lower right corner of the message in the last frame, from 0, 0 on
    std::string resetting;                  ///< the row whose slider is being reset, until the mouse is let go
};

/// The window in pixels, and the display's scale.
struct Extent {
    int width, height;
    double scale;
    int picture_width;  ///< without a docked panel
};

/// Lays out one frame of the window.
void layOut(Ui& ui, const Extent& window);

// The parts of it:
void drawStatusBar(Ui& ui, const Extent& window);
void drawPanel(Ui& ui, const Extent& window);
void drawInstruments(Ui& ui, const Extent& window);
void drawStart(Ui& ui, const Extent& window);
void drawGoTo(Ui& ui, const Extent& window);
void drawPathBox(Ui& ui, const Extent& window);
void drawKeys(Ui& ui, const Extent& window);
void drawProgress(const Ui& ui, const Extent& window);
void drawMessage(Ui& ui, const Extent& window);
void drawLeaving(Ui& ui, const Extent& window);

/// A button beside the one before it, in the next line if there is no room.
void beginButtonRow();
bool buttonInRow(const char* name);

/// Remembers where the control that was just laid out is.
void notePlace(Ui& ui, const std::string& label);

/// A tip for the control that was just laid out, if the mouse is on it: beside its window, or else above or below it.
void showTip(Ui& ui, const char* tip);

/// How far to the right the picture can be seen below `top`: a floating panel covers its right side.
float freeRight(const Ui& ui, const Extent& window, float top);

/// The width of the panel in pixels.
int panelWidth(double scale);

/// The height of the status bar in pixels.
int statusHeight(double scale);

/// Colours, spacing and the font for a display's scale; the font atlas is then to be uploaded anew.
void applyStyle(double scale);

}  // namespace dsphere::viewer
