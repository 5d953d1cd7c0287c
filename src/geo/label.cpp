#include "geo/label.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "image/inputfile.h"

namespace dsphere::geo {
namespace {

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::string unquoted(std::string text) {
    text = trimmed(text);
    if (text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0])
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

std::optional<double> decimal(const std::string& text) {
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || end == begin) return {};
    const std::string rest = trimmed(end);
    if (!rest.empty() && rest[0] != '<') return {};
    return value;
}

/// "16#FF7FFFFB#": the bits of a float, or of an integer.
std::optional<double> hexadecimal(const std::string& text) {
    if (!text.starts_with("16#")) return {};
    std::uint32_t bits = 0;
    const char *begin = text.data() + 3, *last = text.data() + text.size();
    const auto [end, error] = std::from_chars(begin, last, bits, 16);
    if (error != std::errc()) return {};
    if (end - begin <= 4) return double(std::int16_t(bits));
    return double(std::bit_cast<float>(bits));
}

}  // namespace

Pds3Label::Pds3Label(const std::filesystem::path& path) {
    InputFile file(path);
    std::string text(std::size_t(std::min<std::uint64_t>(1 << 20, file.size())), '\0');
    file.read(text.data(), text.size());
    std::istringstream lines(text);
    std::string line, object;
    while (std::getline(lines, line)) {
        line = trimmed(line);
        if (line == "END") break;
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) continue;
        const std::string key = trimmed(line.substr(0, equals)), value = unquoted(line.substr(equals + 1));
        if (key == "OBJECT" || key == "GROUP") object = value;
        if (key == "END_OBJECT" || key == "END_GROUP") object.clear();
        (object.ends_with("IMAGE") ? of_image_ : others_).emplace(key, value);
    }
}

std::string Pds3Label::text(const std::string& key) const {
    for (const auto* keys : {&of_image_, &others_})
        if (const auto found = keys->find(key); found != keys->end()) return found->second;
    return "";
}

std::optional<double> Pds3Label::number(const std::string& key) const {
    const std::string value = text(key);
    const std::optional<double> bits = hexadecimal(value);
    return bits ? bits : decimal(value);
}

std::optional<std::pair<std::string, double>> Pds3Label::missing() const {
    for (const char* key :
         {"MISSING_CONSTANT", "MISSING", "CORE_NULL", "NULL", "INVALID_CONSTANT", "NOT_APPLICABLE_CONSTANT"})
        if (const std::optional<double> value = number(key)) return std::pair{std::string(key), *value};
    return {};
}

std::optional<LatLonGrid> Pds3Label::grid(int width, int height) const {
    const std::string projection = text("MAP_PROJECTION_TYPE");
    if (!projection.starts_with("SIMPLE") && !projection.starts_with("EQUIRECTANGULAR")) return {};
    const std::optional<double> west = number("WESTERNMOST_LONGITUDE"), east = number("EASTERNMOST_LONGITUDE"),
                                north = number("MAXIMUM_LATITUDE"), south = number("MINIMUM_LATITUDE"),
                                resolution = number("MAP_RESOLUTION");
    if (!west || !east || !north || !south || !resolution || !(*north > *south)) return {};
    const double sign = text("POSITIVE_LONGITUDE_DIRECTION").starts_with("W") ? -1.0 : 1.0;
    const double left = sign * *west, turn = std::fmod(sign * *east - left, 360.0);
    const double across = turn > 0.0 ? turn : turn + 360.0, down = *north - *south;
    const double columns = across * *resolution, rows = down * *resolution;
    // The limits are those of texels' edges, or of their centres.
    for (const int less : {0, 1}) {
        if (std::abs(columns - (width - less)) > 0.25 || std::abs(rows - (height - less)) > 0.25) continue;
        const double dx = across / (width - less), dy = down / (height - less);
        return LatLonGrid{width, height, left - 0.5 * less * dx, *north + 0.5 * less * dy, dx, -dy};
    }
    return {};
}

}  // namespace dsphere::geo
