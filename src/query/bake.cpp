#include "query/bake.h"

#include "base/error.h"
#include "base/parallel.h"
#include "query/geography.h"
#include "verify/compare.h"

#include <algorithm>
#include <cmath>

namespace dsphere::query {

namespace {

constexpr double kLift = 1e-6;   // R: where rays start above the ground
constexpr double kAbove = 1e-3;  // R: where rays that look down on it start
constexpr std::size_t kRaysAtOnce = 1u << 20;
constexpr double kBeside = 1e-9;                   // radians to either side of a texel's centre, where slopes are taken
constexpr double kGoldenTurn = 2.399963229728653;  // radians: points of a spiral at this angle spread evenly

/// A point of the unit disc: the k-th of n that spread evenly (Vogel 1979).
dvec2 discPoint(int k, int n) {
    const double radius = std::sqrt((k + 0.5) / n), angle = k * kGoldenTurn;
    return radius * dvec2(std::cos(angle), std::sin(angle));
}

/// Where a sample of a sun stands: a unit direction, or a place in object space where the ray ends.
struct SunSample {
    dvec3 place;
    bool ends;
};

dvec3 directionOf(double longitude, double latitude) {
    const double lon = glm::radians(longitude), lat = glm::radians(latitude);
    return {std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon)};
}

std::vector<SunSample> samplesOf(const Sun& sun, int count, double unit) {
    const dvec3 towards = directionOf(sun.longitude, sun.latitude);
    const dvec3 aside = glm::normalize(std::abs(towards.y) < 0.9 ? glm::cross(towards, dvec3(0.0, 1.0, 0.0))
                                                                 : glm::cross(towards, dvec3(1.0, 0.0, 0.0)));
    const dvec3 other = glm::cross(towards, aside);
    std::vector<SunSample> samples;
    for (int k = 0; k < count; ++k) {
        const dvec2 on_disc = std::tan(glm::radians(sun.radius)) * discPoint(k, count);
        const dvec3 sample = towards + on_disc.x * aside + on_disc.y * other;
        if (sun.distance)
            samples.push_back({*sun.distance * unit * sample, true});
        else
            samples.push_back({glm::normalize(sample), false});
    }
    return samples;
}

QueryRay rayTo(const dvec3& start, const SunSample& sample) {
    const dvec3 d = sample.ends ? sample.place - start : sample.place;
    QueryRay ray{{start.x, start.y, start.z}, {d.x, d.y, d.z}};
    if (sample.ends) ray.t_max = 1.0;
    return ray;
}

// Whether the body's core, which its ground encloses everywhere, stands between: no ray has to be traced then.
bool hiddenByCore(const dvec3& start, const SunSample& sample, double core) {
    const dvec3 offset = sample.ends ? sample.place - start : sample.place;
    const double length = glm::length(offset), along = glm::dot(start, offset) / length;
    const double beside2 = glm::dot(start, start) - along * along;
    if (!(along < 0.0 && beside2 < core * core)) return false;
    return !sample.ends || -along - std::sqrt(core * core - beside2) < length;
}

/// Rows that are done together, so that the device has enough to do and memory stays bounded.
int rowsAtOnce(const BakeGrid& grid, std::size_t rays_per_texel) {
    return int(
        std::clamp<std::size_t>(kRaysAtOnce / (std::size_t(grid.width) * rays_per_texel), 1, std::size_t(grid.height)));
}

}  // namespace

/// The ground at a texel's centre: local axes, and the gradient of |p| - r along east and south.
struct Baker::Ground {
    double sample, east_slope, south_slope;  // slopes: rise over run
};

Baker::Baker(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const PackedScene& packed,
             const DeviceScene& device_scene, const BakeGrid& grid, const Progress& progress)
    : device_(device),
      scene_(scene),
      maps_(maps),
      packed_(packed),
      device_scene_(device_scene),
      grid_(grid),
      progress_(progress),
      engine_(device, scene, maps, packed, device_scene,
              {.frame = Frame::Body,
               .wishes = {.normal = false},
               .parts = AnswerParts::none(),
               .secondary = true,
               .between_blocks = [this] { alive(); }}) {
    body_ = &engine_.shapes()[bodyOf(scene)];
    if (!body_->heights) throwInvalid("{}: bake needs a displacedsphere, and the scene has none", scene.name);
    for (int i = 0; i < grid.width; ++i) {
        const double lon = glm::radians(grid.longitude(i));
        meridians_.emplace_back(std::sin(lon), std::cos(lon));
    }
    for (int j = 0; j < grid.height; ++j) {
        const double lat = glm::radians(grid.latitude(j));
        parallels_.emplace_back(std::sin(lat), std::cos(lat));
    }
}

dvec3 Baker::up(int i, int j) const {
    const dvec2 &meridian = meridians_[std::size_t(i)], &parallel = parallels_[std::size_t(j)];
    return {parallel.y * meridian.x, parallel.x, parallel.y * meridian.y};
}

dvec3 Baker::inLocalAxes(int i, int j, const dvec3& east_north_up) const {
    const dvec2 &meridian = meridians_[std::size_t(i)], &parallel = parallels_[std::size_t(j)];
    const dvec3 east(meridian.y, 0.0, -meridian.x);
    const dvec3 north(-parallel.x * meridian.x, parallel.y, -parallel.x * meridian.y);
    return east_north_up.x * east + east_north_up.y * north + east_north_up.z * up(i, j);
}

Baker::Ground Baker::groundAt(int i, int j) const {
    const dvec3 direction = up(i, j);
    const double longitude = std::atan2(direction.x, direction.z);
    const double colatitude = glm::radians(90.0 - grid_.latitude(j)), sine = parallels_[std::size_t(j)].y;
    Ground ground{body_->heights->at(longitude, colatitude).value, 0.0, 0.0};
    const double r = body_->relief.base + body_->relief.scale * ground.sample;
    for (double east : {-kBeside, kBeside})
        for (double south : {-kBeside, kBeside}) {
            const HeightSample beside = body_->heights->at(longitude + east, colatitude + south);
            ground.east_slope += 0.25 * body_->relief.scale * beside.per_longitude / (r * sine);
            ground.south_slope += 0.25 * body_->relief.scale * beside.per_colatitude / r;
        }
    return ground;
}

template <typename Value>
std::vector<float> Baker::mapped(Value value) const {
    std::vector<float> plane(grid_.count());
    parallelFor(std::size_t(grid_.height), [&](std::size_t j) {
        for (int i = 0; i < grid_.width; ++i)
            plane[j * std::size_t(grid_.width) + std::size_t(i)] = float(value(groundAt(i, int(j)), i, int(j)));
    });
    return plane;
}

std::vector<float> Baker::height() const {
    const Heightmap& map = body_->heights->map();
    return mapped([&map](const Ground& ground, int, int) { return map.stored(ground.sample); });
}

std::vector<float> Baker::slope() const {
    return mapped([](const Ground& ground, int, int) {
        return glm::degrees(std::atan(std::hypot(ground.east_slope, ground.south_slope)));
    });
}

std::vector<float> Baker::aspect() const {
    return mapped([](const Ground& ground, int, int) {
        if (ground.east_slope == 0.0 && ground.south_slope == 0.0) return double(QueryHit::kNone);
        const double azimuth = glm::degrees(std::atan2(-ground.east_slope, ground.south_slope));
        return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
    });
}

std::vector<float> Baker::normal(int axis) const {
    return mapped([&](const Ground& ground, int i, int j) {
        return glm::normalize(inLocalAxes(i, j, {-ground.east_slope, ground.south_slope, 1.0}))[axis];
    });
}

std::vector<dvec3> Baker::startsOf(int row) const {
    std::vector<dvec3> starts;
    for (int i = 0; i < grid_.width; ++i) {
        const dvec3 direction = up(i, row);
        const HeightSample ground =
            body_->heights->at(std::atan2(direction.x, direction.z), glm::radians(90.0 - grid_.latitude(row)));
        starts.push_back((body_->relief.base + body_->relief.scale * ground.value + kLift * body_->unit) * direction);
    }
    return starts;
}

template <typename Source>
std::vector<std::uint8_t> Baker::freeRays(std::size_t count, const Source& source) {
    std::vector<std::uint8_t> free(count);
    engine_.trace(count, source,
                  [&](std::size_t k, const Answer& answer) { free[k] = answer.hit.status == QueryStatus::Miss; });
    rays_ += count;
    return free;
}

void Baker::report(int row) {
    share_ = double(row) / grid_.height;
    alive();
}

void Baker::alive() const {
    if (progress_ && !progress_(share_)) throw Error(ExitCode::Interrupted, "interrupted");
}

std::vector<float> Baker::lit(const Sun& sun, int samples) {
    struct Sight {
        dvec3 start;
        std::uint32_t sample;
        std::size_t texel;
    };
    const std::vector<SunSample> places = samplesOf(sun, sun.radius > 0.0 ? samples : 1, body_->unit);
    const double core = body_->relief.least_radius * (1.0 - 1e-9);
    const std::size_t width = std::size_t(grid_.width);
    std::vector<float> plane(grid_.count());
    const int rows = rowsAtOnce(grid_, places.size());
    for (int first = 0; first < grid_.height; first += rows) {
        report(first);
        const int count = std::min(rows, grid_.height - first);
        std::vector<std::vector<Sight>> of_row(static_cast<std::size_t>(count));
        parallelFor(std::size_t(count), [&](std::size_t row) {
            const std::vector<dvec3> starts = startsOf(first + int(row));
            for (std::size_t i = 0; i < width; ++i)
                for (std::size_t k = 0; k < places.size(); ++k)
                    if (!hiddenByCore(starts[i], places[k], core))
                        of_row[row].push_back({starts[i], std::uint32_t(k), (std::size_t(first) + row) * width + i});
        });
        std::vector<Sight> sights;
        for (const std::vector<Sight>& row : of_row) sights.insert(sights.end(), row.begin(), row.end());
        const std::vector<std::uint8_t> free =
            freeRays(sights.size(), [&](std::size_t k) { return rayTo(sights[k].start, places[sights[k].sample]); });
        for (std::size_t k = 0; k < sights.size(); ++k)
            if (free[k]) plane[sights[k].texel] += 1.0f / float(places.size());
    }
    return plane;
}

std::vector<float> Baker::sky(int samples) {
    const std::size_t width = std::size_t(grid_.width), n = std::size_t(samples);
    std::vector<dvec3> directions;  // even on the disc below them: cosine-weighted
    for (int k = 0; k < samples; ++k) {
        const dvec2 foot = discPoint(k, samples);
        directions.emplace_back(foot, std::sqrt(std::max(0.0, 1.0 - glm::dot(foot, foot))));
    }
    std::vector<float> plane(grid_.count());
    const int rows = rowsAtOnce(grid_, n);
    for (int first = 0; first < grid_.height; first += rows) {
        report(first);
        const int count = std::min(rows, grid_.height - first);
        std::vector<std::vector<dvec3>> starts(static_cast<std::size_t>(count));
        parallelFor(starts.size(), [&](std::size_t row) { starts[row] = startsOf(first + int(row)); });
        const std::vector<std::uint8_t> free = freeRays(std::size_t(count) * width * n, [&](std::size_t k) {
            const std::size_t texel = k / n, row = texel / width, i = texel % width;
            const dvec3 direction = inLocalAxes(int(i), first + int(row), directions[k % n]);
            return rayTo(starts[row][i], {direction, false});
        });
        for (std::size_t k = 0; k < free.size(); ++k)
            if (free[k]) plane[std::size_t(first) * width + k / n] += 1.0f / float(samples);
    }
    return plane;
}

std::vector<float> Baker::horizon(double azimuth, double bound) {
    if (scene_.shapes.size() > 1)
        throwInvalid("{}: a horizon is found for a displacedsphere alone; the scene has {} shapes", scene_.name,
                     scene_.shapes.size());
    const double a = glm::radians(azimuth);
    const int halvings = std::max(1, int(std::ceil(std::log2(90.0 / bound))));
    const std::size_t width = std::size_t(grid_.width);
    std::vector<float> plane(grid_.count());
    const int rows = rowsAtOnce(grid_, 1);
    for (int first = 0; first < grid_.height; first += rows) {
        const int count = std::min(rows, grid_.height - first);
        std::vector<std::vector<dvec3>> starts(static_cast<std::size_t>(count));
        parallelFor(starts.size(), [&](std::size_t row) { starts[row] = startsOf(first + int(row)); });
        // Straight down is blocked, straight up is free.
        std::vector<double> blocked(std::size_t(count) * width, -90.0);
        for (int halving = 0; halving < halvings; ++halving) {
            report(first);
            const double span = 180.0 / std::exp2(halving + 1);
            const std::vector<std::uint8_t> free = freeRays(blocked.size(), [&](std::size_t texel) {
                const double e = glm::radians(blocked[texel] + span);
                const std::size_t row = texel / width, i = texel % width;
                const dvec3 local(std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e));
                return rayTo(starts[row][i], {inLocalAxes(int(i), first + int(row), local), false});
            });
            for (std::size_t texel = 0; texel < free.size(); ++texel)
                if (!free[texel]) blocked[texel] += span;
        }
        const double half = 90.0 / std::exp2(halvings);
        for (std::size_t texel = 0; texel < blocked.size(); ++texel)
            plane[std::size_t(first) * width + texel] = float(blocked[texel] + half);
    }
    return plane;
}

QueryRay Baker::rayDown(double i, double j) const {
    const LocalAxes axes(grid_.latitude(j), grid_.longitude(i));
    const HeightSample ground =
        body_->heights->at(std::atan2(axes.up.x, axes.up.z), glm::radians(90.0 - grid_.latitude(j)));
    const dvec3 start = (body_->relief.base + body_->relief.scale * ground.value + kAbove * body_->unit) * axes.up;
    return {{start.x, start.y, start.z}, {-axes.up.x, -axes.up.y, -axes.up.z}};
}

std::array<std::vector<float>, 3> Baker::colour(int samples) {
    constexpr double kSide = 0.01;  // texels
    constexpr std::array<dvec2, 4> kSides{dvec2(-kSide, -kSide), {kSide, -kSide}, {-kSide, kSide}, {kSide, kSide}};
    const bool drawn = std::ranges::any_of(scene_.lights, [](const Light& light) { return !verify::isLamp(light); });
    const std::size_t n = drawn ? kSides.size() * std::size_t((samples + 3) / 4) : kSides.size();
    Engine looking(device_, scene_, maps_, packed_, device_scene_,
                   {.frame = Frame::Body,
                    .wishes = {.normal = false, .colour = true},
                    .parts = AnswerParts::none(),
                    .between_blocks = [this] { alive(); }});
    const std::size_t width = std::size_t(grid_.width);
    std::array<std::vector<float>, 3> planes;
    for (std::vector<float>& plane : planes) plane.resize(grid_.count());
    const int rows = rowsAtOnce(grid_, n);
    std::vector<std::array<float, 3>> seen;
    for (int first = 0; first < grid_.height; first += rows) {
        report(first);
        const std::size_t texels = std::size_t(std::min(rows, grid_.height - first)) * width;
        seen.resize(texels * n);
        looking.trace(
            seen.size(),
            [&](std::size_t k) {
                const dvec2 side = kSides[k % kSides.size()];
                return rayDown(double(k / n % width) + side.x, double(first) + double(k / n / width) + side.y);
            },
            [&](std::size_t k, const Answer& answer) { seen[k] = answer.colour; });
        for (std::size_t k = 0; k < seen.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) planes[c][std::size_t(first) * width + k / n] += seen[k][c] / float(n);
    }
    rays_ += grid_.count() * n;
    return planes;
}

}  // namespace dsphere::query
