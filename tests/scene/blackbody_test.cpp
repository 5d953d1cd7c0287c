// The light of black bodies against published colours.

#include "scene/blackbody.h"

#include "base/math.h"
#include "tests/scene/support.h"

namespace dsphere {
namespace {

// The inverse of IEC 61966-2-1, by itself.
dvec3 xyzOf(const dvec3& rgb) {
    return {0.4124 * rgb.x + 0.3576 * rgb.y + 0.1805 * rgb.z, 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z,
            0.0193 * rgb.x + 0.1192 * rgb.y + 0.9505 * rgb.z};
}

TEST(Blackbody, LiesOnThePlanckianLocus) {
    struct Known {
        double kelvin, x, y;
    };
    // CIE 015: illuminant A is a Planckian radiator of 2855.5 K; Wyszecki and Stiles, table 1(3.3.4), for the others.
    for (const Known& known : {Known{2855.5, 0.4476, 0.4074},
                               {4000.0, 0.3805, 0.3768},
                               {5000.0, 0.3451, 0.3516},
                               {6500.0, 0.3135, 0.3237},
                               {10000.0, 0.2807, 0.2884}}) {
        const dvec3 xyz = xyzOf(blackbodyOfLuminance1(known.kelvin));
        const double sum = xyz.x + xyz.y + xyz.z;
        EXPECT_NEAR(xyz.y, 1.0, 1e-3) << known.kelvin;
        EXPECT_NEAR(xyz.x / sum, known.x, 3e-4) << known.kelvin;
        EXPECT_NEAR(xyz.y / sum, known.y, 3e-4) << known.kelvin;
    }
}

// Of a spectrum whose peak, 1, lies within sight nearly all counts; of one that peaks in the infrared little does.
TEST(Blackbody, ThePeakOfV3IsOne) {
    EXPECT_NEAR(xyzOf(blackbodyOfPeak1(5200.0)).y, 0.986, 0.005);
    EXPECT_NEAR(xyzOf(blackbodyOfPeak1(2855.5)).y, 0.348, 0.005);
    expectNear(blackbodyOfPeak1(4000.0) / xyzOf(blackbodyOfPeak1(4000.0)).y, blackbodyOfLuminance1(4000.0), 1e-3);
}

TEST(Blackbody, RedsBeyondSrgbAreCut) {
    const dvec3 ember = blackbodyOfLuminance1(1000.0);
    EXPECT_GT(ember.r, 1.0);
    EXPECT_EQ(ember.b, 0.0);
}

TEST(Blackbody, InBothSpellings) {
    const Scene scene = parseParts("",
                                   "LightSource \"distant\" \"blackbody L\" 5800 \"float scale\" 2\n"
                                   "LightSource \"point\" \"blackbody I\" [5800 3]\n"
                                   "LightSource \"infinite\" \"blackbody L\" [3000 1 6000 .5]\n"
                                   "AreaLightSource \"diffuse\" \"blackbody L\" [2700]");
    expectNear(std::get<DistantLight>(scene.lights[0]).radiance, 2.0 * blackbodyOfLuminance1(5800.0));
    expectNear(std::get<PointLight>(scene.lights[1]).intensity, 3.0 * blackbodyOfPeak1(5800.0));
    expectNear(std::get<InfiniteLight>(scene.lights[2]).radiance,
               blackbodyOfPeak1(3000.0) + 0.5 * blackbodyOfPeak1(6000.0));
    expectNear(std::get<AreaLight>(scene.lights[3]).radiance, blackbodyOfLuminance1(2700.0));
}

TEST(Blackbody, Mistakes) {
    EXPECT_EQ(errorOf("WorldBegin LightSource \"point\" \"blackbody I\" 100 Shape \"disk\""),
              "test.pbrt:1:46: parameter \"I\" is 100; supported: in [500, 100000]");
    EXPECT_NE(errorOf("WorldBegin LightSource \"point\" \"blackbody I\" [5000 1 100 1] Shape \"disk\"")
                  .find("test.pbrt:1:54: parameter \"I\" is 100 kelvin times 1"),
              std::string::npos);
    EXPECT_NE(errorOf("WorldBegin LightSource \"point\" \"float power\" 3 Shape \"disk\"")
                  .find("lights are not scaled by their power; give I, the light itself"),
              std::string::npos);
}

}  // namespace
}  // namespace dsphere
