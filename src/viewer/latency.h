#pragma once

#include <utility>

namespace dsphere::viewer {

/// How long inputs wait for the frame that answers them: a picture begun after the input, or where it asks for none,
/// the next frame. Times are the window's; an event counts from the earliest time that it may have come.
class Latency {
  public:
    /// A look for events came back; `ended_wait`: it waited, so that they came just now. `since`: the look before.
    void heard(double now, double since, bool ended_wait) {
        if (heard_ < 0.0) heard_ = ended_wait ? now : since;
    }
    /// What was heard is handled.
    void handled() {
        if (input_ < 0.0) input_ = heard_;
        heard_ = -1.0;
    }
    /// A picture begins, which answers what was handled before.
    void pictureBegins() {
        if (picture_ < 0.0) picture_ = input_;
        input_ = -1.0;
    }
    /// A frame is on the screen, `settled` where it shows the newest picture: the seconds since the oldest input that
    /// it answers, or -1.
    double shown(double now, bool settled) {
        double& answered = picture_ >= 0.0 ? picture_ : input_;
        if (answered < 0.0 || !settled) return -1.0;
        return now - std::exchange(answered, -1.0);
    }

  private:
    double heard_ = -1.0, input_ = -1.0, picture_ = -1.0;
};

}  // namespace dsphere::viewer
