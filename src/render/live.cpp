#include "render/live.h"

#include <algorithm>
#include <cassert>

namespace dsphere {

LiveFilm::LiveFilm(gpu::Device& device, Renderer& renderer, int width, int height, std::uint32_t mask)
    : device_(device), renderer_(renderer), film_(device, width, height, mask) {}

void LiveFilm::prepare(const MarchMethod& method) {
    if (!passes_.contains(method))
        passes_.try_emplace(method, device_, renderer_.pipelines(method, film_.mask()), renderer_.deviceScene(),
                            film_.image());
}

void LiveFilm::begin(std::vector<LivePart> parts, Sampling sampling, std::uint32_t seed) {
    box_ = renderer_.crop();
    assert(!parts.empty() && box_.width() <= int(film_.image().width()) &&
           box_.height() <= int(film_.image().height()));
    parts_ = std::move(parts);
    runs_.clear();
    for (const LivePart& part : parts_) {
        prepare(part.method);
        runs_.emplace_back(makeTiles(renderer_.spans(), part.x0, part.x1), box_.x0, box_.y0);
    }
    film_.clear();
    part_ = 0;
    first_ = sampling == Sampling::Jittered ? 0 : -1;
    samples_ = 0;
    seed_ = seed;
    seconds_ = 0.0;
}

bool LiveFilm::step(double target) {
    TileRun& run = runs_[part_];
    if (!run.done()) seconds_ += run.step(passes_.at(parts_[part_].method), first_ + samples_, seed_, target);
    if (!run.done()) return false;
    if (++part_ < runs_.size()) return false;
    part_ = 0;
    for (TileRun& one : runs_) one.rewind();
    ++samples_;
    sample_seconds_ = seconds_;
    seconds_ = 0.0;
    return true;
}

Image LiveFilm::read() const {
    assert(between() && samples_ > 0);
    Image image = film_.read(box_, {0, 0, box_.width(), box_.height()});
    takeMean(image, samples_);
    return image;
}

}  // namespace dsphere
