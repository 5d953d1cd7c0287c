#include "image/moon.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "image/noise.h"

namespace dsphere {
namespace {

constexpr double kRadius = 1737.4;                       // km, the moon's
constexpr double kLeastHeight = -11.0, kGreatest = 9.0;  // km: what 0 and 1 mean
constexpr double kDensity = 0.42;                        // N(> r) = kDensity / r^2
constexpr double kGreatestRadius = 0.3;                  // of the unit sphere: a basin of 1000 km
constexpr double kReach = 2.6;                           // radii to the end of the ejecta
constexpr double kBend = 0.12;                           // how far outlines leave the circle, as a share of the radius
constexpr double kGroundAmplitude = 4.5, kGroundDecay = 0.57;  // km; an octave's share of the coarser one's
constexpr double kFloodAge = 0.12, kPlainHeight = -1.6;
constexpr std::size_t kMostCraters = 1'500'000;

// Value noise has the axes of its lattice; turning each octave hides them. Columns of a rotation, 3-4-5 twice.
const dmat3 kTurn{dvec3(0.6, 0.64, 0.48), dvec3(-0.8, 0.48, 0.36), dvec3(0.0, -0.6, 0.8)};

/// A minimum (of a, b) rounded over `k`: https://iquilezles.org/articles/smin, quadratic.
double roundedMinimum(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * h * h * k;
}

/// Pike's fits for fresh craters, D in km, simple below 15 km and complex above.
double freshDepth(double diameter) {
    return diameter < 15.0 ? 0.196 * std::pow(diameter, 1.01) : 1.044 * std::pow(diameter, 0.301);
}

double freshRim(double diameter) {
    return diameter < 21.0 ? 0.036 * std::pow(diameter, 1.014) : 0.236 * std::pow(diameter, 0.399);
}

/// Height over the land around at `x` radii from the centre; `bump` is noise about 0 that roughens floor and ejecta.
double profile(const Crater& crater, double x, double bump) {
    const double end = 1.0 / (kReach * kReach * kReach);
    const double outside = crater.rim * (1.0 / std::max(x * x * x, 1e-3) - end) / (1.0 - end);
    const double climb = std::max(x - crater.floor, 0.0) / (1.0 - crater.floor);
    const double steepness = crater.floor > 0.0 ? 1.4 : 2.0;
    double inside = crater.rim - crater.depth + crater.depth * std::pow(climb, steepness);
    inside += crater.peak * std::exp(-std::pow(x / 0.16, 2.0)) * (1.0 + 2.0 * bump);
    return roundedMinimum(inside, std::min(outside, 4.0 * crater.rim), crater.rounding) * (1.0 + 0.5 * bump);
}

/// The land after the strike: what was inside is gone, what is under the ejecta is buried a little.
double struck(const Crater& crater, double height, double x, double bump) {
    const double kept = std::clamp((x - 0.7) / 0.6, 0.0, 1.0);
    const double erased = 0.9 * (1.0 - smoothStep(kept));
    return height + erased * (crater.base - height) + profile(crater, x, bump);
}

Crater makeCrater(int rank, double radius, int octaves, std::uint32_t seed) {
    const auto chance = [&](int what) { return latticeNoise(rank, what, 3, seed); };
    Crater crater;
    const double y = 2.0 * chance(0) - 1.0, phi = 2.0 * kPi * chance(1), across = std::sqrt(1.0 - y * y);
    crater.centre = {across * std::sin(phi), y, across * std::cos(phi)};
    crater.radius = radius;
    crater.age = chance(2);
    const double diameter = 2.0 * radius * kRadius, worn = std::sqrt(crater.age);
    const double basin = std::clamp((diameter - 200.0) / 600.0, 0.0, 1.0);  // basins sink back
    crater.depth = freshDepth(diameter) * (1.0 - 0.55 * worn) * (1.0 - 0.45 * basin);
    crater.rim = freshRim(diameter) * (1.0 - 0.6 * worn) * (1.0 - 0.5 * basin);
    crater.rounding = (0.03 + 0.5 * worn) * crater.depth;
    crater.floor = std::clamp(0.22 * std::log2(diameter / 15.0), 0.0, 0.62 + 0.1 * chance(3));
    if (diameter > 35.0 && diameter < 250.0)
        crater.peak = (0.25 + 0.25 * chance(4)) * crater.depth * (1.0 - 0.7 * worn);
    crater.octave = std::clamp(int(std::lround(std::log2(1.1 / radius))), 0, octaves - 1);
    return crater;
}

/// Half the range of longitude, radians, of the points at `colatitude` within `angle` of a point at `centre`.
std::optional<double> halfRange(double colatitude, double centre, double angle) {
    const double sines = std::sin(colatitude) * std::sin(centre);
    const double cosine = std::cos(angle) - std::cos(colatitude) * std::cos(centre);
    if (cosine >= sines) return std::nullopt;
    return cosine <= -sines ? kPi : std::acos(cosine / sines);
}

/// The land after the lava: it fills what is low, in regions where the coarsest noise is.
double flooded(double height, double region, double bump) {
    const double level = kPlainHeight - 6.0 * std::clamp((region - 0.4) / 0.2, 0.0, 1.0) + 0.12 * bump;
    return -roundedMinimum(-height, -level, 0.3);
}

double colatitudeOf(const dvec3& direction) {
    return std::acos(std::clamp(direction.y, -1.0, 1.0));
}

/// The angle, radians, that the crater's work can span.
double reachOf(const Crater& crater) {
    return 2.0 * std::asin(std::min(1.0, 0.5 * kReach * (1.0 + kBend) * crater.radius));
}

}  // namespace

/// A row in the making.
struct Moon::RowState {
    double colatitude, sine, cosine;
    int octaves;
    std::vector<double> heights;  ///< km
    std::vector<double> noise;    ///< 0 to 1, the octaves of a column together

    dvec3 direction(const dvec2& meridian) const { return {sine * meridian.x, cosine, sine * meridian.y}; }
    const double* noiseAt(std::size_t i) const { return &noise[i * std::size_t(octaves)]; }
};

Moon::Moon(int width, int height, std::uint32_t seed) : width_(width), height_(height), seed_(seed) {
    const double texel = 2.0 * kPi / width;
    octaves_ = std::clamp(int(std::log2(0.25 / texel)), 3, 16);  // the finest features span two texels
    for (int i = 0; i < width; ++i) {
        const double longitude = 2.0 * kPi * ((i + 0.5) / width - 0.5);
        meridians_.push_back({std::sin(longitude), std::cos(longitude)});
    }
    listCraters(1.4 * texel);
    sortIntoBands();
    findBases();
}

void Moon::listCraters(double least_radius) {
    const double first = kDensity / (kGreatestRadius * kGreatestRadius);
    const double count = kDensity / (least_radius * least_radius) - first;
    const std::size_t wanted = std::min(kMostCraters, std::size_t(std::max(count, 8.0)));
    // By rank, so that a larger map has the craters of a smaller one and finer ones besides.
    for (std::size_t k = 0; k < wanted; ++k)
        craters_.push_back(makeCrater(int(k), std::sqrt(kDensity / (first + double(k))), octaves_, seed_));
    std::ranges::stable_sort(craters_, std::ranges::greater{}, &Crater::age);
}

void Moon::sortIntoBands() {
    const int bands = std::clamp(height_ / 2, 1, 4096);
    const auto forBands = [&](auto visit) {
        for (std::size_t k = 0; k < craters_.size(); ++k) {
            const double colatitude = colatitudeOf(craters_[k].centre), reach = reachOf(craters_[k]);
            const int first = std::clamp(int(std::floor((colatitude - reach) / kPi * bands)), 0, bands - 1);
            const int last = std::clamp(int(std::floor((colatitude + reach) / kPi * bands)), 0, bands - 1);
            for (int b = first; b <= last; ++b) visit(std::size_t(b), std::uint32_t(k));
        }
    };
    band_first_.assign(std::size_t(bands) + 1, 0);
    forBands([&](std::size_t b, std::uint32_t) { ++band_first_[b + 1]; });
    for (std::size_t b = 0; b < std::size_t(bands); ++b) band_first_[b + 1] += band_first_[b];
    band_craters_.resize(band_first_.back());
    std::vector<std::uint32_t> next = band_first_;
    forBands([&](std::size_t b, std::uint32_t k) { band_craters_[next[b]++] = k; });
}

std::span<const std::uint32_t> Moon::cratersNear(double colatitude) const {
    const std::size_t bands = band_first_.size() - 1;
    const std::size_t b = std::min(std::size_t(colatitude / kPi * double(bands)), bands - 1);
    return std::span(band_craters_).subspan(band_first_[b], band_first_[b + 1] - band_first_[b]);
}

// Only what is as large as the crater itself makes the land that it struck; its own size of ruggedness it erases.
void Moon::findBases() {
    for (Crater& crater : craters_) {
        const int octaves = std::min(octaves_, crater.octave + 1);
        double height = ground(crater.centre, octaves, nullptr);
        const double region = groundNoise(crater.centre, 0);
        bool dry = true;
        const auto floodOnce = [&] {
            if (dry) height = flooded(height, region, 0.0);
            dry = false;
        };
        for (const std::uint32_t k : cratersNear(colatitudeOf(crater.centre))) {
            const Crater& older = craters_[k];
            if (&older >= &crater) break;
            if (older.age < kFloodAge) floodOnce();
            const dvec3 apart = crater.centre - older.centre;
            const double x = std::sqrt(glm::dot(apart, apart)) / older.radius;
            if (older.radius > 0.5 * crater.radius && x < kReach) height = struck(older, height, x, 0.0);
        }
        if (crater.age < kFloodAge) floodOnce();
        crater.base = height;
    }
}

double Moon::groundNoise(dvec3 direction, int octave) const {
    for (int k = 0; k <= octave; ++k) direction = kTurn * direction;
    return valueNoise(direction * (2.0 * double(1 << octave)), seed_ + 17u * std::uint32_t(octave));
}

double Moon::ground(const dvec3& direction, int octaves, double* noise) const {
    double height = 0.0, amplitude = kGroundAmplitude;
    for (int octave = 0; octave < octaves; ++octave, amplitude *= kGroundDecay) {
        const double value = groundNoise(direction, octave);
        if (noise) noise[octave] = value;
        height += amplitude * (value - 0.5);
    }
    return height;
}

void Moon::flood(RowState& state) const {
    for (std::size_t i = 0; i < state.heights.size(); ++i) {
        const double* noise = state.noiseAt(i);
        state.heights[i] = flooded(state.heights[i], noise[0], noise[octaves_ / 2] - 0.5);
    }
}

void Moon::strike(const Crater& crater, RowState& state) const {
    const double centre = colatitudeOf(crater.centre);
    const std::optional<double> half = halfRange(state.colatitude, centre, reachOf(crater));
    if (!half) return;
    const double texels = width_ / (2.0 * kPi);
    const double middle = (std::atan2(crater.centre.x, crater.centre.z) + kPi) * texels - 0.5;
    const int first = int(std::floor(middle - *half * texels));
    const int count = std::min(int(std::ceil(middle + *half * texels)) - first + 1, width_);
    const double inverse_square = 1.0 / (crater.radius * crater.radius);
    for (int k = 0; k < count; ++k) {
        const std::size_t i = std::size_t(((first + k) % width_ + width_) % width_);
        const dvec3 apart = state.direction(meridians_[i]) - crater.centre;
        const double square = glm::dot(apart, apart) * inverse_square;
        const double* noise = state.noiseAt(i);
        const double bend = 1.0 + kBend * (2.0 * noise[crater.octave] - 1.0);
        const double x = std::sqrt(square) * bend;
        if (x < kReach) {
            const int finer = std::min(crater.octave + 2, octaves_ - 1);
            state.heights[i] = struck(crater, state.heights[i], x, 0.5 * (noise[finer] - 0.5));
        }
    }
}

std::vector<double> Moon::row(int j) const {
    const double colatitude = kPi * (j + 0.5) / height_;
    RowState state{colatitude, std::sin(colatitude), std::cos(colatitude), octaves_, {}, {}};
    state.heights.resize(std::size_t(width_));
    state.noise.resize(std::size_t(width_) * std::size_t(octaves_));
    for (std::size_t i = 0; i < state.heights.size(); ++i)
        state.heights[i] = ground(state.direction(meridians_[i]), octaves_, &state.noise[i * std::size_t(octaves_)]);
    bool dry = true;
    for (const std::uint32_t k : cratersNear(colatitude)) {
        if (dry && craters_[k].age < kFloodAge) {
            flood(state);
            dry = false;
        }
        strike(craters_[k], state);
    }
    if (dry) flood(state);
    for (double& height : state.heights) height = (height - kLeastHeight) / (kGreatest - kLeastHeight);
    return std::move(state.heights);
}

}  // namespace dsphere
