// The Earth's heights and colours, if scripts/fetch-earth has brought them: coasts lie where heights begin.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "image/rawmap.h"
#include "surface/colourmap.h"

namespace dsphere::test {
namespace {

/// Whether each texel is land, by colour: the sea of the Blue Marble is bluer than red. Two texels are one of the
/// heights', in both directions.
std::vector<float> landByColour(const ColourMap& image) {
    std::vector<float> land;
    for (int j = 0; j + 1 < image.height(); j += 2)
        for (int i = 0; i + 1 < image.width(); i += 2) {
            const dvec3 sum =
                image.texel(i, j) + image.texel(i + 1, j) + image.texel(i, j + 1) + image.texel(i + 1, j + 1);
            land.push_back(sum.r >= sum.b ? 1.0f : 0.0f);
        }
    return land;
}

/// Correlation of `b`, moved by (dx, dy) texels, with `a`, between 60 degrees south and north: beyond lies white ice.
double correlation(const std::vector<float>& a, const std::vector<float>& b, int width, int height, int dx, int dy) {
    double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    for (int j = height / 6; j < height - height / 6; ++j)
        for (int i = 0; i < width; ++i) {
            const double x = double(a[std::size_t(j * width + i)]);
            const double y = double(b[std::size_t((j + dy) * width + (i + dx + width) % width)]);
            n += 1, sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
        }
    return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

TEST(Earth, CoastsMatchHeightsToTheTexel) {
    const std::filesystem::path folder = std::filesystem::path(DSPHERE_SOURCE_DIR) / "assets/earth";
    if (!std::filesystem::exists(folder / "earth-blue-marble.jpg")) GTEST_SKIP() << "scripts/fetch-earth was not run";
    const RawMap heights = readRawMap(folder / "earth-topology.png");
    const ColourMap image = loadColourMap((folder / "earth-blue-marble.jpg").string());
    ASSERT_EQ(image.width(), 2 * heights.width);
    ASSERT_EQ(image.height(), 2 * heights.height);
    std::vector<float> above_sea;
    for (const float height : heights.samples) above_sea.push_back(height > 0.0f ? 1.0f : 0.0f);
    const std::vector<float> land = landByColour(image);
    const auto at = [&](int dx, int dy) { return correlation(above_sea, land, heights.width, heights.height, dx, dy); };
    const double best = at(0, 0);
    std::printf("correlation %.4f; one texel west %.4f, east %.4f, north %.4f, south %.4f\n", best, at(-1, 0), at(1, 0),
                at(0, -1), at(0, 1));
    EXPECT_GT(best, 0.9);
    for (int dy = -3; dy <= 3; ++dy)
        for (int dx = -3; dx <= 3; ++dx) {
            if (dx == 0 && dy == 0) continue;
            EXPECT_LT(at(dx, dy), best) << dx << ", " << dy;
        }
    // The parabola through three neighbours peaks within half a texel of zero.
    const auto peak = [](double before, double middle, double after) {
        return 0.5 * (before - after) / (before - 2.0 * middle + after);
    };
    EXPECT_LT(std::abs(peak(at(-1, 0), best, at(1, 0))), 0.5);
    EXPECT_LT(std::abs(peak(at(0, -1), best, at(0, 1))), 0.5);
}

}  // namespace
}  // namespace dsphere::test
