#include "surface/blurredmap.h"

#include "surface/blur.h"
#include "surface/tiledheights.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

namespace dsphere {

namespace {

class BlurredMap : public geo::LargeMap {
  public:
    BlurredMap(std::shared_ptr<const geo::LargeMap> source, Gaps gaps, double sigma)
        : filled_(std::move(source), std::move(gaps)), sigma_(sigma), head_(filled_.source().head()) {
        head_.unknown_are_nan = false;
    }

    const RawMap& head() const override { return head_; }
    geo::SampleKind kind() const override { return geo::SampleKind::Float32; }
    std::optional<int> unknownCode() const override { return {}; }
    void read(int x, int y, int width, int height, void* to) const override {
        const int radius = int(blurRadius(sigma_)), columns = width + 2 * radius, rows = height + 2 * radius;
        std::vector<float> window(std::size_t(columns) * std::size_t(rows));
        const int turns = radius / head_.width + 1;  // a column before the first is one before the last
        geo::withSampleType(filled_.kind(), [&](auto sample) {
            std::vector<decltype(sample)> samples(window.size());
            filled_.read(x - radius + turns * head_.width, y - radius, columns, rows, samples.data());
            std::ranges::copy(samples, window.begin());
        });
        blurWindow(window, columns, rows, sigma_, static_cast<float*>(to));
    }
    std::vector<float> overview(int columns, int rows) const override {
        return filled_.source().overview(columns, rows);
    }
    std::string identity() const override { return filled_.source().identity(); }

  private:
    TiledHeights filled_;
    double sigma_;
    RawMap head_;
};

}  // namespace

std::shared_ptr<const geo::LargeMap> blurredMap(std::shared_ptr<const geo::LargeMap> source, Gaps gaps, double sigma) {
    assert(sigma > 0.0 && sigma <= kMostTiledBlur);
    return std::make_shared<BlurredMap>(std::move(source), std::move(gaps), sigma);
}

}  // namespace dsphere
