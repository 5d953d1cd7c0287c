#include "geo/gdalreference.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace dsphere::geo {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

using GeoTransform = std::array<double, 6>;

/// The mean of an ellipsoid's half axes, and a word about the error.
void takeEllipsoid(Reference& result, const std::string& name, std::array<double, 3> axes) {
    const double mean = (axes[0] + axes[1] + axes[2]) / 3.0;
    const auto [least, greatest] = std::ranges::minmax(axes);
    result.radius = mean;
    if (greatest - least <= 1e-6 * greatest) return;
    result.notices.push_back(
        {Notice::Kind::Warning,
         fmt::format(
             "{}: heights count from an ellipsoid of {:.10g}, {:.10g} and {:.10g} m, which is drawn as a sphere "
             "of {:.10g} m: off by up to {:.0f} m",
             name, axes[0], axes[1], axes[2], mean, std::max(greatest - mean, mean - least))});
}

void readRadius(Reference& result, const OpenMap& map, OGRSpatialReferenceH crs) {
    if (map.label) {
        const auto a = map.label->number("A_AXIS_RADIUS"), b = map.label->number("B_AXIS_RADIUS"),
                   c = map.label->number("C_AXIS_RADIUS");
        if (a && *a > 0.0) {
            takeEllipsoid(result, map.name(), {1000.0 * *a, 1000.0 * b.value_or(*a), 1000.0 * c.value_or(*a)});
            result.radius_source = "label";
            return;
        }
    }
    if (!crs) return;
    OGRErr failed = OGRERR_NONE;
    const double a = gdal().OSRGetSemiMajor(crs, &failed), b = gdal().OSRGetSemiMinor(crs, &failed);
    if (failed != OGRERR_NONE || !(a > 0.0) || !(b > 0.0)) return;
    takeEllipsoid(result, map.name(), {a, a, b});
    result.radius_source = map.source();
}

/// From coordinates to degrees: longitude = lon + x * lon_scale, latitude = lat + y * lat_scale.
struct ToDegrees {
    double lon = 0.0, lon_scale = 1.0, lat = 0.0, lat_scale = 1.0;
};

std::optional<ToDegrees> toDegrees(OGRSpatialReferenceH crs, std::string& projection) {
    const Gdal& g = gdal();
    const double meridian = g.OSRGetPrimeMeridian(crs, nullptr);
    if (g.OSRIsGeographic(crs)) {
        projection = "geographic";
        const double unit = g.OSRGetAngularUnits(crs, nullptr) * kDegrees;
        // 1 exactly for degrees, whose unit is pi / 180 as rounded
        const double scale = std::abs(unit - 1.0) < 1e-9 ? 1.0 : unit;
        return ToDegrees{meridian, scale, 0.0, scale};
    }
    const char *method = g.OSRGetAttrValue(crs, "PROJECTION", 0), *name = g.OSRGetName(crs);
    if (!method || std::string(method) != SRS_PT_EQUIRECTANGULAR) {
        projection = name ? name : "an unknown one";
        return {};
    }
    projection = "equirectangular";
    const auto parameter = [&](const char* key) { return g.OSRGetNormProjParm(crs, key, 0.0, nullptr); };
    const double metres = g.OSRGetLinearUnits(crs, nullptr), radius = g.OSRGetSemiMajor(crs, nullptr);
    const double narrow = std::cos(parameter(SRS_PP_STANDARD_PARALLEL_1) / kDegrees);
    ToDegrees to;
    to.lat_scale = metres / radius * kDegrees;
    to.lon_scale = to.lat_scale / narrow;
    to.lon =
        meridian + parameter(SRS_PP_CENTRAL_MERIDIAN) - parameter(SRS_PP_FALSE_EASTING) / radius * kDegrees / narrow;
    to.lat = parameter(SRS_PP_LATITUDE_OF_ORIGIN) - parameter(SRS_PP_FALSE_NORTHING) / radius * kDegrees;
    return to;
}

/// Limits that differ from whole texels of the sphere by rounding alone are these: 1e-6 of a texel.
double snapped(double degrees, double step) {
    const double whole = std::round(degrees / step * 2.0) * step / 2.0;
    return std::abs(degrees - whole) < 1e-6 * std::abs(step) ? whole : degrees;
}

LatLonGrid gridOf(const OpenMap& map, const GeoTransform& t, const ToDegrees& to) {
    LatLonGrid grid{map.width(),         map.height(),       to.lon + t[0] * to.lon_scale, to.lat + t[3] * to.lat_scale,
                    t[1] * to.lon_scale, t[5] * to.lat_scale};
    grid.west = snapped(grid.west, grid.dx);
    grid.north = snapped(grid.north, grid.dy);
    return grid;
}

bool mayBeDegrees(const LatLonGrid& grid) {
    const double east = grid.west + grid.dx * grid.width, south = grid.north + grid.dy * grid.height;
    constexpr double kMostLongitude = 721.0, kMostLatitude = 91.0;
    const double slack = 0.5 * std::abs(grid.dy);
    return std::max(std::abs(grid.west), std::abs(east)) <= kMostLongitude &&
           std::max(std::abs(grid.north), std::abs(south)) <= std::max(kMostLatitude, 90.0 + slack);
}

}  // namespace

Reference referenceOf(const OpenMap& map) {
    const Gdal& g = gdal();
    GdalMessages messages;
    Reference result;
    OGRSpatialReferenceH crs = g.GDALGetSpatialRef(map.dataset.get());
    if (crs && !g.OSRIsGeographic(crs) && !g.OSRIsProjected(crs)) crs = nullptr;  // a plane of its own
    readRadius(result, map, crs);
    if (map.label) result.grid = map.label->grid(map.width(), map.height());
    GeoTransform transform{};
    const bool placed = g.GDALGetGeoTransform(map.dataset.get(), transform.data()) == CE_None;
    ToDegrees to;
    if (crs) {
        const std::optional<ToDegrees> known = toDegrees(crs, result.projection);
        result.other_projection = !known;
        to = known.value_or(to);
    }
    if (result.grid) {
        result.projection = "equirectangular";
        result.other_projection = false;
        return result;
    }
    if (!placed) {
        if (g.GDALGetGCPCount(map.dataset.get()) > 0) {
            result.projection = "control points";
            result.other_projection = true;
        }
        return result;
    }
    if (transform[2] != 0.0 || transform[4] != 0.0) {
        result.projection = "a rotated grid";
        result.other_projection = true;
    }
    if (result.other_projection) return result;
    const LatLonGrid grid = gridOf(map, transform, to);
    if (!crs && !mayBeDegrees(grid)) {
        result.projection = "coordinates in an unknown system";
        result.other_projection = true;
        return result;
    }
    if (!crs) result.projection = "geographic";
    result.grid = grid;
    return result;
}

std::optional<double> metresIn(const std::string& unit) {
    struct Unit {
        const char* name;
        double metres;
    };
    constexpr std::array kUnits{Unit{"m", 1.0},     Unit{"meter", 1.0},        Unit{"metre", 1.0},
                                Unit{"km", 1000.0}, Unit{"kilometer", 1000.0}, Unit{"kilometre", 1000.0},
                                Unit{"ft", 0.3048}, Unit{"foot", 0.3048},      Unit{"feet", 0.3048}};
    std::string word = unit;
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (word.size() > 2 && word.ends_with('s')) word.pop_back();
    for (const Unit& known : kUnits)
        if (word == known.name) return known.metres;
    return {};
}

OGRSpatialReferenceH newSphere(std::optional<double> radius) {
    constexpr double kEarth = 6371008.8;
    const OGRSpatialReferenceH crs = gdal().OSRNewSpatialReference(nullptr);
    gdal().OSRSetGeogCS(crs, "sphere", "sphere", "sphere", radius.value_or(kEarth), 0.0, "Greenwich", 0.0, "degree",
                        1.0 / kDegrees);
    return crs;
}

std::string wktOf(OGRSpatialReferenceH crs) {
    char* text = nullptr;
    gdal().OSRExportToWkt(crs, &text);
    std::string wkt = text ? text : "";
    gdal().VSIFree(text);
    return wkt;
}

}  // namespace dsphere::geo
