#include "bench/accuracy.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bench/pixelsize.h"
#include "reference/camera.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <random>

namespace dsphere::bench {

namespace {

constexpr std::size_t kChunk = 128;  // pixels a task

struct Part {
    verify::Report report;
    std::vector<float> pixels;  ///< errors as seen
};

void judgePixel(Part& part, const verify::Comparison& comparison, const View& view, const PixelSize& size,
                const PixelAnswer& answer, const PixelAnswer& exact) {
    const Box box = cropBox(view.film);
    const std::size_t width = std::size_t(box.width());
    const double x = box.x0 + double(answer.pixel % width) + 0.5, y = box.y0 + double(answer.pixel / width) + 0.5;
    const reference::CameraRay ray = reference::cameraRay(view.camera, view.film, x, y);
    const std::size_t before = part.report.distances.size();
    comparison.checkHit(part.report, answer.pixel, {ray.origin, ray.direction}, answer.answer);
    if (part.report.distances.size() > before)
        part.pixels.push_back(float(part.report.distances.back() * comparison.unit(0) / size.at(answer.answer.t)));
    if (answer.has_light && answer.answer.hit && exact.answer.hit && !exact.answer.inside) {
        verify::LightAnswer light;
        light.start = exact.start;
        light.lit = answer.lit ? 1u : 0u;
        comparison.checkShadow(part.report, answer.pixel, exact.answer, light, 0);
    }
    if (answer.runaway) ++part.report.runaways;
}

double quantile(std::vector<float>& values, double share) {
    if (values.empty()) return 0.0;
    const auto rank = std::size_t(std::ceil(share * double(values.size())));
    const auto place = values.begin() + std::ptrdiff_t(std::max<std::size_t>(rank, 1) - 1);
    std::ranges::nth_element(values, place);
    return *place;
}

report::Accuracy summarize(Part& all) {
    const verify::Report& report = all.report;
    return {.rays = report.rays,
            .hits = report.hits,
            .wrong_verdicts = report.wrong_verdicts,
            .later_roots = report.later_roots,
            .tangent = report.tangent,
            .shadow_rays = report.shadow_rays,
            .wrong_shadows = report.wrong_shadows,
            .tangent_shadows = report.tangent_shadows,
            .runaways = report.runaways,
            .distance_median = report.distanceQuantile(0.5),
            .distance_999 = report.distanceQuantile(0.999),
            .distance_greatest = report.distanceQuantile(1.0),
            .pixels_median = quantile(all.pixels, 0.5),
            .pixels_999 = quantile(all.pixels, 0.999),
            .pixels_greatest = quantile(all.pixels, 1.0)};
}

}  // namespace

std::vector<std::size_t> samplePixels(std::size_t total, std::uint64_t count) {
    std::vector<std::size_t> pixels;
    if (count >= total) {
        pixels.resize(total);
        std::iota(pixels.begin(), pixels.end(), std::size_t(0));
        return pixels;
    }
    std::mt19937_64 random(1);
    for (std::uint64_t k = 0; k < count; ++k) pixels.push_back(std::size_t(random() % total));
    return pixels;
}

report::Accuracy judge(const verify::Comparison& comparison, const View& view, const std::vector<PixelAnswer>& answers,
                       const std::vector<PixelAnswer>& exact, const Progress& progress) {
    const PixelSize size(view);
    Part total;
    std::mutex mutex;
    const std::size_t chunks = (answers.size() + kChunk - 1) / kChunk;
    std::size_t done = 0;
    parallelFor(chunks, [&](std::size_t chunk) {
        Part part;
        for (std::size_t k = chunk * kChunk; k < std::min((chunk + 1) * kChunk, answers.size()); ++k)
            judgePixel(part, comparison, view, size, answers[k], exact[k]);
        std::lock_guard lock(mutex);
        total.report.merge(std::move(part.report));
        total.pixels.insert(total.pixels.end(), part.pixels.begin(), part.pixels.end());
        if (progress && !progress(double(++done) / double(chunks))) throw Error(ExitCode::Interrupted, "interrupted");
    });
    return summarize(total);
}

}  // namespace dsphere::bench
