#pragma once

#include "viewer/edits.h"
#include "viewer/show.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dsphere::viewer {

/// All that the user has chosen but the file and the panels that are open: the rest of the window follows from it.
struct State {
    Camera camera;
    std::size_t target = 0;  ///< the shape that the panel changes, and that turns
    ViewSettings view;
    ToneSettings tone;
    Edits edits;
    std::vector<std::string> recorded;  ///< keys that were added to the path file: its lines

    bool operator==(const State&) const = default;
};

/// The states that undo goes back through.
class History {
  public:
    static constexpr std::size_t kMost = 200;

    /// Forgets all; `first` is what undo ends at.
    void start(const State& first) {
        states_ = {first};
        present_ = 0;
    }
    /// After a change that is complete: what could be redone is forgotten.
    void add(const State& state) {
        if (states_.empty() || state == states_[present_]) return;
        states_.resize(present_ + 1);
        states_.push_back(state);
        if (states_.size() > kMost) states_.erase(states_.begin());
        present_ = states_.size() - 1;
    }
    /// Changes all states, which then hold what can be gone back to: those that become alike are one from then on.
    template <typename Change>
    void amend(const Change& change) {
        std::vector<State> kept;
        std::size_t present = 0;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            change(states_[i]);
            if (kept.empty() || !(kept.back() == states_[i])) kept.push_back(std::move(states_[i]));
            if (i == present_) present = kept.size() - 1;
        }
        states_ = std::move(kept);
        present_ = present;
    }
    /// The state before (-1) or after (+1); null at the ends.
    const State* step(int by) {
        if (by < 0 ? present_ == 0 : present_ + 1 >= states_.size()) return nullptr;
        present_ = by < 0 ? present_ - 1 : present_ + 1;
        return &states_[present_];
    }

  private:
    std::vector<State> states_;
    std::size_t present_ = 0;
};

}  // namespace dsphere::viewer
