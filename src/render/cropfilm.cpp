#include "render/cropfilm.h"

#include <algorithm>

namespace dsphere {

CropFilm::CropFilm(gpu::Device& device, FilmPipelines& pipelines, const DeviceScene& scene, const Box& crop,
                   const std::vector<Span>& spans, std::uint32_t mask, int rows)
    : crop_(crop),
      film_(device, crop.width(), std::min(rows, crop.height()), mask),
      tracer_(device, pipelines, scene, film_.image()) {
    for (int y0 = 0; y0 < crop.height(); y0 += rows) {
        const int y1 = std::min(y0 + rows, crop.height());
        const std::vector<Span> own(spans.begin() + y0, spans.begin() + y1);
        bands_.push_back({{crop.x0, crop.y0 + y0, crop.x1, crop.y0 + y1},
                          TileRun(makeTiles(own, 0, crop.width(), tracer_.columns()), crop.x0, crop.y0 + y0)});
    }
    if (bands() > 1) pixels_ = film_.blank(crop, crop);
}

std::vector<Box> CropFilm::tiles() const {
    std::vector<Box> tiles;
    for (const Band& band : bands_) {
        const int down = band.box.y0 - crop_.y0;
        for (const Box& tile : band.run.tiles()) tiles.push_back({tile.x0, tile.y0 + down, tile.x1, tile.y1 + down});
    }
    return tiles;
}

void CropFilm::begin(const Image* sums) {
    empty_ = !sums;
    if (bands() > 1)
        pixels_ = sums ? *sums : film_.blank(crop_, crop_);
    else if (sums)
        film_.write(*sums, crop_);
    else if (!zeroed_)
        film_.clear();
}

TileRun& CropFilm::beginBand(int band) {
    Band& one = bands_[std::size_t(band)];
    zeroed_ = false;
    if (bands() > 1 && empty_)
        film_.clear();
    else if (bands() > 1)
        film_.write(pixels_, one.box);
    return one.run;
}

void CropFilm::endBand(int band) {
    Band& one = bands_[std::size_t(band)];
    one.run.rewind();
    if (bands() > 1) film_.read(pixels_, one.box);
    if (band == bands() - 1) empty_ = false;
}

Image CropFilm::read(const Box& display) const {
    Image image = bands() > 1 ? pixels_ : film_.blank(crop_, display);
    if (bands() == 1) film_.read(image, crop_);
    image.display = display;
    return image;
}

}  // namespace dsphere
