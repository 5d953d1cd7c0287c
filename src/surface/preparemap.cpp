#include "surface/preparemap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace dsphere {
namespace {

template <typename... Args>
void say(RawMap& map, const DisplacedSphere& shape, Notice::Kind kind, fmt::format_string<Args...> format,
         Args&&... args) {
    map.notices.push_back({kind, shape.map_path + ": " + fmt::format(format, std::forward<Args>(args)...)});
}

void markUnknown(RawMap& map, const DisplacedSphere& shape) {
    const auto first = std::ranges::find_if_not(map.samples, isHeight);
    if (first == map.samples.end()) return;
    const bool declared = shape.nodata.has_value() || map.unknown_are_nan;
    const auto index = std::size_t(first - map.samples.begin()), width = std::size_t(map.width);
    const float value = *first;
    const auto count = std::count_if(first, map.samples.end(), [](float stored) { return !isHeight(stored); });
    std::replace_if(
        first, map.samples.end(), [](float stored) { return !isHeight(stored); },
        std::numeric_limits<float>::quiet_NaN());
    map.unknown_are_nan = true;
    if (declared) return;
    say(map, shape, Notice::Kind::Warning,
        "{} of {} texels hold no number that could be a height, the first {:.8g} at column {}, row {}: they count as "
        "unknown",
        count, map.samples.size(), value, index % width, index / width);
}

/// Of all texels of a map.
LowestValues lowestValuesOf(const RawMap& map) {
    float least = HUGE_VALF, next = HUGE_VALF, greatest = -HUGE_VALF;
    for (const float stored : map.samples) {
        if (stored < least) next = least, least = stored;
        if (stored > least && stored < next) next = stored;
        if (stored > greatest) greatest = stored;
    }
    return {least, next, greatest, std::uint64_t(std::ranges::count(map.samples, least)), map.samples.size()};
}

bool sameSample(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// Whether the last column repeats the first, and that means something: other columns differ from it.
bool repeatsFirstColumn(const RawMap& map) {
    const auto width = std::size_t(map.width);
    bool varies = false;
    for (std::size_t at = 0; at < map.samples.size(); at += width) {
        const float* row = &map.samples[at];
        if (!sameSample(row[0], row[width - 1])) return false;
        varies = varies || std::any_of(row, row + width, [&](float stored) { return !sameSample(stored, row[0]); });
    }
    return varies;
}

bool firstColumnVaries(const RawMap& map) {
    for (std::size_t at = 0; at < map.samples.size(); at += std::size_t(map.width))
        if (!sameSample(map.samples[at], map.samples[0])) return true;
    return false;
}

/// Row by row in place, from the north.
void dropLastColumn(RawMap& map) {
    const auto width = std::size_t(map.width);
    for (std::size_t j = 1; j < std::size_t(map.height); ++j)
        std::copy_n(&map.samples[j * width], width - 1, &map.samples[j * (width - 1)]);
    map.samples.resize(std::size_t(map.height) * (width - 1));
    --map.width;
}

void dropRepeatedColumn(RawMap& map, const DisplacedSphere& shape) {
    const bool said_gridline = shape.registration ? *shape.registration == Registration::Gridline : map.gridline;
    if (map.facts.extent) return;  // the file's own place tells which columns are the same
    if (map.width < 3 || map.width % 2 == 0 || map.height < 3 || !repeatsFirstColumn(map)) return;
    // An island's map is sea at both edges: one value all along them proves nothing.
    if (!said_gridline && !firstColumnVaries(map)) return;
    const int columns = map.width;
    dropLastColumn(map);
    const bool grid = !shape.registration && !map.gridline && columns == 2 * map.height - 1;
    if (grid) map.gridline = true;
    say(map, shape, Notice::Kind::Note, "the last of its {} columns repeats the first and is left out{}", columns,
        grid ? fmt::format("; with {} rows that is a map on grid lines, and is read as such", map.height) : "");
}

/// Without the repeated column only the shape speaks for grid lines, which is not enough to take them for granted.
void noteGridShape(RawMap& map, const DisplacedSphere& shape) {
    constexpr int kLeastWidth = 32;
    if (map.facts.extent || shape.registration || map.gridline || map.width < kLeastWidth ||
        map.width != 2 * (map.height - 1))
        return;
    say(map, shape, Notice::Kind::Note,
        "{}x{} texels are the shape of a map on grid lines, with a row at each pole: if it is one, say \"string "
        "registration\" \"gridline\" in the scene, or --registration gridline",
        map.width, map.height);
}

}  // namespace

void warnOfNodata(Notices& notices, const DisplacedSphere& shape, const LowestValues& values) {
    constexpr std::array kUsual{-9999.0f, -99999.0f, -32767.0f, -32768.0f};
    constexpr float kHuge = -1e20f;
    if (shape.nodata) return;
    const auto& [least, next, greatest, at_least, texels] = values;
    const bool usual = std::ranges::find(kUsual, least) != kUsual.end() || least < kHuge;
    const float gap = next - least, range = greatest - next;
    if (!usual || next == HUGE_VALF || gap < 0.25f * range) return;
    notices.push_back(
        {Notice::Kind::Warning,
         fmt::format("{}: {} of {} texels hold {:.8g}, far below all others, which are {:.8g} to {:.8g}: if that means "
                     "unknown, say \"float nodata\" {:.8g} in the scene, or --nodata",
                     shape.map_path, at_least, texels, least, next, greatest, least)});
}

void prepareMap(RawMap& map, const DisplacedSphere& shape) {
    markUnknown(map, shape);
    warnOfNodata(map.notices, shape, lowestValuesOf(map));
    dropRepeatedColumn(map, shape);
    noteGridShape(map, shape);
}

}  // namespace dsphere
