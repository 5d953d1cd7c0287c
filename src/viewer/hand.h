#pragma once

#include "viewer/ui.h"
#include "viewer/window.h"

#include <set>

namespace dsphere::viewer {

/// What is pressed and held, and what Dear ImGui has been told of it: events reach it in their order, with a frame
/// between those that it would take for one.
class Hand {
  public:
    enum class Drag { None, Orbit, Pan, Tilt, Sun, Divider };

    Drag drag = Drag::None;
    dvec2 from{0.0};     ///< where the drag began, pixels
    SunAngles sun;       ///< as the drag began
    std::set<int> keys;  ///< GLFW's, that went down without Control

    /// Whether Dear ImGui must lay out a frame before it is told of this event.
    bool needsFrame(const Event& event) const;
    /// Tells it.
    void tell(const Event& event);
    /// Nothing is held any more: another window has the keys.
    void letGo();
    /// Before a frame: the mouse as of the last event that was told.
    void prepare(const dvec2& cursor, bool within);
    /// After one.
    void laidOut() { pending_ = Pending::Nothing; }
    bool anyButton() const { return !buttons_.empty(); }

  private:
    enum class Pending { Nothing, Button, Key, Text, Wheel };
    static Pending kindOf(const Event& event);

    std::set<int> buttons_;
    Pending pending_ = Pending::Nothing;
};

}  // namespace dsphere::viewer
