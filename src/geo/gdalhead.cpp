#include "geo/gdalhead.h"

#include <cmath>

namespace dsphere::geo {
namespace {

/// The bands whose mean is read: one, or R, G and B.
std::vector<int> bandsOf(const OpenMap& map, std::optional<int> wanted, Notices& notices) {
    const Gdal& g = gdal();
    const int count = map.bands();
    if (wanted && (*wanted < 1 || *wanted > count))
        throwInvalid("{}: band {} is asked for, but it has {}", map.name(), *wanted, count);
    if (wanted) return {*wanted};
    const auto colour = [&](int band) {
        return g.GDALGetRasterColorInterpretation(g.GDALGetRasterBand(map.dataset.get(), band));
    };
    if (count >= 3 && colour(1) == GCI_RedBand && colour(2) == GCI_GreenBand && colour(3) == GCI_BlueBand)
        return {1, 2, 3};
    const bool alpha = count == 2 && colour(2) == GCI_AlphaBand;
    if (count > 1 && !alpha)
        notices.push_back({Notice::Kind::Note, fmt::format("{}: has {} bands, of which the first is read; \"integer "
                                                           "band\" chooses another",
                                                           map.name(), count)});
    return {1};
}

/// The whole sphere in the file's own rows, for a file that does not say where it lies.
Placement unplaced(const OpenMap& map) {
    Placement placed;
    placed.columns = map.width();
    placed.rows = map.height();
    return placed;
}

Placement placementOf(const OpenMap& map, const Reference& reference, MapFacts& facts) {
    if (reference.other_projection)
        throwInvalid(
            "{}: its projection is {}, expected longitudes and latitudes; `dsphere import` makes such a map of "
            "it",
            map.name(), reference.projection);
    facts.projection = reference.projection;
    if (!reference.projection.empty()) facts.sources["projection"] = map.source();
    if (!reference.grid) return unplaced(map);
    Placement placed = placeOnSphere(map.name(), *reference.grid);
    facts.extent = placed.extent;
    for (const char* property : {"extent", "longitude_origin", "registration"}) facts.sources[property] = map.source();
    return placed;
}

void takeUnits(const OpenMap& map, const Units& units, MapFacts& facts) {
    facts.unit = units.unit;
    facts.value_scale = units.scale;
    facts.value_offset = units.offset;
    if (!units.unit.empty()) facts.sources["unit"] = units.unit_source;
    if (units.scale) facts.sources["scale"] = facts.sources["offset"] = map.source();
}

/// An offset that is far greater than all heights, or about the radius of the datum, is the radius that heights count
/// from.
void takeOffsetForRadius(MapFacts& facts, double greatest_stored) {
    constexpr double kLeastRadius = 1e5;
    if (facts.unit != "m" || facts.value_offset.value_or(0.0) <= 0.0) return;
    const double offset = *facts.value_offset;
    const double greatest = std::abs(*facts.value_scale) * greatest_stored;
    const bool about_datum = facts.radius && std::abs(offset - *facts.radius) < 0.2 * *facts.radius;
    if (!about_datum && !(offset >= kLeastRadius && offset > 5.0 * greatest)) return;
    facts.offset_is_radius = true;
    facts.radius = offset;
    facts.sources["radius"] = facts.sources["offset"];
}

}  // namespace

MapHead readHead(const OpenMap& file, std::optional<int> band, bool placed) {
    const Reference reference = placed ? referenceOf(file) : Reference();
    MapHead head;
    RawMap& map = head.map;
    head.placed = placementOf(file, reference, map.facts);
    map.width = head.placed.columns;
    map.height = head.placed.rows;
    map.notices = head.placed.notices;
    map.gridline = head.placed.gridline;
    if (reference.grid) map.longitude_origin = head.placed.longitude_origin;
    head.bands = bandsOf(file, band, map.notices);
    GDALRasterBandH first = gdal().GDALGetRasterBand(file.dataset.get(), head.bands[0]);
    head.sample = sampleTypeOf(file, first);
    if (placed) head.unknown = unknownOf(file, first, head.sample);
    map.full_scale = head.sample.fullScale();
    map.type = fmt::format("{} {}", head.sample.name(), nameOf(file.file.format));
    map.unknown_are_nan = head.unknown.any() || head.placed.rows > file.height();
    if (map.unknown_are_nan) map.facts.sources["nodata"] = file.source();
    map.facts.radius = reference.radius;
    if (reference.radius) map.facts.sources["radius"] = reference.radius_source;
    if (placed) takeUnits(file, unitsOf(file, first, head.sample, reference.radius.has_value()), map.facts);
    head.ellipsoid = reference.notices;
    return head;
}

void completeHead(MapHead& head, const OpenMap& file, double greatest) {
    RawMap& map = head.map;
    takeOffsetForRadius(map.facts, greatest);
    if (!map.facts.offset_is_radius)
        map.notices.insert(map.notices.end(), head.ellipsoid.begin(), head.ellipsoid.end());
    if (!map.longitude_origin && file.file.format != PlacedFile::Format::Tiff)
        map.notices.push_back({Notice::Kind::Warning,
                               file.name() + ": does not say where it lies: taken for a whole sphere from 180 degrees "
                                             "west, its first row in the north"});
}

Error withReason(const Error& error, const FileForGdal& found) {
    const std::string message = error.what(), name = found.file.path.string();
    if (message.find(name) != std::string::npos) return error;
    return Error(error.code(), fmt::format("{}: {}: {}", name, found.reason, message));
}

}  // namespace dsphere::geo
