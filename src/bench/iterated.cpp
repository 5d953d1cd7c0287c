#include "bench/iterated.h"

#include "base/parallel.h"
#include "bench/devicecontender.h"
#include "reference/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::bench {

namespace {

constexpr int kMostTurns = 100;
constexpr double kShareOfPixel = 0.01;

// The nearest t >= 0 at which a ray is at that distance of the centre.
std::optional<double> sphereHit(const dvec3& origin, const dvec3& direction, double radius) {
    const double a = glm::dot(direction, direction), middle = -glm::dot(origin, direction) / a;
    const dvec3 nearest = origin + middle * direction;
    const double square = (radius * radius - glm::dot(nearest, nearest)) / a;
    if (!(square >= 0.0)) return {};
    const double half = std::sqrt(square);
    if (middle - half >= 0.0) return middle - half;
    return middle + half >= 0.0 ? std::optional(middle + half) : std::nullopt;
}

class IteratedContender : public Contender {
  public:
    IteratedContender(const Workload& workload, const View& view, bool secant)
        : view_(view),
          search_(workload, secant),
          object_from_world_(glm::inverse(workload.scene.shapes[0].world_from_object)),
          box_(cropBox(view.film)),
          t_(std::size_t(box_.width()) * std::size_t(box_.height())) {}

    Timing tracePrimary() override {
        const double start = wallSeconds();
        const PixelSize pixel(view_);
        parallelFor(std::size_t(box_.height()), [&](std::size_t y) {
            for (std::size_t x = 0; x < std::size_t(box_.width()); ++x) {
                const std::size_t k = y * std::size_t(box_.width()) + x;
                const Ray ray = rayOf(k);
                t_[k] = float(search_.find(ray.origin, ray.direction, pixel).value_or(kMiss));
            }
        });
        const double seconds = wallSeconds() - start;
        return {seconds, seconds};
    }
    Timing traceShadows() override { return {}; }
    std::uint64_t shadowRays() const override { return 0; }

    Answers answer(std::span<const std::size_t> pixels) override {
        tracePrimary();
        Answers answers;
        answers.hits = std::uint64_t(std::ranges::count_if(t_, [](float t) { return t < kMiss; }));
        const PixelSize pixel(view_);
        for (const std::size_t k : pixels) {
            const Ray ray = rayOf(k);
            PixelAnswer result;
            result.pixel = k;
            result.has_light = false;
            if (const std::optional<double> t = search_.find(ray.origin, ray.direction, pixel)) {
                result.answer.hit = true;
                result.answer.shape = 0;
                result.answer.t = *t;
                result.answer.object_position = ray.origin + *t * ray.direction;
                result.answer.normal = glm::normalize(result.answer.object_position);
            }
            answers.pixels.push_back(result);
        }
        return answers;
    }

  private:
    static constexpr double kMiss = std::numeric_limits<double>::infinity();

    struct Ray {
        dvec3 origin, direction;
    };
    Ray rayOf(std::size_t pixel) const {
        const std::size_t width = std::size_t(box_.width());
        const double x = box_.x0 + double(pixel % width) + 0.5, y = box_.y0 + double(pixel / width) + 0.5;
        const reference::CameraRay ray = reference::cameraRay(view_.camera, view_.film, x, y);
        return {transformPoint(object_from_world_, ray.origin), transformVector(object_from_world_, ray.direction)};
    }

    View view_;
    IteratedSearch search_;
    dmat4 object_from_world_;
    Box box_;
    std::vector<float> t_;
};

}  // namespace

IteratedSearch::IteratedSearch(const Workload& workload, bool secant)
    : relief_(workload.maps.reliefs[0]),
      heights_(*workload.maps.maps[0], relief_.filter),
      start_radius_(0.5 * (relief_.least_radius + relief_.greatest_radius)),
      secant_(secant) {}

double IteratedSearch::groundRadius(const dvec3& p) const {
    const double longitude = std::atan2(p.x, p.z), colatitude = std::atan2(std::hypot(p.x, p.z), p.y);
    return relief_.base + relief_.scale * heights_.at(longitude, colatitude).value;
}

std::optional<double> IteratedSearch::find(const dvec3& origin, const dvec3& direction, const PixelSize& pixel) const {
    std::optional<double> t = sphereHit(origin, direction, start_radius_);
    double last = 0.0, last_excess = 0.0;
    for (int turn = 0; t && turn < kMostTurns; ++turn) {
        const dvec3 p = origin + *t * direction;
        const double ground = groundRadius(p), excess = glm::length(p) - ground;
        std::optional<double> next;
        if (secant_ && turn > 0) {
            const double stepped = *t - excess * (*t - last) / (excess - last_excess);
            if (stepped >= 0.0 && std::isfinite(stepped)) next = stepped;
        } else {
            next = sphereHit(origin, direction, ground);
        }
        if (!next || std::abs(*next - *t) < kShareOfPixel * pixel.at(*t)) return next;
        last = *t;
        last_excess = excess;
        t = next;
    }
    return {};
}

std::unique_ptr<Contender> makeIteratedContender(const Workload& workload, const View& view, bool secant) {
    return std::make_unique<IteratedContender>(workload, view, secant);
}

}  // namespace dsphere::bench
