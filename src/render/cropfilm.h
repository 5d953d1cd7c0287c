#pragma once

#include "render/devicefilm.h"
#include "render/filmtracer.h"
#include "render/spans.h"
#include "render/tiles.h"

#include <vector>

namespace dsphere {

/// The film of one crop. Where it is higher than `rows`, the device holds one band of so many rows at a time: the
/// pixels of the others lie on the host meanwhile, and come and go once a sample.
class CropFilm {
  public:
    /// Zeroed. `spans` are those of the crop's rows. gpu::OutOfMemory when the device refuses `rows` of them. All that
    /// is given must outlive the film.
    CropFilm(gpu::Device& device, FilmPipelines& pipelines, const DeviceScene& scene, const Box& crop,
             const std::vector<Span>& spans, std::uint32_t mask, int rows);

    int bands() const { return int(bands_.size()); }
    FilmTracer& tracer() { return tracer_; }
    /// Of all bands, in pixels of the crop.
    std::vector<Box> tiles() const;

    /// With these sums of the crop's pixels; null: with none.
    void begin(const Image* sums);
    /// The tiles of a band, which is on the device until endBand(). A sample is one turn of all bands.
    TileRun& beginBand(int band);
    void endBand(int band);
    /// After a turn of all bands.
    Image read(const Box& display) const;

  private:
    struct Band {
        Box box;
        TileRun run;
    };

    Box crop_;
    DeviceFilm film_;
    FilmTracer tracer_;
    std::vector<Band> bands_;
    Image pixels_;        ///< of several bands
    bool empty_ = true;   ///< there are no pixels_ yet
    bool zeroed_ = true;  ///< the film is as it was made
};

}  // namespace dsphere
