#include "render/progressivefilm.h"

#include <algorithm>
#include <cassert>

namespace dsphere {

ProgressiveFilm::ProgressiveFilm(gpu::Device& device, Renderer& renderer, int width, int height, std::uint32_t mask)
    : device_(device), renderer_(renderer), film_(device, width, height, mask) {}

void ProgressiveFilm::prepare(const MarchMethod& method) {
    if (!tracers_.contains(method))
        tracers_.try_emplace(method, device_, renderer_.pipelines(method, film_.mask()), renderer_.deviceScene(),
                             film_.image());
}

void ProgressiveFilm::begin(std::vector<FilmPart> parts, Sampling sampling, std::uint32_t seed) {
    box_ = renderer_.crop();
    assert(!parts.empty() && box_.width() <= int(film_.image().width()) &&
           box_.height() <= int(film_.image().height()));
    parts_ = std::move(parts);
    runs_.clear();
    for (const FilmPart& part : parts_) {
        prepare(part.method);
        const int columns = tracers_.at(part.method).columns();
        runs_.emplace_back(makeTiles(renderer_.spans(), part.x0, part.x1, columns), box_.x0, box_.y0);
    }
    film_.clear();
    blocks_ = {};
    shown_samples_ = 0;
    part_ = 0;
    first_ = sampling == Sampling::Jittered ? 0 : -1;
    samples_ = 0;
    seed_ = seed;
    seconds_ = 0.0;
}

FilmTracer& ProgressiveFilm::tracerOf(const MarchMethod& method) {
    if (blocks_.samples() == 0) return tracers_.at(method);
    return block_tracers_
        .try_emplace(method, device_, renderer_.pipelines(method, film_.mask()), renderer_.deviceScene(),
                     block_film_->image())
        .first->second;
}

// Blocks are added up as Renderer::renderSums() does it, so that the picture is the same.
void ProgressiveFilm::endBlock() {
    const DeviceFilm& block = blocks_.samples() > 0 ? *block_film_ : film_;
    blocks_.append({samples_ - kSumBlock, samples_, block.read(box_, box_)});
    if (!block_film_)
        block_film_.emplace(device_, int(film_.image().width()), int(film_.image().height()), film_.mask());
    else
        block_film_->clear();
}

Image ProgressiveFilm::sums() const {
    assert(between() && samples_ > 0);
    if (blocks_.samples() == 0) return film_.read(box_, box_);
    Image sums = blocks_.total();
    if (samples_ > blocks_.samples()) addSums(sums, block_film_->read(box_, box_));
    return sums;
}

const DeviceFilm& ProgressiveFilm::film() {
    if (blocks_.samples() > 0 && shown_samples_ != samples_ && between()) {
        film_.write(sums(), box_);
        shown_samples_ = samples_;
    }
    return film_;
}

// Until it is asked for the sums of later ones, the film has those of the first block.
int ProgressiveFilm::sumSamples() const {
    if (blocks_.samples() == 0 || (between() && shown_samples_ == samples_)) return samples_;
    return shown_samples_ > 0 ? shown_samples_ : kSumBlock;
}

RowByRow ProgressiveFilm::ahead() const {
    if (between() || blocks_.samples() > 0) return {};
    RowByRow done = runs_[part_].doneRows();
    done.x0 = parts_[part_].x0;
    done.x1 = parts_[part_].x1;
    return done;
}

bool ProgressiveFilm::step(double target) {
    TileRun& run = runs_[part_];
    if (!run.done()) seconds_ += run.step(tracerOf(parts_[part_].method), first_ + samples_, seed_, target);
    if (!run.done()) return false;
    if (++part_ < runs_.size()) return false;
    part_ = 0;
    for (TileRun& one : runs_) one.rewind();
    ++samples_;
    if (film_.mask() == kColourPlanes && samples_ % kSumBlock == 0) endBlock();
    sample_seconds_ = seconds_;
    seconds_ = 0.0;
    return true;
}

Image ProgressiveFilm::read() const {
    Image image = sums();
    image.display = {0, 0, box_.width(), box_.height()};
    takeMean(image, samples_);
    return image;
}

}  // namespace dsphere
