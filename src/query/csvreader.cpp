#include "query/rayreader.h"

#include "base/error.h"
#include "query/csvtable.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dsphere::query {

namespace {

constexpr const char* kExpected =
    "expected ox,oy,oz,dx,dy,dz, or lat,lon,alt,azimuth,elevation, or from_x,from_y,from_z (or "
    "from_lat,from_lon,from_alt) "
    "with to_x,to_y,to_z (or to_lat,to_lon,to_alt); `ground` may stand for `alt`; tmin,tmax as well";

constexpr int kAbsent = -1;

/// The columns of a point: Cartesian, or latitude, longitude and a height.
struct PointColumns {
    std::array<int, 3> at{kAbsent, kAbsent, kAbsent};
    bool geographic = false;
    Geography::Above above = Geography::Above::Sphere;
};

/// What the columns of a file mean.
class Columns {
  public:
    Columns(std::vector<std::string> names, const std::string& where) : names_(std::move(names)), where_(where) {
        used_.assign(names_.size(), false);
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (std::count(names_.begin(), names_.end(), names_[i]) > 1)
                refuse("the column '" + names_[i] + "' stands twice");
        if (has("ox") || has("dx")) {
            origin = {.at = {need("ox"), need("oy"), need("oz")}};
            direction = {need("dx"), need("dy"), need("dz")};
        } else if (has("lat")) {
            origin = geographic("");
            azimuth = need("azimuth");
            elevation = need("elevation");
        } else {
            origin = point("from_");
            target = point("to_");
        }
        t_min = take("tmin");
        t_max = take("tmax");
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (!used_[i]) refuse("the column '" + names_[i] + "' is unknown, or does not go with the others");
    }

    PointColumns origin, target;
    std::array<int, 3> direction{kAbsent, kAbsent, kAbsent};
    int azimuth = kAbsent, elevation = kAbsent, t_min = kAbsent, t_max = kAbsent;

  private:
    [[noreturn]] void refuse(const std::string& what) const { throwInvalid("{}: {}; {}", where_, what, kExpected); }
    bool has(const std::string& name) const { return std::ranges::find(names_, name) != names_.end(); }

    int take(const std::string& name) {
        const auto found = std::ranges::find(names_, name);
        if (found == names_.end()) return kAbsent;
        used_[std::size_t(found - names_.begin())] = true;
        return int(found - names_.begin());
    }

    int need(const std::string& name) {
        const int i = take(name);
        if (i == kAbsent) refuse(fmt::format("the columns {} lack '{}'", fmt::join(names_, ","), name));
        return i;
    }

    PointColumns geographic(const std::string& prefix) {
        const bool ground = has(prefix + "ground") && !has(prefix + "alt");
        return {.at = {need(prefix + "lat"), need(prefix + "lon"), need(prefix + (ground ? "ground" : "alt"))},
                .geographic = true,
                .above = ground ? Geography::Above::Ground : Geography::Above::Sphere};
    }

    PointColumns point(const std::string& prefix) {
        if (has(prefix + "lat")) return geographic(prefix);
        return {.at = {need(prefix + "x"), need(prefix + "y"), need(prefix + "z")}};
    }

    std::vector<std::string> names_;
    std::string where_;
    std::vector<bool> used_;
};

class CsvReader : public RayReader {
  public:
    CsvReader(InputStream stream, const Geography& geography)
        : geography_(geography), table_(std::move(stream), kExpected), columns_(table_.names(), table_.where()) {
        values_.resize(table_.names().size());
    }

    RayRows read(std::vector<double>& room, std::size_t most) override {
        room.clear();
        while (room.size() < 8 * most && table_.next()) appendRay(room);
        return {room.data(), 8, room.size() / 8};
    }

    std::optional<std::uint64_t> count() const override { return {}; }
    std::optional<double> share() const override {
        const std::optional<std::uint64_t> size = table_.stream().size();
        if (!size || *size == 0) return {};
        return std::min(1.0, double(table_.bytes()) / double(*size));
    }

  private:
    double value(int column) const { return values_[std::size_t(column)]; }

    dvec3 point(const PointColumns& of) const {
        const dvec3 given(value(of.at[0]), value(of.at[1]), value(of.at[2]));
        return of.geographic ? geography_.point(given.x, given.y, given.z, of.above, table_.where()) : given;
    }

    void appendRay(std::vector<double>& room) {
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = table_.number(i);
        const dvec3 origin = point(columns_.origin);
        dvec3 direction;
        double t_max = std::numeric_limits<double>::infinity();
        if (columns_.azimuth != kAbsent) {
            direction = geography_.direction(value(columns_.origin.at[0]), value(columns_.origin.at[1]),
                                             value(columns_.azimuth), value(columns_.elevation));
        } else if (columns_.direction[0] != kAbsent) {
            direction = {value(columns_.direction[0]), value(columns_.direction[1]), value(columns_.direction[2])};
        } else {
            direction = point(columns_.target) - origin;
            t_max = 1.0;
        }
        room.insert(room.end(), {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z});
        room.push_back(columns_.t_min == kAbsent ? 0.0 : value(columns_.t_min));
        room.push_back(columns_.t_max == kAbsent ? t_max : value(columns_.t_max));
    }

    const Geography& geography_;
    CsvTable table_;
    Columns columns_;
    std::vector<double> values_;
};

}  // namespace

std::unique_ptr<RayReader> openCsv(InputStream stream, const Geography& geography) {
    return std::make_unique<CsvReader>(std::move(stream), geography);
}

}  // namespace dsphere::query
