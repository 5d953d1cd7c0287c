#include "surface/levels.h"

#include "base/parallel.h"
#include "surface/tiledheights.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace dsphere {

namespace {

/// A place among the lines of a grid: between `before` and the line after it, `share` of the way.
struct Place {
    int before, after;
    double share;
};

Place placeOfLongitude(const NodeGrid& grid, double longitude) {
    double x = grid.column(longitude);
    double line = std::floor(x);
    auto wrapped = [&](double i) { return int(i - std::floor(i / grid.width()) * grid.width()); };
    return {wrapped(line), wrapped(line + 1.0), x - line};
}

Place placeOfColatitude(const NodeGrid& grid, double colatitude) {
    double y = grid.nodeRow(colatitude);
    int row = std::clamp(int(std::floor(y)), 0, grid.rows() - 1);
    double share = y - row;
    if (grid.halfCaps() && row == 0) share = 2.0 * (y - 0.5);
    if (grid.halfCaps() && row == grid.rows() - 1) share = 2.0 * (y - row);
    return {row, row + 1, std::clamp(share, 0.0, 1.0)};
}

double between(double first, double second, double share) {
    return first + share * (second - first);
}

/// The values of a grid's columns along one parallel.
std::vector<double> parallelOf(const NodeGrid& grid, double colatitude) {
    Place place = placeOfColatitude(grid, colatitude);
    const float *above = grid.row(place.before), *below = grid.row(place.after);
    std::vector<double> values(static_cast<std::size_t>(grid.width()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = between(above[i], below[i], place.share);
    return values;
}

std::vector<Place> placesOf(const NodeGrid& grid, const std::vector<double>& longitudes) {
    std::vector<Place> places;
    places.reserve(longitudes.size());
    for (double longitude : longitudes) places.push_back(placeOfLongitude(grid, longitude));
    return places;
}

double valueAt(const std::vector<double>& values, const Place& place) {
    return between(values[std::size_t(place.before)], values[std::size_t(place.after)], place.share);
}

/// Sets every sample of the half map from those of the whole: `weigh(i, j)`, of its own column and row.
template <typename Weigh>
void fillSamples(Heightmap& half, Weigh weigh) {
    std::size_t width = std::size_t(half.width);
    half.samples.resize(width * std::size_t(half.height));
    parallelFor(std::size_t(half.height), [&](std::size_t j) {
        for (int i = 0; i < half.width; ++i) half.samples[j * width + std::size_t(i)] = weigh(i, int(j));
    });
}

void averageTexels(Heightmap& half, const Heightmap& map) {
    fillSamples(half, [&](int i, int j) {
        double sum = double(map.at(2 * i, 2 * j)) + double(map.at(2 * i + 1, 2 * j)) +
                     double(map.at(2 * i, 2 * j + 1)) + double(map.at(2 * i + 1, 2 * j + 1));
        return float(0.25 * sum);
    });
}

void averageNodes(Heightmap& half, const Heightmap& map) {
    fillSamples(half, [&](int i, int j) {
        if (j == 0 || j == half.height - 1) return map.at(0, 2 * j);  // a pole
        int east = (2 * i + 1) % map.width, west = (2 * i + map.width - 1) % map.width;
        auto across = [&](int row) {
            return 0.25 * map.at(west, row) + 0.5 * map.at(2 * i, row) + 0.25 * map.at(east, row);
        };
        return float(0.25 * across(2 * j - 1) + 0.5 * across(2 * j) + 0.25 * across(2 * j + 1));
    });
}

}  // namespace

namespace {

/// A map of the same ground, with other samples to come.
Heightmap levelOf(const Heightmap& map, int width, int height) {
    Heightmap level;
    level.width = width;
    level.height = height;
    level.registration = map.registration;
    level.longitude_origin = map.longitude_origin;
    level.full_scale = map.full_scale;
    level.zero = map.zero;
    level.path = map.path;
    level.type = map.type;
    level.north_pole = map.north_pole;
    level.south_pole = map.south_pole;
    return level;
}

void findRange(Heightmap& map) {
    const auto [least, greatest] = std::ranges::minmax(map.samples);
    map.least = least;
    map.greatest = greatest;
}

}  // namespace

std::optional<Heightmap> halved(const Heightmap& map) {
    bool texel = map.registration == Registration::Texel;
    int rows = texel ? map.height : map.height - 1;
    if (map.width % 2 || rows % 2 || map.width / 2 < NodeGrid::kLeastWidth || rows / 2 < NodeGrid::kLeastRows)
        return std::nullopt;
    Heightmap half = levelOf(map, map.width / 2, texel ? rows / 2 : rows / 2 + 1);
    texel ? averageTexels(half, map) : averageNodes(half, map);
    findRange(half);
    return half;
}

std::optional<Heightmap> reducedMap(const Heightmap& map) {
    const Survey& survey = map.tiled->survey();
    if (survey.reduction == 0) return std::nullopt;
    const int width = map.width / survey.reduction;
    Heightmap reduced = levelOf(map, width, int(survey.reduced.size() / std::size_t(width)));
    reduced.samples = survey.reduced;
    findRange(reduced);
    return reduced;
}

double greatestDifference(const NodeGrid& a, const NodeGrid& b) {
    std::vector<double> longitudes, colatitudes;
    for (const NodeGrid* grid : {&a, &b}) {
        for (int i = 0; i < grid->width(); ++i) longitudes.push_back(grid->longitude(i));
        for (int j = 0; j <= grid->rows(); ++j) colatitudes.push_back(grid->colatitude(j));
    }
    const std::vector<Place> places_a = placesOf(a, longitudes), places_b = placesOf(b, longitudes);
    double greatest = 0.0;
    std::mutex mutex;
    parallelFor(colatitudes.size(), [&](std::size_t row) {
        const std::vector<double> values_a = parallelOf(a, colatitudes[row]),
                                  values_b = parallelOf(b, colatitudes[row]);
        double most = 0.0;
        for (std::size_t i = 0; i < longitudes.size(); ++i)
            most = std::max(most, std::abs(valueAt(values_a, places_a[i]) - valueAt(values_b, places_b[i])));
        std::lock_guard lock(mutex);
        greatest = std::max(greatest, most);
    });
    return greatest;
}

}  // namespace dsphere
