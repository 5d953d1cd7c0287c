#include "viewer/degrees.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

namespace dsphere::viewer {

std::string degreesText(double degrees, Directions directions, int places) {
    return fmt::format("{:.{}f}° {}", std::abs(degrees), places, directions[degrees < 0.0 ? 1 : 0]);
}

std::optional<double> degreesIn(const std::string& text, Directions directions, double most) {
    char* end = nullptr;
    double degrees = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) return {};
    std::string rest;
    for (const char* c = end; *c; ++c)
        if (!std::isspace(static_cast<unsigned char>(*c))) rest += *c;
    if (rest.starts_with("°")) rest.erase(0, std::string("°").size());
    const int letter = rest.empty() ? 0 : std::toupper(static_cast<unsigned char>(rest[0]));
    if (rest.size() > 1 || (letter && letter != directions[0] && letter != directions[1])) return {};
    if (letter == directions[1]) degrees = -degrees;
    if (!(std::abs(degrees) <= most)) return {};
    return degrees;
}

}  // namespace dsphere::viewer
