// Layers that are written as a GeoTIFF, and read back as a map.

#include "geo/layerwriter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geo/readmap.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

class Layers : public testing::Test {
  protected:
    static constexpr int kWidth = 300, kHeight = 150;

    static std::vector<float> ramp(float start) {
        std::vector<float> values(std::size_t(kWidth) * kHeight);
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = start + 0.25f * float(k);
        return values;
    }

    TempFolder folder_;
    std::filesystem::path output_ = folder_.path() / "layers.tif";
};

TEST_F(Layers, ComeBackWithPlaceUnitAndRadius) {
    std::vector<float> values = ramp(-10.0f);
    values[7] = std::nanf("");
    geo::LayerWriter writer(output_, {kWidth, kHeight, 0.0, 360.0, -90.0, 90.0, 1737400.0},
                            {{"height", "m", 0.5, 100.0}});
    writer.write(values);
    EXPECT_FALSE(std::filesystem::exists(output_)) << "not before it is whole";
    writer.commit();
    RawMap map = geo::readMap(output_);
    EXPECT_EQ(map.width, kWidth);
    EXPECT_EQ(map.height, kHeight);
    EXPECT_EQ(map.longitude_origin, 0.0);
    EXPECT_EQ(map.facts.unit, "m");
    EXPECT_EQ(map.facts.radius, 1737400.0);
    EXPECT_EQ(map.facts.heightOf(8.0), 104.0);
    EXPECT_TRUE(map.unknown_are_nan && std::isnan(map.samples[7]));
    values[7] = map.samples[7] = 0.0f;
    EXPECT_EQ(map.samples, values);
    EXPECT_EQ(folder_.entries(), 1u);
}

TEST_F(Layers, SeveralLieInOneFile) {
    geo::LayerWriter writer(output_, {kWidth, kHeight, -20.0, 10.0, 5.0, 20.0}, {{"lit.a", ""}, {"slope", "degree"}});
    writer.write(ramp(0.0f));
    writer.write(ramp(1.0f));
    writer.commit();
    expectError(ExitCode::InvalidInput, "covers longitudes -20 to 10, latitudes 5 to 20",
                [&] { geo::readMap(output_, 2); });
    geo::LayerWriter whole(output_, {kWidth, kHeight, -180.0, 180.0, -90.0, 90.0}, {{"a", ""}, {"b", ""}});
    whole.write(ramp(0.0f));
    whole.write(ramp(1.0f));
    whole.commit();
    EXPECT_EQ(geo::readMap(output_, 1).samples, ramp(0.0f));
    EXPECT_EQ(geo::readMap(output_, 2).samples, ramp(1.0f));
}

TEST_F(Layers, AreLeftOutUnlessWhole) {
    {
        geo::LayerWriter writer(output_, {kWidth, kHeight, -180.0, 180.0, -90.0, 90.0}, {{"a", ""}, {"b", ""}});
        writer.write(ramp(0.0f));
    }
    EXPECT_EQ(folder_.entries(), 0u);
    expectError(ExitCode::Failure, "cannot be written", [&] {
        geo::LayerWriter(folder_.path() / "none/layers.tif", {kWidth, kHeight, 0.0, 360.0, -90.0, 90.0}, {{"a", ""}});
    });
}

}  // namespace
}  // namespace dsphere::test
