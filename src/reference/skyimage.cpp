#include "reference/skyimage.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {
namespace {

double brightness(const dvec3& rgb) {
    return std::max(0.0, 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b);
}

// The mean of the bilinear image's brightness over a texel: 1/8, 3/4, 1/8 of the texels about it, each way. A black
// texel beside a bright one is not dark all over, so it must be drawn too.
double meanBrightness(const ColourMap& image, int i, int j) {
    constexpr double kShares[] = {0.125, 0.75, 0.125};
    double sum = 0.0;
    for (int south = -1; south <= 1; ++south)
        for (int east = -1; east <= 1; ++east)
            sum += kShares[south + 1] * kShares[east + 1] *
                   brightness(image.texel((i + east + image.width()) % image.width(),
                                          std::clamp(j + south, 0, image.height() - 1)));
    return sum;
}

dvec2 placeOf(const dvec3& direction) {
    const double turn = std::atan2(direction.y, direction.x) / (2.0 * kPi);
    return {turn - std::floor(turn), std::atan2(std::hypot(direction.x, direction.y), direction.z) / kPi};
}

/// Sums before each entry over all; of entries that are all 0 as if they were alike.
void accumulate(const std::vector<double>& weights, std::vector<double>& sums) {
    double total = 0.0, before = 0.0;
    for (double weight : weights) total += weight;
    const double share = total > 0.0 ? 1.0 / total : 0.0, alike = total > 0.0 ? 0.0 : 1.0 / double(weights.size());
    sums.push_back(0.0);
    for (double weight : weights) sums.push_back(before += weight * share + alike);
    sums.back() = 1.0;
}

struct Step {
    int index;
    double within;  ///< [0, 1)
};

/// Where u falls among `count` steps that grow from sums[0] = 0 to sums[count] = 1.
Step find(const double* sums, int count, double u) {
    const double* after = std::upper_bound(sums, sums + count + 1, u);
    const int index = std::clamp(int(after - sums) - 1, 0, count - 1);
    return {index, (u - sums[index]) / (sums[index + 1] - sums[index])};
}

}  // namespace

SkyImage::SkyImage(const ColourMap& image) : image_(&image) {
    std::vector<double> totals;
    for (int j = 0; j < image.height(); ++j) {
        std::vector<double> row;
        double total = 0.0;
        for (int i = 0; i < image.width(); ++i) {
            row.push_back(meanBrightness(image, i, j));
            total += row.back();
        }
        accumulate(row, rows_);
        totals.push_back(total * std::sin(kPi * (j + 0.5) / image.height()));
    }
    accumulate(totals, marginal_);
}

dvec3 SkyImage::radiance(const dvec3& direction) const {
    const dvec2 place = placeOf(direction);
    const int width = image_->width(), last = image_->height() - 1;
    const double x = place.x * width - 0.5, y = std::clamp(place.y * image_->height() - 0.5, 0.0, double(last));
    const int west = int(std::floor(x)), north = std::min(int(y), std::max(0, last - 1));
    auto row = [&](int j) {
        return glm::mix(image_->texel((west + width) % width, j), image_->texel((west + 1) % width, j), x - west);
    };
    return glm::mix(row(north), row(std::min(north + 1, last)), y - north);
}

double SkyImage::texelShare(int i, int j) const {
    const std::size_t at = std::size_t(j) * std::size_t(image_->width() + 1) + std::size_t(i);
    return (marginal_[std::size_t(j) + 1] - marginal_[std::size_t(j)]) * (rows_[at + 1] - rows_[at]);
}

SkyImage::Sample SkyImage::sample(const dvec2& u) const {
    const int width = image_->width(), height = image_->height();
    const Step row = find(marginal_.data(), height, u.y);
    const Step column = find(&rows_[std::size_t(row.index) * std::size_t(width + 1)], width, u.x);
    const double a = (column.index + column.within) / width, b = (row.index + row.within) / height;
    const double sine = std::sin(kPi * b);
    return {{std::cos(2.0 * kPi * a) * sine, std::sin(2.0 * kPi * a) * sine, std::cos(kPi * b)},
            texelShare(column.index, row.index) * width * height / (2.0 * kPi * kPi * sine)};
}

double SkyImage::density(const dvec3& direction) const {
    const dvec2 place = placeOf(direction);
    const int width = image_->width(), height = image_->height();
    const int i = std::min(int(place.x * width), width - 1), j = std::min(int(place.y * height), height - 1);
    return texelShare(i, j) * width * height / (2.0 * kPi * kPi * std::hypot(direction.x, direction.y));
}

}  // namespace dsphere::reference
