#include "surface/blur.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/parallel.h"

namespace dsphere {
namespace {

// Neighbouring sums that are formed together, which the compiler turns into vector instructions.
constexpr std::size_t kLanes = 16;

/// Weights of the texels at -r ... r.
std::vector<double> makeKernel(double sigma) {
    const std::ptrdiff_t radius = blurRadius(sigma);
    std::vector<double> kernel;
    double sum = 0.0;
    for (std::ptrdiff_t k = -radius; k <= radius; ++k) {
        const double x = double(k) / sigma;  // x * x overflows to a weight of 0 for the least of sigmas
        sum += kernel.emplace_back(std::exp(-0.5 * x * x));
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

/// out[lane] = sum over k of kernel[k] * in[k * step + lane], for `lanes` lanes; `in` has kLanes readable in each.
void convolve(const std::vector<double>& kernel, const float* in, std::size_t step, float* out, std::size_t lanes) {
    std::array<double, kLanes> sums{};
    for (const double weight : kernel) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += weight * double(in[lane]);
        in += step;
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) out[lane] = float(sums[lane]);
}

void blurRow(const std::vector<double>& kernel, float* row, std::size_t width) {
    const std::size_t radius = kernel.size() / 2;
    const std::size_t before = (width - radius % width) % width;  // the column that stands `radius` before column 0
    std::vector<float> wrapped(width + 2 * radius + kLanes);
    for (std::size_t i = 0; i < wrapped.size(); ++i) wrapped[i] = row[(before + i) % width];
    for (std::size_t i = 0; i < width; i += kLanes)
        convolve(kernel, &wrapped[i], 1, row + i, std::min(kLanes, width - i));
}

/// Blurs `lanes` columns, `samples` pointing to the first row's.
void blurColumns(const std::vector<double>& kernel, float* samples, std::size_t width, std::size_t height,
                 std::size_t lanes) {
    const std::size_t radius = kernel.size() / 2;
    std::vector<float> clamped((height + 2 * radius) * kLanes);
    for (std::size_t j = 0; j < height + 2 * radius; ++j) {
        const std::size_t row = std::min(std::max(j, radius) - radius, height - 1);
        std::copy_n(samples + row * width, lanes, &clamped[j * kLanes]);
    }
    for (std::size_t j = 0; j < height; ++j) convolve(kernel, &clamped[j * kLanes], kLanes, samples + j * width, lanes);
}

}  // namespace

std::ptrdiff_t blurRadius(double sigma) {
    return std::ptrdiff_t(std::ceil(3.0 * sigma));
}

void blurMap(std::vector<float>& samples, int width, int height, double sigma) {
    assert(sigma > 0.0 && samples.size() == std::size_t(width) * std::size_t(height));
    const std::vector<double> kernel = makeKernel(sigma);
    const auto columns = std::size_t(width), rows = std::size_t(height);
    parallelFor(rows, [&](std::size_t j) { blurRow(kernel, &samples[j * columns], columns); });
    parallelFor((columns + kLanes - 1) / kLanes, [&](std::size_t block) {
        const std::size_t left = block * kLanes;
        blurColumns(kernel, &samples[left], columns, rows, std::min(kLanes, columns - left));
    });
}

void blurWindow(std::vector<float>& window, int width, int height, double sigma, float* to) {
    const std::vector<double> kernel = makeKernel(sigma);
    const std::size_t margin = kernel.size() - 1, stride = std::size_t(width), rows = std::size_t(height);
    assert(stride > margin && rows > margin && window.size() == stride * rows);
    const std::size_t columns = stride - margin;
    window.resize(window.size() + kLanes);
    std::vector<float> along(columns * rows + kLanes);
    const auto eachLanes = [columns](const auto& visit) {
        for (std::size_t i = 0; i < columns; i += kLanes) visit(i, std::min(kLanes, columns - i));
    };
    for (std::size_t j = 0; j < rows; ++j)
        eachLanes([&](std::size_t i, std::size_t lanes) {
            convolve(kernel, &window[j * stride + i], 1, &along[j * columns + i], lanes);
        });
    for (std::size_t j = 0; j < rows - margin; ++j)
        eachLanes([&](std::size_t i, std::size_t lanes) {
            convolve(kernel, &along[j * columns + i], columns, to + j * columns + i, lanes);
        });
}

}  // namespace dsphere
