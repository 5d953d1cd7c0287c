#include "query/suns.h"

#include "base/error.h"
#include "query/csvtable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace dsphere::query {

namespace {

constexpr const char* kExpectedOfSuns =
    "expected lon,lat, and if wanted distance (R, or inf), radius (degrees) and name";

/// Where each of these columns stands; absent: as many as there are columns.
struct Columns {
    std::size_t longitude, latitude, distance, radius, name;
};

Columns columnsOf(const CsvTable& table) {
    const std::vector<std::string>& names = table.names();
    constexpr std::array<const char*, 5> kKnown{"lon", "lat", "distance", "radius", "name"};
    for (const std::string& name : names) {
        if (std::ranges::find(kKnown, name) == kKnown.end())
            throwInvalid("{}: the column '{}' is unknown; {}", table.where(), name, kExpectedOfSuns);
        if (std::ranges::count(names, name) > 1)
            throwInvalid("{}: the column '{}' stands twice; {}", table.where(), name, kExpectedOfSuns);
    }
    const auto at = [&](const char* name) { return std::size_t(std::ranges::find(names, name) - names.begin()); };
    for (const char* name : {"lon", "lat"})
        if (at(name) == names.size())
            throwInvalid("{}: lacks the column '{}'; {}", table.where(), name, kExpectedOfSuns);
    return {at("lon"), at("lat"), at("distance"), at("radius"), at("name")};
}

}  // namespace

std::string faultOf(const Sun& sun) {
    if (!std::isfinite(sun.longitude)) return fmt::format("a longitude of {}, expected degrees", sun.longitude);
    if (!(std::abs(sun.latitude) <= 90.0)) return fmt::format("a latitude of {}, expected -90 to 90", sun.latitude);
    if (sun.distance && !(*sun.distance > 1.0))
        return fmt::format("a distance of {}, expected above 1 R, or inf", *sun.distance);
    if (!(sun.radius >= 0.0 && sun.radius < 90.0))
        return fmt::format("a radius of {}, expected 0 to 90 degrees", sun.radius);
    return "";
}

std::vector<Sun> readSuns(const std::string& file) {
    CsvTable table(InputStream(file), kExpectedOfSuns);
    const Columns columns = columnsOf(table);
    const std::size_t absent = table.names().size();
    std::vector<Sun> suns;
    std::set<std::string> names;
    while (table.next()) {
        Sun sun{.longitude = table.number(columns.longitude), .latitude = table.number(columns.latitude)};
        if (columns.distance < absent) sun.distance = table.number(columns.distance);
        if (sun.distance && std::isinf(*sun.distance) && *sun.distance > 0.0) sun.distance.reset();
        if (columns.radius < absent) sun.radius = table.number(columns.radius);
        if (columns.name < absent) sun.name = table.word(columns.name);
        if (const std::string fault = faultOf(sun); !fault.empty()) throwInvalid("{}: {}", table.where(), fault);
        if (!sun.name.empty() && !names.insert(sun.name).second)
            throwInvalid("{}: the name '{}' stands twice", table.where(), sun.name);
        suns.push_back(sun);
    }
    if (suns.empty()) throwInvalid("{}: holds no suns", file);
    return suns;
}

}  // namespace dsphere::query
