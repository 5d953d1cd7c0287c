#include "scene/directives.h"

#include <algorithm>

namespace dsphere {

namespace {

using Kind = PixelFilter::Kind;

constexpr Range kFilterRadius{0.01, 8.0};  // pixels
// The falloff stays within 0.001 to 1000, in both spellings.
constexpr Range kFilterAlpha{0.001, 1000.0}, kFilterSigma{0.03, 20.0};
constexpr Range kTau{1.0, 100.0};

// pbrt's default radius.
double radiusOf(Kind kind, bool v3) {
    switch (kind) {
        case Kind::Box:
            return 0.5;
        case Kind::Gaussian:
            return v3 ? 2.0 : 1.5;
        case Kind::Sinc:
            return 4.0;
        case Kind::Triangle:
        case Kind::Mitchell:
            break;
    }
    return 2.0;
}

// v3 says xwidth for what v4 calls xradius; the two cannot be mixed, since their defaults differ.
struct FilterSpelling {
    std::optional<double> x, y;
    std::optional<SourceLocation> where;  // of the first parameter that is given, alpha and sigma included
    std::string_view word;                // that parameter
};

FilterSpelling spelled(Parameters& p, std::initializer_list<std::string_view> words) {
    FilterSpelling result;
    for (std::string_view word : words) {
        std::optional<SourceLocation> where = p.placeOf(word);
        if (where && !result.where) result.where = where, result.word = word;
    }
    result.x = p.number(words.begin()[0], kFilterRadius);
    result.y = p.number(words.begin()[1], kFilterRadius);
    return result;
}

}  // namespace

void pixelFilter(Statement s) {
    requireOnce(s);
    constexpr Kind kKinds[] = {Kind::Box, Kind::Gaussian, Kind::Triangle, Kind::Mitchell, Kind::Sinc};
    Words words;
    for (Kind kind : kKinds) words.push_back(nameOf(kind));
    auto [name, p] = readNamed(s, "pixel filter", words);
    const Kind kind = *std::ranges::find_if(kKinds, [&text = name.text](Kind known) { return text == nameOf(known); });
    FilterSpelling v3 = spelled(p, {"xwidth", "ywidth", "alpha"}), v4 = spelled(p, {"xradius", "yradius", "sigma"});
    PixelFilter filter;
    filter.kind = kind;
    if (kind == Kind::Gaussian) {
        if (auto alpha = p.number("alpha", kFilterAlpha)) filter.falloff = *alpha;
        if (auto sigma = p.number("sigma", kFilterSigma)) filter.falloff = 1.0 / (2.0 * *sigma * *sigma);
    }
    if (kind == Kind::Mitchell) {
        filter.b = p.number("B", kFraction).value_or(filter.b);
        filter.c = p.number("C", kFraction).value_or(filter.c);
    }
    if (kind == Kind::Sinc) filter.tau = p.number("tau", kTau).value_or(filter.tau);
    p.finish();
    if (v3.where && v4.where)
        failAt(*v4.where, "{} is pbrt v4's, and {} (at {}) is pbrt v3's: give one spelling", v4.word, v3.word,
               v3.where->text());
    const double radius = radiusOf(kind, v3.where.has_value());
    const FilterSpelling& given = v3.where ? v3 : v4;
    filter.radius = {given.x.value_or(radius), given.y.value_or(radius)};
    s.state.scene.pixel_filter = filter;
}

}  // namespace dsphere
