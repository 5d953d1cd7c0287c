#pragma once

#include "gpu/device.h"
#include "viewer/document.h"
#include "viewer/show.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace dsphere::viewer {

struct ViewerOptions {
    std::string path;  ///< empty: the window asks for one
    OpenScene open;
    std::string device;       ///< DeviceOptions::selector
    bool validation = false;  ///< messages make runViewer throw at the end
    MarchMethod method;
    double exaggeration = 1.0;          ///< of all displacements, that the panel begins with; `open` leaves it out
    bool exact_size = false;            ///< the picture has the film's size, however dense the display is
    std::optional<int> samples;         ///< that a still view refines to; unset: the scene's, at least 16
    bool apart = false;                 ///< present with a device of its own, as where the chosen one cannot
    std::string journal;                ///< a file that gets a line of JSON a frame; empty: none
    std::function<bool()> interrupted;  ///< polled; true ends the program
    std::function<void(const std::filesystem::path&)> wrote;  ///< told of each screenshot and scene
};

/// Shows a scene in a window until it is closed. Throws Error: (NoDevice) without a display or a device that presents,
/// (InvalidInput) for the first scene; later ones are told of in the window.
void runViewer(const ViewerOptions& options);

}  // namespace dsphere::viewer
