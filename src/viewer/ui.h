#pragma once

#include "scene/scene.h"
#include "viewer/document.h"
#include "viewer/show.h"

#include <optional>
#include <string>

namespace dsphere::viewer {

/// What a click or a key asks for, once.
enum class Command { None, CopyCamera, SaveScene, Screenshot, Reset, Close };

/// Towards the sun, as seen from the globe's centre: degrees.
struct SunAngles {
    double latitude = 0.0, longitude = 0.0;

    bool operator==(const SunAngles&) const = default;
};

/// What the status bar and the panel tell.
struct Figures {
    std::string file, device;
    int samples = 0, target_samples = 0, width = 0, height = 0;
    double frame_seconds = 0.0, rays_per_second = 0.0;
    bool moving = false, busy = false;
    float u = 1.0f, v = 1.0f;  ///< the part of the picture's texture that is in use
    std::string hover;         ///< of what is under the cursor; empty beside the planet
};

/// All that the panels show and change. The viewer compares what it had with what comes back.
struct Ui {
    ViewSettings view;
    ToneSettings tone;
    Tuning tuning;
    bool ripples = false;             ///< the globe has no map, and so no filter
    std::optional<Texture> material;  ///< the texture of the globe's; unset: a metal or a mirror has none
    std::optional<ImageMap> image;    ///< that the file gives the globe
    std::optional<SunAngles> sun;     ///< unset: the scene has no distant light
    bool panel_open = false, keys_open = false;
    bool let_go = false;     ///< the next frame closes open lists
    bool displaced = false;  ///< the globe has a relief
    std::string message;     ///< a line that came up; an error stays until it is dismissed
    bool has_picture = false;
    bool message_is_error = false;
    double message_alpha = 1.0;
    Command command = Command::None;
    Figures figures;
};

/// Lays out one frame of the window, of width x height pixels; `scale` is the display's.
void layOut(Ui& ui, int width, int height, double scale);

// The parts of it:
void drawStatusBar(Ui& ui, int width, int height, double scale);
void drawPanel(Ui& ui, int width, int height, double scale);
void drawKeys(Ui& ui, int width, int height, double scale);
void drawMessage(Ui& ui, int width, int height, double scale);

/// The height of the status bar in pixels.
int statusHeight(double scale);

/// Colours, spacing and the font for a display's scale; the font atlas is then to be uploaded anew.
void applyStyle(double scale);

}  // namespace dsphere::viewer
