#include "image/geoidcomments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace dsphere {
namespace {

constexpr std::string_view kSpace = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

/// What follows the word `key` at the beginning of a comment; empty without such a comment.
std::string_view valueOf(std::string_view comments, std::string_view key) {
    while (!comments.empty()) {
        const std::size_t end = std::min(comments.find('\n'), comments.size());
        const std::string_view line = trimmed(comments.substr(0, end));
        const std::size_t word = std::min(line.find_first_of(kSpace), line.size());
        if (line.substr(0, word) == key) return trimmed(line.substr(word));
        comments.remove_prefix(std::min(end + 1, comments.size()));
    }
    return {};
}

std::optional<double> numberOf(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return {};
    return number;
}

/// Degrees of "90N", "15.5W" and their like; the letters are N and S, or E and W.
std::optional<double> degreesOf(std::string_view text, char positive, char negative) {
    if (text.empty() || (text.back() != positive && text.back() != negative)) return {};
    const std::optional<double> number = numberOf(text.substr(0, text.size() - 1));
    if (!number) return {};
    return text.back() == positive ? *number : -*number;
}

/// The longitude of "90N 0E".
double originOf(std::string_view text, const std::string& path) {
    const std::size_t word = std::min(text.find_first_of(kSpace), text.size());
    const std::optional<double> north = degreesOf(text.substr(0, word), 'N', 'S');
    const std::optional<double> east = degreesOf(trimmed(text.substr(word)), 'E', 'W');
    if (!north || *north != 90.0 || !east)
        throwInvalid("{}: its comments say that the origin is {:?}, expected a longitude at 90N, as in \"90N 0E\"",
                     path, text);
    return *east - 360.0 * std::floor((*east + 180.0) / 360.0);
}

}  // namespace

void applyGeoidComments(const std::string& comments, RawMap& map, const std::string& path) {
    const std::optional<double> offset = numberOf(valueOf(comments, "Offset"));
    const std::optional<double> scale = numberOf(valueOf(comments, "Scale"));
    if (!offset || !scale || *scale == 0.0) return;
    map.facts.value_offset = offset;
    map.facts.value_scale = scale;
    map.facts.unit = std::string("m");  // GCC 12 warns of an overlap when the characters are assigned
    const std::string_view origin = valueOf(comments, "Origin");
    if (!origin.empty()) map.longitude_origin = originOf(origin, path);
    map.gridline = valueOf(comments, "AREA_OR_POINT") == "Point";
    for (const char* property : {"unit", "scale", "offset", "registration", "longitude_origin"})
        map.facts.sources[property] = "label";
    map.notices.push_back(
        {Notice::Kind::Note, fmt::format("{}: by its comments, heights in metres are {} + {} x the stored values, the "
                                         "longitude origin is {} and the registration {}",
                                         path, *offset, *scale, map.longitude_origin.value_or(-180.0),
                                         map.gridline ? "gridline" : "texel")});
}

}  // namespace dsphere
