#pragma once

#include "base/math.h"
#include "gpu/device.h"

#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace dsphere::viewer {

/// What the hand did; cursor places are pixels of the framebuffer, y downward.
struct Event {
    enum Kind { Press, Release, Move, Scroll, KeyDown, KeyUp, Drop, Resize, LoseFocus };
    Kind kind;
    int code = 0;  ///< GLFW's button or key
    bool shift = false, control = false;
    dvec2 cursor{0.0};   ///< where it is; Scroll: where it was turned
    double steps = 0.0;  ///< Scroll: notches, towards the front positive
    std::string path;    ///< Drop
};

/// A window with the events since they were last taken. One at a time: GLFW has one state for the program.
class Window {
  public:
    /// Error (NoDevice) without a display, naming `render` as the way.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What a device needs to present here.
    gpu::Presentation presentation(bool required) const;

    /// Waits for events up to `seconds` (0: not at all), then returns all that came.
    std::vector<Event> poll(double seconds);
    bool closing() const;
    void close();
    double now() const;

    int width() const { return width_; }  ///< of the framebuffer; 0 while minimised
    int height() const { return height_; }
    bool visible() const { return width_ > 0 && height_ > 0; }
    dvec2 cursor() const { return cursor_; }
    double scale() const;  ///< of the display: 1 at 96 dots an inch
    bool isDown(int key) const;

    void setTitle(const std::string& title);
    void copyText(const std::string& text);
    GLFWwindow* handle() const { return window_; }

  private:
    friend struct Callbacks;
    void readSize();

    GLFWwindow* window_ = nullptr;
    int width_ = 0, height_ = 0;
    dvec2 cursor_{0.0}, pixels_per_unit_{1.0};
    std::vector<Event> events_;
};

}  // namespace dsphere::viewer
