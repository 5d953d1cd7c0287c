#include "cli/describemap.h"

#include "cli/mapcensus.h"
#include "cli/terminal.h"
#include "geo/largemap.h"
#include "geo/readmap.h"
#include "surface/bounds.h"
#include "surface/preparemap.h"
#include "surface/tiledheights.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace dsphere::cli {

namespace {

const char* nameOf(Registration registration) {
    return registration == Registration::Texel ? "texel" : "gridline";
}

constexpr std::uint64_t kHeightBytes = 4, kSplineBytes = 16;  // a node

// Of a node of the map's grid on the device, by what the shapes with that map read of it. Of a map that stays in its
// file not all nodes need be there.
std::uint64_t bytesPerNode(const SceneMaps& maps, int map) {
    if (const TiledHeights* tiled = maps.maps[std::size_t(map)]->tiled.get())
        return std::uint64_t(geo::bytesOf(tiled->kind()));
    bool heights = false, spline = false;
    for (std::size_t k = 0; k < maps.map_of_shape.size(); ++k) {
        if (maps.map_of_shape[k] != map) continue;
        const Relief& relief = maps.reliefs[k];
        heights = heights || relief.filter == Filter::Bilinear;
        spline = spline || relief.filter == Filter::BSpline || relief.smooth_normals;
    }
    return (heights ? kHeightBytes : 0) + (spline ? kSplineBytes : 0);
}

// What the marcher reads of a map: its nodes, the bounds of one relief (six faces of a cube and their pyramids), and
// two rows of edge directions.
void addDevice(Json& json, const NodeGrid& nodes, std::uint64_t node_bytes) {
    std::uint64_t side = std::uint64_t(boundsSide(nodes.width()));
    bool ripples = nodes.map().ripples.has_value();
    std::uint64_t node_count = ripples ? 0 : std::uint64_t(nodes.width()) * std::uint64_t(nodes.rows() + 1);
    std::uint64_t edges = (ripples ? 4 : 2) * std::uint64_t(std::max(nodes.width(), nodes.rows()));
    json["bounds"] = {{"side", side}, {"levels", std::bit_width(side)}, {"bytes", 4 * 9 * side * side}};
    json["device_bytes"] = node_bytes * node_count + 4 * 9 * side * side + 16 * edges;
}

double longitudeOrigin(const RawMap& map) {
    return map.longitude_origin.value_or(-180.0);
}

Registration registrationOf(const RawMap& map) {
    return map.gridline ? Registration::Gridline : Registration::Texel;
}

// A texel by its place in the file and on the planet, degrees.
Json placeOf(const RawMap& map, const CountedTexel& texel) {
    double shift = map.gridline ? 0.0 : 0.5;
    double steps = map.gridline ? std::max(map.height - 1, 1) : map.height;
    double longitude = longitudeOrigin(map) + (texel.column + shift) * 360.0 / map.width;
    return {{"value", texel.value},
            {"column", texel.column},
            {"row", texel.row},
            {"latitude", 90.0 - (texel.row + shift) * 180.0 / steps},
            {"longitude", longitude - 360.0 * std::floor((longitude + 180.0) / 360.0)}};
}

Json describeCensus(const RawMap& map, const MapCensus& census) {
    Json json = {{"least", nullptr}, {"greatest", nullptr}, {"mean", nullptr}};
    if (census.known > 0)
        json = {{"least", placeOf(map, *census.least)},
                {"greatest", placeOf(map, *census.greatest)},
                {"mean", census.sum / double(census.known)}};
    json["unknown_texels"] = census.unknown;
    return json;
}

template <typename T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json orNull(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

// What the values mean and where the map lies; `least` and `greatest` are stored values of known texels.
void addFacts(Json& json, const MapFacts& facts, double least, double greatest) {
    json["unit"] = orNull(facts.unit);
    json["scale"] = orNull(facts.value_scale);
    json["offset"] = orNull(facts.value_offset);
    json["radius"] = orNull(facts.radius);
    json["height_range"] = nullptr;
    if (!facts.unit.empty() && std::isfinite(least))
        json["height_range"] = {facts.heightOf(least), facts.heightOf(greatest)};
    json["extent"] = nullptr;
    if (facts.extent)
        json["extent"] = {{"west", facts.extent->west},
                          {"east", facts.extent->east},
                          {"south", facts.extent->south},
                          {"north", facts.extent->north}};
    json["projection"] = orNull(facts.projection);
    json["sources"] = Json::object();
    for (const auto& [property, source] : facts.sources) json["sources"][property] = source;
}

// The stored value of a texel that describeCensus has told; NaN: there is none.
double valueOf(const Json& texel) {
    return texel.is_null() ? std::nan("") : texel["value"].get<double>();
}

// `map` may lack its samples; `census` and `non_finite` may be null.
Json describeFile(const std::string& path, const RawMap& map, const Json& census, const Json& non_finite) {
    Json json = {{"map", path}, {"type", map.type}, {"width", map.width}, {"height", map.height}};
    json.update(census);
    json["non_finite_texels"] = non_finite;
    json["full_scale"] = map.full_scale;
    json["registration"] = nameOf(registrationOf(map));
    json["longitude_origin"] = longitudeOrigin(map);
    return json;
}

// A map that stays in its file: without `scan` what only its texels tell is null.
Json describeLargeFile(const std::string& path, const geo::LargeMap& map, bool scan) {
    RawMap head = map.head();
    DisplacedSphere shape;
    shape.map_path = path;
    prepareMap(head, shape);
    if (!scan)
        head.notices.push_back(
            {Notice::Kind::Note,
             fmt::format("{}: its {} texels are not read: --scan reads them, and tells the least and "
                         "the greatest, the mean and how many are unknown",
                         path, std::uint64_t(head.width) * std::uint64_t(head.height))});
    printNotices(head.notices);
    Json census = {{"least", nullptr}, {"greatest", nullptr}, {"mean", nullptr}, {"unknown_texels", nullptr}};
    Json non_finite = nullptr;
    if (scan) {
        ProgressLine line(ProgressMode::Auto, false, "scan");
        const MapCensus counted = censusOf(map, [&line](double share) { return line.update(share); });
        census = describeCensus(head, counted);
        non_finite = head.unknown_are_nan ? 0 : counted.not_finite;
    }
    Json json = describeFile(path, head, census, non_finite);
    json["scanned"] = scan;
    for (const char* property : {"registration", "longitude_origin"}) head.facts.sources.emplace(property, "default");
    addFacts(json, head.facts, valueOf(census["least"]), valueOf(census["greatest"]));
    Heightmap grid;  // without samples, whose number alone is asked for here
    grid.width = head.width;
    grid.height = head.height;
    grid.registration = registrationOf(head);
    addDevice(json, NodeGrid(grid), std::uint64_t(geo::bytesOf(map.kind())));
    return json;
}

}  // namespace

Json describeMapFile(const std::string& path, bool scan) {
    if (const auto large = geo::openLargeMap(path, {}, geo::kLargeMapTexels + 1))
        return describeLargeFile(path, *large, scan);
    RawMap map = geo::readMap(path);
    const auto not_finite = std::ranges::count_if(map.samples, [](float value) { return !std::isfinite(value); });
    const auto non_finite_texels = map.unknown_are_nan ? 0 : not_finite;
    DisplacedSphere shape;
    shape.map_path = path;
    prepareMap(map, shape);
    printNotices(map.notices);
    const Json census = describeCensus(map, censusOf(map));
    Json json = describeFile(path, map, census, non_finite_texels);
    json["scanned"] = true;
    // Unknown texels' values do not matter to the nodes' number, which is what is asked here.
    std::replace_if(
        map.samples.begin(), map.samples.end(), [](float value) { return !std::isfinite(value); }, 0.0f);
    const Heightmap heightmap = makeHeightmap(std::move(map), shape);
    addFacts(json, heightmap.facts, valueOf(census["least"]), valueOf(census["greatest"]));
    addDevice(json, NodeGrid(heightmap), kHeightBytes);
    return json;
}

Json describeMap(const SceneMaps& maps, int index) {
    const Heightmap& map = *maps.maps[std::size_t(index)];
    Json json = {{"path", map.path.empty() ? Json(nullptr) : Json(map.path)},
                 {"type", map.type},
                 {"width", map.width},
                 {"height", map.height},
                 {"least", map.storedLeast()},
                 {"greatest", map.storedGreatest()},
                 {"nodata_texels", map.nodata_count},
                 {"registration", nameOf(map.registration)},
                 {"longitude_origin", map.longitude_origin}};
    addFacts(json, map.facts, map.storedLeast(), map.storedGreatest());
    addDevice(json, NodeGrid(map), bytesPerNode(maps, index));
    return json;
}

}  // namespace dsphere::cli
