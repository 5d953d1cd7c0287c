#include "image/mapchannels.h"

#include <algorithm>

#include "base/error.h"

namespace dsphere {

void ColourCensus::BytePair::add(double high_step, double low_step) {
    if (high_step == 0.0 && low_step == 0.0) return;
    ++steps;
    high += std::abs(high_step);
    low += std::abs(low_step);
    together += std::abs(256.0 * high_step + low_step);
    apart += std::abs(256.0 * high_step) + std::abs(low_step);
}

// In pictures the channels rise and fall together. The low byte of a height does not: where it overflows, it falls by
// some 255 while the high byte rises by 1, so that the number they form moves far less than its parts; and on steep
// ground it jumps about while the high byte goes smoothly.
bool ColourCensus::BytePair::isOneNumber() const {
    constexpr std::size_t kLeastSteps = 64;
    constexpr double kNoise = 30.0;  // codes from texel to texel; white noise has 85
    if (steps < kLeastSteps || high == 0.0) return false;
    const bool overflows = together < 0.5 * apart;
    const bool jumps = low > kNoise * double(steps) && high < 0.25 * low;
    return overflows || jumps;
}

void ColourCensus::count(const Colour& colour) {
    for (std::size_t c = 0; c < 3; ++c) {
        least_[c] = std::min(least_[c], colour[c]);
        greatest_[c] = std::max(greatest_[c], colour[c]);
    }
    const auto [low, high] = std::ranges::minmax(colour);
    difference_ = std::max(difference_, high - low);
    if (has_previous_ && colour != previous_) {
        const auto step = [&](std::size_t c) { return double(colour[c]) - double(previous_[c]); };
        red_green_.add(step(0), step(1));
        green_blue_.add(step(1), step(2));
    }
    previous_ = colour;
    has_previous_ = true;
}

// -10000 + 0.1 x the 24-bit number: red stays below 16 up to heights of 95 km, and in Terrarium's, 32768 + the height,
// that is a depth of 28 km.
bool ColourCensus::isTerrainRgb() const {
    return greatest_[0] < 16.0f;
}

void ColourCensus::report(RawMap& map, const std::string& path) const {
    if (difference_ <= 0.0f) return;
    const std::string ranges = fmt::format(
        "its red, green and blue channels differ (R {:.6g} to {:.6g}, G {:.6g} to {:.6g}, B {:.6g} to {:.6g})",
        least_[0], greatest_[0], least_[1], greatest_[1], least_[2], greatest_[2]);
    const bool bytes = map.full_scale == 255.0;
    if (bytes && (red_green_.isOneNumber() || green_blue_.isOneNumber()))
        throwInvalid(
            "{}: {} as the bytes of one number do, of which a mean would be noise. They are probably heights in "
            "metres coded as {}; expected heights in one channel: decode them into a 16-bit PNG or a float TIFF first",
            path, ranges,
            isTerrainRgb() ? "-10000 + (R x 65536 + G x 256 + B) x 0.1 (Mapbox Terrain-RGB)"
                           : "R x 256 + G + B / 256 - 32768 (Terrarium)");
    const float range = std::ranges::max(greatest_) - std::ranges::min(least_);
    constexpr float kSlight = 0.01f;  // what colour conversions and lossy compression leave of a grey map
    if (difference_ <= kSlight * range)
        map.notices.push_back({Notice::Kind::Note, fmt::format("{}: {} by at most {:.6g}: heights are their mean", path,
                                                               ranges, difference_)});
    else
        map.notices.push_back({Notice::Kind::Warning,
                               fmt::format("{}: {}: heights are their mean; a picture is no heightmap", path, ranges)});
}

void AlphaCensus::report(RawMap& map, const std::string& path) const {
    if (hidden_ > 0) map.unknown_are_nan = true;
    if (hidden_ == map.samples.size())
        throwInvalid("{}: its alpha is 0 everywhere, so that no height is known; expected some texels to be opaque",
                     path);
    if (partial_ > 0)
        map.notices.push_back(
            {Notice::Kind::Note,
             fmt::format("{}: partly transparent texels: {}; their heights count as they are stored", path, partial_)});
}

}  // namespace dsphere
