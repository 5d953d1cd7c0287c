#include "query/sentrays.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dsphere::query {

namespace {

// A shorter direction is taken for 0: what t counts in it would overflow.
constexpr double kLeastDirection = 1e-280;

bool allFinite(const std::array<double, 3>& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// A ray that meets nothing.
layout::QueryRay nothing() {
    return packRay(dvec3(0.0, 1e15, 0.0), dvec3(1.0, 0.0, 0.0), 0.0, -1.0, false, 0);
}

layout::QueryRay packed(const ShapeFrame& shape, const QueryRay& ray, bool secondary, std::uint32_t number) {
    const DeviceRay on_device = deviceRay(shape, ray);
    const double begin = on_device.origin + on_device.length * ray.t_min;
    const double end = on_device.origin + on_device.length * ray.t_max;
    const bool near = glm::dot(on_device.point, on_device.point) < 1e24;  // in R; else it overflowed or passes far off
    if (!near || !(begin < end)) return nothing();
    return packRay(on_device.point, on_device.direction, begin, end, secondary, number);
}

// Whether the ray's line comes near the sphere that holds the shape: |o x d| is its distance from the centre, times
// |d|. The product is right to some 1e-15 |o| |d|, far less than the margin. Overflows and directions whose square
// vanishes count as near.
bool mayMeet(const ShapeFrame& shape, const QueryRay& ray) {
    if (!shape.in_unit_sphere) return true;
    const ShapeLine line(shape, ray);
    const dvec3 moment = glm::cross(line.origin, line.direction);
    const bool passes = glm::dot(moment, moment) > 1.000001 * glm::dot(line.direction, line.direction);
    return !(passes && glm::dot(line.origin, line.origin) < 1e16);
}

constexpr int kCellBits = 7;  // of either coordinate of the cells below
constexpr std::size_t kCells = std::size_t(1) << 2 * kCellBits;

std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 4) & 0x0f0fu;
    bits = (bits | bits << 2) & 0x3333u;
    return (bits | bits << 1) & 0x5555u;
}

// Where a ray enters the unit sphere, or comes nearest to it, as a cell of the octahedral map (Cigolle et al. 2014, "A
// survey of efficient representations for independent unit vectors"), in Morton's order.
std::uint32_t cellOf(const ShapeFrame& shape, const QueryRay& ray) {
    const DeviceRay from_nearest = deviceRay(shape, ray);
    const double half_chord = std::sqrt(std::max(0.0, 1.0 - glm::dot(from_nearest.point, from_nearest.point)));
    const double begin = from_nearest.origin + from_nearest.length * ray.t_min;
    const dvec3 p = from_nearest.point + std::max(-half_chord, begin) * from_nearest.direction;
    const double sum = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
    double x = p.x / sum, y = p.z / sum;
    if (p.y < 0.0) {
        const double folded = std::copysign(1.0 - std::abs(y), x);
        y = std::copysign(1.0 - std::abs(x), y);
        x = folded;
    }
    const auto cell = [](double v) {  // NaN too
        const double place = (0.5 + 0.5 * v) * (1 << kCellBits);
        return place > 0.0 ? std::uint32_t(std::min(place, double((1 << kCellBits) - 1))) : 0u;
    };
    return spread(cell(x)) | spread(cell(y)) << 1;
}

// Whether most neighbours enter more than some eight cells apart. Those of a picture's rows lie in one cell, or in two
// side by side.
bool areScattered(const ShapeFrame& shape, std::span<const QueryRay> rays) {
    constexpr std::size_t kPairs = 16;
    if (rays.size() < 4 * kPairs) return false;
    std::size_t apart = 0;
    for (std::size_t k = 0; k < kPairs; ++k) {
        const std::size_t i = k * (rays.size() - 1) / kPairs;
        apart += (cellOf(shape, rays[i]) ^ cellOf(shape, rays[i + 1])) >> 6 != 0;
    }
    return apart > kPairs / 2;
}

}  // namespace

bool isValid(const QueryRay& ray) {
    const auto &o = ray.origin, &d = ray.direction;
    const double size = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    const double nothing = 0.0 * (o[0] + o[1] + o[2] + d[0] + d[1] + d[2] + ray.t_min);  // NaN unless all are finite
    const bool finite = nothing == 0.0 || (allFinite(o) && allFinite(d) && std::isfinite(ray.t_min));
    return finite && size > kLeastDirection && !std::isnan(ray.t_max);
}

SentRays::SentRays(std::size_t capacity)
    : rays_((capacity + kChunk - 1) / kChunk * kChunk),
      places_(rays_.size()),
      fates_(rays_.size()),
      parts_(rays_.size() / kChunk) {}

void SentRays::takeChunk(std::span<const ShapeFrame> shapes, std::size_t chunk, std::size_t first,
                         const RaySource& source) {
    const std::size_t begin = chunk * kChunk, size = std::min(kChunk, count_ - begin);
    const std::span<QueryRay> rays(rays_.data() + begin, size);
    source(first + begin, rays);
    std::size_t sent = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const QueryRay& ray = rays[i];
        Fate fate = Fate::Invalid;
        if (isValid(ray)) {
            const auto met = [&ray](const ShapeFrame& shape) { return mayMeet(shape, ray); };
            fate = std::ranges::any_of(shapes, met) ? Fate::Sent : Fate::Miss;
        }
        fates_[begin + i] = fate;
        if (fate == Fate::Sent) rays[sent++] = ray;
    }
    parts_[chunk].sent = std::uint32_t(sent);
    parts_[chunk].scattered = shapes.size() == 1 && areScattered(shapes[0], rays.first(sent));
}

void SentRays::take(std::span<const ShapeFrame> shapes, std::size_t first, std::size_t count, const RaySource& source) {
    count_ = count;
    parallelFor(chunks(), [&](std::size_t chunk) { takeChunk(shapes, chunk, first, source); });
}

// A counting sort by the cells where rays enter.
void SentRays::sortPlaces(const ShapeFrame& shape) {
    parallelFor(chunks(), [&](std::size_t chunk) {
        for (std::size_t k = chunk * kChunk; k < chunk * kChunk + parts_[chunk].sent; ++k)
            places_[k] = cellOf(shape, rays_[k]);
    });
    std::vector<std::uint32_t> next(kCells + 1);
    const auto forAll = [&](const auto& body) {
        for (std::size_t chunk = 0; chunk < chunks(); ++chunk)
            for (std::size_t k = chunk * kChunk; k < chunk * kChunk + parts_[chunk].sent; ++k) body(places_[k]);
    };
    forAll([&](std::uint32_t cell) { ++next[cell + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    forAll([&](std::uint32_t& place) { place = next[place]++; });
}

std::uint32_t SentRays::pack(std::span<const ShapeFrame> shapes, bool secondary, std::span<layout::QueryRay> target) {
    std::uint32_t sent = 0;
    std::size_t scattered = 0;
    for (std::size_t chunk = 0; chunk < chunks(); ++chunk) {
        parts_[chunk].first_place = sent;
        sent += parts_[chunk].sent;
        scattered += parts_[chunk].scattered;
    }
    const bool sorted = scattered > chunks() / 2;
    if (sorted) sortPlaces(shapes[0]);
    parallelFor(chunks(), [&](std::size_t chunk) {
        for (std::size_t i = 0; i < parts_[chunk].sent; ++i) {
            const std::size_t k = chunk * kChunk + i;
            if (!sorted) places_[k] = parts_[chunk].first_place + std::uint32_t(i);
            for (std::size_t s = 0; s < shapes.size(); ++s)
                target[places_[k] * shapes.size() + s] = packed(shapes[s], rays_[k], secondary, std::uint32_t(k));
        }
    });
    return sent;
}

}  // namespace dsphere::query
