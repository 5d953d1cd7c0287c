#include "surface/colourmap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/srgb.h"

namespace dsphere {

ColourMap::ColourMap(RawColour raw, const std::string& path) : raw_(std::move(raw)), path_(path) {
    const auto bad = std::ranges::find_if_not(raw_.linear, [](float value) { return std::isfinite(value); });
    if (bad != raw_.linear.end()) {
        const auto texel = std::size_t(bad - raw_.linear.begin()) / 3, columns = std::size_t(raw_.width);
        throwInvalid("{}: the colour at column {}, row {} holds {}, expected finite numbers", path, texel % columns,
                     texel / columns, *bad);
    }
    north_ = meanOfRow(0);
    south_ = meanOfRow(raw_.height - 1);
}

double linearFromCode(std::uint8_t code) {
    static const std::array<double, 256> all = [] {
        std::array<double, 256> table;
        for (std::size_t k = 0; k < table.size(); ++k) table[k] = linearFromSrgb(double(k) / 255.0);
        return table;
    }();
    return all[code];
}

dvec3 ColourMap::texel(int i, int j) const {
    const std::size_t at = 3 * (std::size_t(j) * std::size_t(raw_.width) + std::size_t(i));
    if (raw_.srgb.empty()) return {double(raw_.linear[at]), double(raw_.linear[at + 1]), double(raw_.linear[at + 2])};
    return {linearFromCode(raw_.srgb[at]), linearFromCode(raw_.srgb[at + 1]), linearFromCode(raw_.srgb[at + 2])};
}

dvec3 ColourMap::meanOfRow(int j) const {
    dvec3 sum(0.0);
    for (int i = 0; i < raw_.width; ++i) sum += texel(i, j);
    return sum / double(raw_.width);
}

ColourMap loadColourMap(const std::string& path) {
    return ColourMap(readRawColour(path), path);
}

}  // namespace dsphere
