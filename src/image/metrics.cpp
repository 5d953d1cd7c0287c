#include "image/metrics.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace dsphere {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double valueAt(const Channel& channel, std::size_t k) {
    return channel.isFloat() ? double(channel.floats()[k]) : double(channel.uints()[k]);
}

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

double distance(double a, double b) {
    if (same(a, b)) return 0.0;
    const double d = std::abs(a - b);
    return std::isnan(d) ? kInfinity : d;
}

/// An order of differences that puts a NaN in one picture only beyond an infinity.
bool isWorse(double a, double b, double than_a, double than_b) {
    const double here = distance(a, b), there = distance(than_a, than_b);
    if (here != there) return here > there;
    return here == kInfinity && std::isnan(a) != std::isnan(b) && std::isnan(than_a) == std::isnan(than_b);
}

}  // namespace

Comparison comparePictures(const Image& a, const Image& b, const std::vector<std::string>& channels) {
    assert(a.data.width() == b.data.width() && a.data.height() == b.data.height() && !channels.empty());
    const std::size_t width = std::size_t(a.data.width());
    Comparison result;
    double sum = 0.0, squares = 0.0;
    for (const std::string& name : channels) {
        const Channel &in_a = a.at(name), &in_b = b.at(name);
        for (std::size_t k = 0; k < a.pixelCount(); ++k) {
            const double value_a = valueAt(in_a, k), value_b = valueAt(in_b, k);
            const double d = distance(value_a, value_b);
            if (d == 0.0) continue;
            sum += d;
            squares += d * d;
            result.non_finite += d == kInfinity;
            if (!result.worst || isWorse(value_a, value_b, result.worst->a, result.worst->b))
                result.worst = {a.data.x0 + int(k % width), a.data.y0 + int(k / width), name, value_a, value_b};
        }
    }
    const double count = double(a.pixelCount()) * double(channels.size());
    result.mae = sum / count;
    result.rmse = std::sqrt(squares / count);
    result.psnr = -20.0 * std::log10(result.rmse);
    if (result.worst) result.max = distance(result.worst->a, result.worst->b);
    return result;
}

Image differencePicture(const Image& a, const Image& b, const std::vector<std::string>& channels) {
    Image result{a.data, a.display, {}};
    for (const std::string& name : channels) {
        const Channel &in_a = a.at(name), &in_b = b.at(name);
        std::vector<float>& out = result.addFloat(name).floats();
        for (std::size_t k = 0; k < out.size(); ++k) {
            const double value_a = valueAt(in_a, k), value_b = valueAt(in_b, k);
            out[k] = same(value_a, value_b) ? 0.0f : float(value_b - value_a);
        }
    }
    return result;
}

}  // namespace dsphere
