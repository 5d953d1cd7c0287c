#pragma once

#include "base/math.h"
#include "gpu/device.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace dsphere::viewer {

/// What the hand did; cursor places are pixels of the framebuffer, y downward.
struct Event {
    enum Kind { Press, Release, Move, Leave, Scroll, KeyDown, KeyUp, Character, Drop, Resize, LoseFocus };
    Kind kind;
    int code = 0;  ///< GLFW's button or key; Character: its code point
    bool shift = false, control = false;
    bool repeated = false;  ///< KeyDown: the key was down already
    dvec2 cursor{0.0};      ///< where it is; Scroll: where it was turned
    double steps = 0.0;     ///< Scroll: notches, towards the front positive
    std::string path;       ///< Drop
};

/// A window with the events since they were last taken. One at a time: GLFW has one state for the program.
class Window {
  public:
    /// So large, but not larger than the display; `below`: pixels at scale 1 that are added to the height; `grows`: as
    /// many times larger as the display's scale says, where there is room. Error (NoDevice) without a display, naming
    /// `render` as the way.
    Window(int width, int height, const std::string& title, int below = 0, bool grows = false);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What a device needs to present here.
    gpu::Presentation presentation(bool required) const;

    /// Waits for events up to `seconds` (0: not at all), then returns all that came.
    std::vector<Event> poll(double seconds);
    bool closing() const;
    /// `false`: goes on after all.
    void close(bool really = true);
    /// Fills the screen, or goes back to what it was.
    void switchFullScreen();
    double now() const;

    int width() const { return width_; }  ///< of the framebuffer; 0 while minimised
    int height() const { return height_; }
    bool visible() const { return width_ > 0 && height_ > 0; }
    dvec2 cursor() const { return cursor_; }
    bool cursorWithin() const { return cursor_within_; }
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
    bool cursor_within_ = true;
    std::array<int, 4> windowed_ = {};  ///< place and size before the screen was filled, screen units
    std::vector<Event> events_;
};

}  // namespace dsphere::viewer
