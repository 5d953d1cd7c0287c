#include "viewer/schedule.h"

#include <algorithm>
#include <cmath>

namespace dsphere::viewer {

void Schedule::change(double now, bool moving) {
    current_ = false;
    if (moving) last_motion_ = now;
}

Schedule::Want Schedule::want(double now, int target_samples) const {
    if (!current_) return moving(now) ? Want::Draft : Want::Still;
    if (draft_) return moving(now) ? Want::Nothing : Want::Still;
    return samples_ < target_samples ? Want::Still : Want::Nothing;
}

// Shadows cost as much as all else, so they come back only where the rest takes less than half of the room.
void Schedule::chooseShadows(double room) {
    const double least = full_cost_ * kLeastScale * kLeastScale;
    if (shadows_ && least > room) {
        shadows_ = false;
        full_cost_ *= 0.5;
    } else if (!shadows_ && least < 0.4 * room) {
        shadows_ = true;
        full_cost_ *= 2.0;
    }
}

// A draft costs as its area does. Steps of 1/16, and up only with room to spare: a picture whose sharpness wavers is
// worse than one that stays a little coarser.
void Schedule::draftTook(double seconds, double overhead) {
    double cost = seconds / (scale_ * scale_);
    full_cost_ = full_cost_ < 0.0 ? cost : 0.7 * full_cost_ + 0.3 * cost;
    double room = std::max(kFrameTarget - overhead, 0.001);
    chooseShadows(room);
    double ideal = std::sqrt(room / std::max(full_cost_, 1e-6));
    if (ideal < scale_)
        scale_ = std::floor(16.0 * ideal) / 16.0;
    else if (ideal > scale_ + 1.5 / 16.0)
        scale_ = std::floor(16.0 * (ideal - 0.5 / 16.0)) / 16.0;
    scale_ = std::clamp(scale_, kLeastScale, 1.0);
}

}  // namespace dsphere::viewer
