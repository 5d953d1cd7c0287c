#include "surface/heightmap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "base/limits.h"
#include "geo/readmap.h"
#include "surface/blur.h"
#include "surface/blurredmap.h"
#include "surface/fill.h"
#include "surface/heldmap.h"
#include "surface/preparemap.h"
#include "surface/surveycache.h"
#include "surface/tiledheights.h"

namespace dsphere {
namespace {

/// Rounded once: the sum of 2^20 floats of like size is exact enough in double, of equal floats exact.
float meanOfRow(const Heightmap& map, int j) {
    double sum = 0.0;
    for (int i = 0; i < map.width; ++i) sum += double(map.at(i, j));
    return float(sum / map.width);
}

void fill(Heightmap& map, const Nodata& nodata) {
    map.nodata_count = fillNodata(map.samples, map.width, map.height, nodata);
    if (map.nodata_count == map.samples.size())
        throwInvalid("{}: every one of the {}x{} texels is unknown (nodata)", map.path, map.width, map.height);
}

/// The stored value to count from (Heightmap::zero). Taking it away is exact: no value is twice another.
float zeroOf(float least, float greatest) {
    const float farthest = std::max(std::abs(least), std::abs(greatest));
    return farthest > 2.0f * (greatest - least) ? least : 0.0f;
}

/// "column 3, row 0 (latitude 89.75, longitude -178.25 degrees)", the latter in the map's own range.
std::string describeTexel(const Heightmap& map, std::size_t index) {
    const std::size_t i = index % std::size_t(map.width), j = index / std::size_t(map.width);
    const bool texel = map.registration == Registration::Texel;
    const double longitude = map.longitude_origin + (double(i) + (texel ? 0.5 : 0.0)) * 360.0 / map.width;
    const double latitude =
        texel ? 90.0 - (double(j) + 0.5) * 180.0 / map.height : 90.0 - double(j) * 180.0 / (map.height - 1);
    return fmt::format("column {}, row {} (latitude {:.10g}, longitude {:.10g} degrees)", i, j, latitude, longitude);
}

/// Throws, naming the texel of the sample whose radius is not a positive number.
[[noreturn]] void refuseRadius(const Heightmap& map, float sample, double radius, const SourceLocation& where) {
    const double stored = map.stored(sample);
    if (map.ripples)
        throwInvalid(
            "{}: the displaced radius is {} where the ripples are {}, expected it to be positive and finite "
            "everywhere (lower maxdispl, or change midlevel or heightmin and heightmax)",
            where.text(), radius, stored);
    if (map.tiled)
        throwInvalid(
            "{}: the displaced radius is {} where the map holds {}; expected it to be positive and finite at every "
            "texel (lower maxdispl, or change midlevel or heightmin and heightmax)",
            where.text(), radius, stored);
    const auto found = std::ranges::find(map.samples, sample);
    throwInvalid(
        "{}: the displaced radius is {} at {}, where the map holds {}; expected it to be positive and finite at every "
        "texel (lower maxdispl, or change midlevel or heightmin and heightmax)",
        where.text(), radius, describeTexel(map, std::size_t(found - map.samples.begin())), stored);
}

}  // namespace

namespace {

/// Where the registration and the longitude origin came from, if not from the file.
void tellSources(Heightmap& map, const RawMap& raw, const DisplacedSphere& shape) {
    auto& sources = map.facts.sources;
    if (shape.registration) sources["registration"] = "scene";
    if (shape.longitude_origin) sources["longitude_origin"] = "scene";
    if (shape.nodata && !std::isnan(*shape.nodata)) sources["nodata"] = "scene";
    sources.emplace("registration", "default");
    sources.emplace("longitude_origin", raw.longitude_origin ? "label" : "default");
}

/// The greatest of 1, 2, 5, 10, 20 ... that is no greater than x, which is at least 1.
double roundDown(double x) {
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= x) return digit * power;
    return power;
}

}  // namespace

std::optional<TrueScale> trueScaleOf(const DisplacedSphere& shape, const Heightmap& map) {
    constexpr double kUsualPercent = 5.0;
    const MapFacts& facts = map.facts;
    if (!shape.true_scale || !facts.radius || facts.unit != "m" || !(map.greatest > map.least)) return {};
    const double metres = facts.value_scale.value_or(1.0), zero = -facts.heightOf(0.0) / metres;
    const double range = std::abs(metres) * (double(map.greatest) - double(map.least));
    const double visible = kUsualPercent / 100.0 * *facts.radius / range;
    TrueScale scale;
    scale.exaggeration = roundDown(std::max(1.0, visible)) * shape.max_displacement / kUsualPercent;
    scale.height_scale = shape.radius * scale.exaggeration * metres / *facts.radius;
    scale.midlevel = zero;
    return scale;
}

Notice exaggerationNote(const TrueScale& scale, const Heightmap& map) {
    return {
        Notice::Kind::Note,
        fmt::format("{}: on a sphere of {:.8g} m heights are drawn {:.4g} times as high as they are; --exaggeration "
                    "multiplies that",
                    map.path, *map.facts.radius, scale.exaggeration)};
}

namespace {

/// All but the heights.
Heightmap headOf(RawMap raw, const DisplacedSphere& shape) {
    Heightmap map;
    map.width = raw.width;
    map.height = raw.height;
    map.registration = shape.registration.value_or(raw.gridline ? Registration::Gridline : Registration::Texel);
    map.longitude_origin = shape.longitude_origin.value_or(raw.longitude_origin.value_or(-180.0));
    map.full_scale = raw.full_scale;
    map.path = shape.map_path;
    map.type = raw.type;
    map.facts = raw.facts;
    tellSources(map, raw, shape);
    map.notices = raw.notices;
    if (map.registration == Registration::Gridline && map.height < 2)
        throwInvalid("{}: a map of gridline registration has {} row, expected at least 2, one at each pole", map.path,
                     map.height);
    return map;
}

void countFrom(Heightmap& map, float zero) {
    map.zero = zero;
    for (float& sample : map.samples) sample -= zero;
    for (float* value : {&map.north_pole, &map.south_pole, &map.least, &map.greatest}) *value -= zero;
}

}  // namespace

Heightmap makeHeightmap(RawMap raw, const DisplacedSphere& shape) {
    assert(raw.width > 0 && raw.height > 0);
    assert(raw.samples.size() == std::size_t(raw.width) * std::size_t(raw.height));
    prepareMap(raw, shape);
    std::vector<float> samples = std::move(raw.samples);
    raw.samples.clear();
    Heightmap map = headOf(raw, shape);
    map.samples = std::move(samples);
    const Nodata nodata(shape.nodata, raw.unknown_are_nan);
    fill(map, nodata);
    if (shape.blur > 0.0) blurMap(map.samples, map.width, map.height, shape.blur);
    map.north_pole = meanOfRow(map, 0);
    map.south_pole = meanOfRow(map, map.height - 1);
    if (map.registration == Registration::Gridline) {
        std::fill_n(map.samples.begin(), map.width, map.north_pole);
        std::fill_n(map.samples.end() - map.width, map.width, map.south_pole);
    }
    const auto [least, greatest] = std::ranges::minmax(map.samples);
    map.least = least;
    map.greatest = greatest;
    if (const float zero = zeroOf(least, greatest); zero != 0.0f && !shape.ripples) countFrom(map, zero);
    if (shape.ripples) {
        map.ripples = shape.ripples;
        map.least = 0.0f;
        map.greatest = 1.0f;
    }
    return map;
}

namespace {

/// Of all that gaps and survey depend on.
std::uint64_t surveyKey(const geo::LargeMap& source, const Heightmap& map, const DisplacedSphere& shape) {
    const std::string text = fmt::format("{} {} {} {} {} {}", source.identity(), int(source.kind()), map.width,
                                         map.height, int(map.registration), map.longitude_origin) +
                             (shape.nodata ? fmt::format(" nodata {}", *shape.nodata) : "") +
                             (shape.blur > 0.0 ? fmt::format(" blur {}", shape.blur) : "");
    Hash hash;
    hash.bytes(text.data(), text.size());
    return hash.value();
}

}  // namespace

float Heightmap::tiledAt(int i, int j) const {
    const bool pole_row = registration == Registration::Gridline && (j == 0 || j == height - 1);
    if (pole_row) return j == 0 ? north_pole : south_pole;
    return tiled->at(i, j);
}

Heightmap makeTiledHeightmap(std::shared_ptr<const geo::LargeMap> source, const DisplacedSphere& shape,
                             const MapProgress& progress) try {
    Heightmap map = headOf(source->head(), shape);
    const std::uint64_t key = surveyKey(*source, map, shape);
    std::optional<std::pair<Gaps, Survey>> known = SurveyCache::load(key);
    if (!known) {
        const bool may_lack = source->unknownCode() || source->head().unknown_are_nan || shape.nodata ||
                              source->kind() == geo::SampleKind::Float32;
        const double first_pass = may_lack ? 0.5 : 0.0;
        const auto pass = [&](double begin, double end) -> SurveyProgress {
            return [&progress, &shape, begin, end](double share) {
                if (progress && !progress(shape.map_path, begin + share * (end - begin)))
                    throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
            };
        };
        Gaps gaps;
        if (may_lack) gaps = Gaps(*source, Nodata(shape.nodata, source->head().unknown_are_nan), pass(0.0, first_pass));
        const SurveyProgress rest = pass(first_pass, 1.0);
        Survey survey = shape.blur > 0.0 ? surveyMap(*blurredMap(source, gaps, shape.blur), Gaps(), NodeGrid(map), rest)
                                         : surveyMap(*source, gaps, NodeGrid(map), rest);
        SurveyCache::keep(key, gaps, survey);
        known.emplace(std::move(gaps), std::move(survey));
    }
    map.nodata_count = std::size_t(known->first.unknown());
    if (shape.blur > 0.0) source = blurredMap(std::move(source), std::exchange(known->first, Gaps()), shape.blur);
    auto tiled = std::make_shared<TiledHeights>(std::move(source), std::move(known->first));
    const Survey& survey = known->second;
    const float zero = zeroOf(survey.least, survey.greatest);
    map.north_pole = survey.north_pole;
    map.south_pole = survey.south_pole;
    map.least = survey.least;
    map.greatest = survey.greatest;
    if (shape.blur == 0.0)  // else no value is a code
        warnOfNodata(map.notices, shape,
                     {survey.least, survey.second_least, survey.greatest, survey.at_least,
                      std::uint64_t(map.width) * std::uint64_t(map.height)});
    tiled->setSurvey(std::move(known->second));
    map.tiled = tiled;
    if (zero != 0.0f) {
        tiled->countFrom(zero);
        countFrom(map, zero);
    }
    return map;
} catch (const Error& error) {
    const bool named = std::string(error.what()).find(shape.map_path) != std::string::npos;
    if (named || error.code() != ExitCode::InvalidInput) throw;
    throw Error(error.code(), shape.map_path + ": " + error.what());
}

namespace {

/// Whether the surface can be made of heights in tiles.
bool takesTiles(const DisplacedSphere& shape) {
    return shape.blur <= kMostTiledBlur;
}

bool takesTiles(const RawMap& map) {
    return map.width >= NodeGrid::kLeastWidth && map.height >= NodeGrid::kLeastRows;
}

/// Null: the map does not stay in its file.
std::shared_ptr<const geo::LargeMap> openToStay(const DisplacedSphere& shape, std::uint64_t most_held) {
    if (shape.map_path.empty() || !takesTiles(shape)) return nullptr;
    auto large = geo::openLargeMap(shape.map_path, shape.band, most_held + 1);
    return large && takesTiles(large->head()) ? large : nullptr;
}

Heightmap readHeightmap(const DisplacedSphere& shape, const MapProgress& progress) {
    RawMap raw = geo::readMap(shape.map_path, shape.band);
    if (raw.width <= kWidestHeldMap || !takesTiles(shape) || !takesTiles(raw))
        return makeHeightmap(std::move(raw), shape);
    prepareMap(raw, shape);
    return makeTiledHeightmap(holdMap(std::move(raw)), shape, progress);
}

}  // namespace

bool staysInFile(const DisplacedSphere& shape, std::uint64_t most_held) try {
    return openToStay(shape, most_held) != nullptr;
} catch (const Error&) {
    return false;
}

// Its texels lie as those of texel registration do, whatever the whole map's are.
std::optional<Heightmap> loadCoarseHeightmap(const DisplacedSphere& shape) {
    const auto large = openToStay(shape, geo::kLargeMapTexels);
    if (!large || SurveyCache::has(surveyKey(*large, headOf(large->head(), shape), shape))) return {};
    RawMap raw = large->head();
    const int shrink = std::max(1, raw.width / kCoarseColumns);
    raw.width = std::max(raw.width / shrink, 1);
    raw.height = std::max(raw.height / shrink, 1);
    raw.samples = large->overview(raw.width, raw.height);
    raw.unknown_are_nan = true;
    DisplacedSphere coarse = shape;
    coarse.registration = Registration::Texel;
    coarse.blur = shape.blur / shrink;
    return makeHeightmap(std::move(raw), coarse);
}

Heightmap loadHeightmap(const DisplacedSphere& shape, std::uint64_t most_held, const MapProgress& progress) {
    if (auto large = openToStay(shape, most_held)) return makeTiledHeightmap(std::move(large), shape, progress);
    if (!shape.map_path.empty()) return readHeightmap(shape, progress);
    DisplacedSphere smooth = shape;
    smooth.registration = Registration::Texel;  // a single value has no grid lines
    smooth.nodata.reset();
    RawMap flat;
    flat.width = flat.height = 1;
    flat.samples = {0.0f};
    flat.type = shape.ripples ? "ripples" : "no map";
    return makeHeightmap(std::move(flat), smooth);
}

Relief makeRelief(const DisplacedSphere& shape, const Heightmap& map, const SourceLocation& where) {
    const double height_min = shape.height_min.value_or(shape.own_range ? map.storedLeast() : 0.0);
    const double height_max = shape.height_max.value_or(shape.own_range ? map.ownTop() : map.full_scale);
    Relief relief;
    relief.filter = shape.filter;
    relief.smooth_normals = shape.smooth_normals && !shape.ripples && shape.filter == Filter::Bilinear;
    relief.h_scale = 1.0 / (height_max - height_min);
    relief.h_offset = -height_min * relief.h_scale;
    if (!std::isfinite(relief.h_scale) || !std::isfinite(relief.h_offset))
        throwInvalid("{}: heightmin is {} and heightmax {}, expected two different values", where.text(), height_min,
                     height_max);
    if (const std::optional<TrueScale> true_scale = trueScaleOf(shape, map)) {
        relief.scale = true_scale->height_scale;
        relief.base = shape.radius - relief.scale * true_scale->midlevel;
    } else if (shape.height_scale) {
        relief.scale = *shape.height_scale;
        relief.base = shape.radius - relief.scale * shape.midlevel;
    } else {
        const double k = shape.radius * shape.max_displacement / 100.0;
        relief.scale = k * relief.h_scale;
        relief.base = shape.radius + k * (relief.h_offset - shape.midlevel);
    }
    relief.base += relief.scale * map.zero;
    relief.h_offset += relief.h_scale * map.zero;
    // r is monotone in the sample, also as rounded, and the poles' means lie between the samples' extremes.
    const bool up = relief.scale >= 0.0;
    const float lowest = up ? map.least : map.greatest, highest = up ? map.greatest : map.least;
    relief.least_radius = relief.base + relief.scale * double(lowest);
    relief.greatest_radius = relief.base + relief.scale * double(highest);
    if (!(relief.least_radius > 0.0)) refuseRadius(map, lowest, relief.least_radius, where);
    if (!std::isfinite(relief.greatest_radius)) refuseRadius(map, highest, relief.greatest_radius, where);
    if (relief.greatest_radius > limits::kReach * shape.radius)
        throwInvalid(
            "{}: the heights reach a radius of {:.4g}, {:.4g} times the shape's own; supported: up to {} times",
            where.text(), relief.greatest_radius, relief.greatest_radius / shape.radius, limits::kReach);
    return relief;
}

}  // namespace dsphere
