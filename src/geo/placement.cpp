#include "geo/placement.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace dsphere::geo {
namespace {

// Shares of a texel: how far rows may lie beside those of a whole sphere, and what is worth a word.
constexpr double kMostOff = 0.1, kWorthANote = 0.01;

double awayFromWhole(double x) {
    return std::abs(x - std::round(x));
}

MapExtent extentOf(const LatLonGrid& grid) {
    const double far_x = grid.west + grid.dx * grid.width, far_y = grid.north + grid.dy * grid.height;
    return {std::min(grid.west, far_x), std::max(grid.west, far_x), std::min(grid.north, far_y),
            std::max(grid.north, far_y)};
}

std::string textOf(const MapExtent& extent) {
    return fmt::format("longitudes {:.6g} to {:.6g}, latitudes {:.6g} to {:.6g}", extent.west, extent.east,
                       extent.south, extent.north);
}

/// The columns that are distinct; more than go around once repeat the first ones.
void placeColumns(const std::string& file, const LatLonGrid& grid, Placement& placed) {
    const double step = std::abs(grid.dx), around = 360.0 / step;
    const int whole = int(std::lround(std::min(around, 1e9)));
    if (grid.width < whole || whole < 1)
        throwInvalid(
            "{}: covers {}, expected all 360 degrees of longitude; `dsphere import` makes a global map of such pieces",
            file, textOf(placed.extent));
    placed.columns = whole;
    placed.mirrored = grid.dx < 0.0;
    if (std::abs(around - whole) > kWorthANote)
        placed.notices.push_back(
            {Notice::Kind::Note,
             fmt::format("{}: its {} columns span {:.6g} degrees, taken as 360", file, whole, step * whole)});
    if (grid.width == whole + 1)
        placed.notices.push_back(
            {Notice::Kind::Note,
             fmt::format("{}: the last of its {} columns repeats the first and is dropped", file, grid.width)});
    if (grid.width > whole + 1)
        placed.notices.push_back(
            {Notice::Kind::Note, fmt::format("{}: the last {} of its {} columns repeat the first ones and are dropped",
                                             file, grid.width - whole, grid.width)});
}

/// Rows of texels when these fit, else gridlines: which have a row more, half a step higher.
void placeRows(const std::string& file, const LatLonGrid& grid, Placement& placed) {
    const double step = std::abs(grid.dy), down = 180.0 / step, above = (90.0 - placed.extent.north) / step;
    const double off_whole = awayFromWhole(down), off_texel = awayFromWhole(above),
                 off_line = awayFromWhole(above + 0.5);
    const bool gridline = off_line < off_texel;
    const double first = std::round(gridline ? above + 0.5 : above), rows = std::round(down) + (gridline ? 1.0 : 0.0);
    if (!(down < 1e9) || std::max(off_whole, std::min(off_line, off_texel)) > kMostOff || first < 0.0 ||
        first + grid.height > rows)
        throwInvalid(
            "{}: covers {} in {} rows, which do not lie as the rows of a map from pole to pole do; `dsphere import` "
            "makes a global map of it",
            file, textOf(placed.extent), grid.height);
    placed.gridline = gridline;
    placed.rows_above = int(first);
    placed.rows = int(rows);
    placed.flipped = grid.dy > 0.0;
    if (placed.rows > grid.height)
        placed.notices.push_back(
            {Notice::Kind::Note,
             fmt::format("{}: covers latitudes {:.6g} to {:.6g}; the {} rows beyond are unknown", file,
                         placed.extent.south, placed.extent.north, placed.rows - grid.height)});
}

}  // namespace

Placement placeOnSphere(const std::string& file, const LatLonGrid& grid) {
    if (!std::isfinite(grid.west) || !std::isfinite(grid.north) || !(std::abs(grid.dx) > 0.0) ||
        !(std::abs(grid.dy) > 0.0) || !std::isfinite(grid.dx) || !std::isfinite(grid.dy))
        throwInvalid("{}: says that its texels measure {} by {} degrees, expected finite numbers other than 0", file,
                     grid.dx, grid.dy);
    Placement placed;
    placed.extent = extentOf(grid);
    placeColumns(file, grid, placed);
    placeRows(file, grid, placed);
    const double half_x = 0.5 * std::abs(grid.dx), half_y = 0.5 * std::abs(grid.dy);
    if (placed.gridline)
        placed.extent = {placed.extent.west + half_x, placed.extent.east - half_x, placed.extent.south + half_y,
                         placed.extent.north - half_y};
    // Of the columns that are kept the western edge: a gridline map's first node lies half a step inside it.
    const double west = placed.mirrored ? grid.west + grid.dx * placed.columns : grid.west;
    const double origin = west + (placed.gridline ? half_x : 0.0);
    placed.longitude_origin = origin - 360.0 * std::floor((origin + 180.0) / 360.0);
    return placed;
}

}  // namespace dsphere::geo
