// A map that stays in its file, by real input.

#include "tests/image/tiffwriter.h"
#include "tests/viewer/windowfixture.h"

#include <algorithm>
#include <map>

namespace dsphere::test {
namespace {

/// A map that stays in its file shows a coarse planet while it is surveyed; a screenshot waits for the exact one.
TEST_F(WindowTest, ALargeMapIsCoarseAtFirst) {
    constexpr int kWidth = 11776, kHeight = 5888, kTile = 512;
    std::map<std::uint32_t, std::vector<std::int16_t>> hills;
    for (std::uint32_t tile : {110u, 112u, 134u})
        for (int k = 0; k < kTile * kTile; ++k) hills[tile].push_back(std::int16_t((k * 37) % 3000));
    folder_.write("large.tif", sparseTiffFile<std::int16_t>(kWidth, kHeight, kTile, hills));
    folder_.write("large.pbrt",
                  "Scale -1 1 1 LookAt 0 0 3  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 50\n"
                  "Film \"rgb\" \"integer xresolution\" 320 \"integer yresolution\" 240\n"
                  "Sampler \"independent\" \"integer pixelsamples\" 1\nWorldBegin\n"
                  "LightSource \"distant\" \"point3 from\" [1 1 1]\n"
                  "Shape \"displacedsphere\" \"string displacementmap\" \"large.tif\" \"float maxdispl\" 3\n");
    Viewing viewing(*desktop_, folder_.path(), {"large.pbrt", "--spp", "1"});
    const json coarse = viewing.waitFor("a coarse planet", is("coarse", true));
    hand("key F12");
    const json exact = viewing.waitFor("a screenshot", says("Wrote large-1.png, 1 sample"));
    EXPECT_FALSE(exact.at("coarse"));
    EXPECT_EQ(exact.at("camera"), coarse.at("camera"));
    EXPECT_TRUE(std::ranges::any_of(viewing.lines(), [](const json& frame) {
        return frame.at("coarse") && frame.at("has_picture") && frame.at("busy_share") >= 0.0;
    })) << "a coarse picture while the survey goes on";
    hand("key Escape");
    EXPECT_EQ(viewing.finish(), 0) << viewing.errors();
    EXPECT_EQ(viewing.errors(), "");
}

}  // namespace
}  // namespace dsphere::test
