#pragma once

namespace dsphere::viewer {

/// Decides what to render next. Times are seconds on any clock that only goes forward.
class Schedule {
  public:
    static constexpr double kFrameTarget = 0.030;  ///< of a moving frame, presentation included
    static constexpr double kLeastScale = 0.5;     ///< of the window's sides: 640x360 of 1280x720
    static constexpr double kSettle = 0.15;        ///< without motion, then the view counts as still

    enum class Want { Nothing, Draft, Still };

    /// What is seen has changed; `moving`: by the hand, so that more changes are likely to follow.
    void change(double now, bool moving);
    /// Ends the motion at once: a button was let go.
    void settle() { last_motion_ = -1e9; }

    bool moving(double now) const { return now - last_motion_ < kSettle; }
    /// What to start, or to go on with. Drafts that are under way are finished, or fast motion would show nothing;
    /// stills that are not of the present view are dropped.
    Want want(double now, int target_samples) const;

    void beginDraft() { draft_ = current_ = true; }
    void beginStill() {
        draft_ = false;
        current_ = true;
        samples_ = 0;
    }
    void sampleDone() { ++samples_; }
    bool current() const { return current_; }  ///< what was begun last is of the present view
    bool draft() const { return draft_; }
    int samples() const { return draft_ ? 0 : samples_; }

    /// Share of the window's sides that drafts have.
    double scale() const { return scale_; }
    /// Whether drafts have cast shadows: not where even the smallest with them takes too long.
    bool shadows() const { return shadows_; }
    /// A draft at scale() took so long to render, and its frame so long beyond that.
    void draftTook(double seconds, double overhead);

  private:
    void chooseShadows(double room);

    double last_motion_ = -1e9;
    bool current_ = false, draft_ = false;
    int samples_ = 0;
    double scale_ = kLeastScale;
    bool shadows_ = true;
    double full_cost_ = -1.0;  ///< seconds of a draft at scale 1, smoothed; -1: not known
};

}  // namespace dsphere::viewer
