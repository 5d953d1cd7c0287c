#pragma once

#include "render/devicefilm.h"
#include "render/renderer.h"
#include "render/tiles.h"

#include <map>
#include <optional>
#include <vector>

namespace dsphere {

/// Columns [x0, x1) of a picture and how they are marched.
struct FilmPart {
    MarchMethod method;
    int x0 = 0, x1 = 0;
};

/// Where in the pixels rays go: samples 0, 1, 2..., or one sample at the centres.
enum class Sampling { Jittered, Centres };

/// A picture that grows sample by sample between other work: sample i of it is sample i of Renderer::renderColour.
class ProgressiveFilm {
  public:
    /// Holds pictures of up to width x height. The renderer must outlive it.
    ProgressiveFilm(gpu::Device& device, Renderer& renderer, int width, int height, std::uint32_t mask);

    /// Makes ready what begin() needs of a method, so that it does not take its time then.
    void prepare(const MarchMethod& method);
    /// Starts a picture with the renderer's camera and film, which must fit.
    void begin(std::vector<FilmPart> parts, Sampling sampling, std::uint32_t seed);
    /// One submission of about `target` seconds at most; true if it completed a sample, which takes several.
    bool step(double target);

    int samples() const { return samples_; }                               ///< complete ones
    bool between() const { return part_ == 0 && !runs_.front().begun(); }  ///< no sample is half done
    /// Where film() has one sample more than sumSamples(), of a sample that is half done.
    RowByRow ahead() const;
    /// Of the sample that is being made, 0 to 1.
    double share() const { return (double(part_) + runs_[part_].share()) / double(runs_.size()); }
    int width() const { return box_.width(); }
    int height() const { return box_.height(); }
    double sampleSeconds() const { return sample_seconds_; }  ///< on the device, of the last complete sample

    bool fits(std::uint32_t mask, int width, int height) const {
        return film_.mask() == mask && int(film_.image().width()) >= width && int(film_.image().height()) >= height;
    }
    std::uint32_t mask() const { return film_.mask(); }
    int mostWidth() const { return int(film_.image().width()); }  ///< of pictures that it has room for
    int mostHeight() const { return int(film_.image().height()); }

    /// The sums of the complete samples, or of as many as sumSamples() says while one is half done.
    const DeviceFilm& film();
    int sumSamples() const;
    /// The mean of the samples; between() samples only.
    Image read() const;

  private:
    FilmTracer& tracerOf(const MarchMethod& method);
    void endBlock();
    Image sums() const;

    gpu::Device& device_;
    Renderer& renderer_;
    DeviceFilm film_;
    std::map<MarchMethod, FilmTracer> tracers_;
    // Beyond a block of samples: the blocks that are complete, and where the next one is rendered. film_ then holds the
    // sum of as many samples as it was last asked for.
    SampleSums blocks_;
    int shown_samples_ = 0;
    std::optional<DeviceFilm> block_film_;
    std::map<MarchMethod, FilmTracer> block_tracers_;
    std::vector<FilmPart> parts_;
    std::vector<TileRun> runs_;  ///< one a part
    Box box_;
    std::size_t part_ = 0;
    int first_ = 0, samples_ = 0;
    std::uint32_t seed_ = 0;
    double seconds_ = 0.0, sample_seconds_ = 0.0;
};

}  // namespace dsphere
