// Answers whose errors are known.

#include "bench/accuracy.h"
#include "bench/suite.h"
#include "reference/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace dsphere::bench {
namespace {

class AccuracyTest : public testing::Test {
  protected:
    AccuracyTest() {
        Suite suite{.widths = {64}, .percents = {10.0}, .views = {"whole"}, .width = 40, .height = 24};
        workload_ = suiteSources(suite)[0].make();
        comparison_.emplace(workload_.scene, workload_.maps, verify::Comparison::Tolerance::Approximate);
    }

    const View& view() const { return workload_.views[0]; }
    double unit() const { return comparison_->unit(0); }

    /// The reference's own answers, each hit moved along its ray.
    std::vector<PixelAnswer> answers(double along = 0.0) const {
        std::vector<PixelAnswer> result;
        for (std::size_t pixel = 0; pixel < 40 * 24; ++pixel) {
            auto ray =
                reference::cameraRay(view().camera, view().film, double(pixel % 40) + 0.5, double(pixel / 40) + 0.5);
            reference::WorldHit hit = comparison_->tracer().firstHit(ray.origin, ray.direction);
            PixelAnswer answer;
            answer.pixel = pixel;
            answer.answer.hit = hit.hit;
            if (hit.hit) {
                answer.answer.shape = 0;
                answer.answer.t = hit.t() + along;
                answer.answer.object_position = hit.object_position + along * ray.direction;
                answer.answer.normal = hit.normal;
                answer.start = hit.object_position + 1e-6 * hit.normal;
                dvec3 sun = std::get<DistantLight>(workload_.scene.lights[0]).direction;
                answer.lit = glm::dot(hit.normal, sun) > 0.0 &&
                             !comparison_->tracer().occluded(answer.start, sun, 1e9, 0, answer.start);
            }
            result.push_back(answer);
        }
        return result;
    }

    report::Accuracy judged(const std::vector<PixelAnswer>& given) const {
        return judge(*comparison_, view(), given, answers(), {});
    }

    Workload workload_;
    std::optional<verify::Comparison> comparison_;
};

TEST_F(AccuracyTest, TheTruthHasNoError) {
    report::Accuracy accuracy = judged(answers());
    EXPECT_EQ(accuracy.rays, 40u * 24u);
    EXPECT_GT(accuracy.hits, 200u);
    EXPECT_EQ(accuracy.wrong_verdicts + accuracy.later_roots + accuracy.wrong_shadows + accuracy.tangent, 0u);
    EXPECT_EQ(accuracy.shadow_rays, accuracy.hits);
    EXPECT_LT(accuracy.distance_greatest, 1e-12);
}

// An approximation is no fault; its distance says how good it is, and pixels count that as it is seen.
TEST_F(AccuracyTest, ASmallShiftIsDistanceAlone) {
    report::Accuracy accuracy = judged(answers(-1e-4));
    EXPECT_EQ(accuracy.wrong_verdicts + accuracy.later_roots + accuracy.wrong_shadows, 0u);
    EXPECT_GT(accuracy.distance_median, 1e-5);
    EXPECT_LE(accuracy.distance_greatest, 1.01e-4 / unit());
    double pixel = 2.0 * std::tan(glm::radians(0.5 * view().camera.fov_degrees)) / 24.0;
    double ratio = accuracy.pixels_median / (accuracy.distance_median * unit());
    EXPECT_GT(ratio, 1.0 / (pixel * 4.0 * unit()));
    EXPECT_LT(ratio, 1.0 / (pixel * 2.0 * unit()));
}

TEST_F(AccuracyTest, MissesAndFarSidesAreFaults) {
    std::vector<PixelAnswer> given = answers();
    std::vector<PixelAnswer*> hits;
    for (PixelAnswer& answer : given)
        if (answer.answer.hit) hits.push_back(&answer);
    *hits[hits.size() / 2] = {.pixel = hits[hits.size() / 2]->pixel, .answer = {}, .start = dvec3(0.0)};
    // The second meeting of a ray with the surface: on it, and wrong.
    PixelAnswer& later = *hits[hits.size() / 2 + 1];
    auto ray = reference::cameraRay(view().camera, view().film, double(later.pixel % 40) + 0.5,
                                    double(later.pixel / 40) + 0.5);
    const reference::Surface& surface = *comparison_->tracer().surface(0);
    double inside = later.answer.t + 0.2, outside = later.answer.t + 4.0;
    for (int k = 0; k < 60; ++k) {
        double middle = 0.5 * (inside + outside);
        (surface.f(ray.origin + middle * ray.direction) < 0.0 ? inside : outside) = middle;
    }
    later.answer.t = inside;
    later.answer.object_position = ray.origin + inside * ray.direction;
    report::Accuracy accuracy = judged(given);
    EXPECT_EQ(accuracy.wrong_verdicts, 1u);
    EXPECT_EQ(accuracy.later_roots, 1u);
}

TEST_F(AccuracyTest, WrongShadowsAreCounted) {
    std::vector<PixelAnswer> given = answers();
    for (PixelAnswer& answer : given) answer.lit = !answer.lit;
    report::Accuracy accuracy = judged(given);
    EXPECT_EQ(accuracy.wrong_shadows + accuracy.tangent_shadows, accuracy.shadow_rays);
    EXPECT_GT(accuracy.wrong_shadows, 200u);
}

TEST(SamplePixels, AreTheSameEveryTimeAndInside) {
    std::vector<std::size_t> pixels = samplePixels(1000, 100);
    EXPECT_EQ(pixels.size(), 100u);
    EXPECT_EQ(pixels, samplePixels(1000, 100));
    for (std::size_t pixel : pixels) EXPECT_LT(pixel, 1000u);
    EXPECT_EQ(samplePixels(50, 100).size(), 50u);
    std::vector<std::size_t> all = samplePixels(50, 50);
    EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), 50u);
}

}  // namespace
}  // namespace dsphere::bench
