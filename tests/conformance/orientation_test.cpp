// Where the map's texels land in the picture, worked out by hand.
//
// The map has 45x45 texels of 8 by 4 degrees: texel (22, 22) is centred at longitude 0, latitude 0, texel (25, 22) at
// longitude 24, texel (22, 14) at latitude 32. One texel is white; h falls off to its neighbours' centres, so the
// brightest pixel of Albedo is the one whose centre is nearest to it. The sphere has radius 1, the eye is 4 away, the
// film has 161x161 pixels and tan(fov / 2) = 1/2. A point of the sphere at depth 4 - c and lateral s from the middle
// lands 80.5 * s / (4 - c) / (1/2) = 161 s / (4 - c) pixels from the film's middle, 80.5.
//
//     longitude +-24 on the equator:  s = sin 24 = 0.40674, c = cos 24 = 0.91355:  21.217 pixels: 59.283 or 101.717
//     latitude +-32 on the meridian:  s = sin 32 = 0.52992, c = cos 32 = 0.84805:  27.068 pixels: 53.432 or 107.568
//     longitude +-176 from behind:    s = sin 4  = 0.06976, c = cos 4  = 0.99756:   3.741 pixels: 76.759 or 84.241
//
// pbrt's camera is left-handed, right = up x direction. From +z, looking along -z: right = y x (-z) = -x, and east of
// longitude 0 is +x: east lies to the left. From -z: right = y x z = +x, east of longitude 180 is -x: to the left
// again.

#include "scene/parser.h"
#include "tests/conformance/fixture.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"

#include <algorithm>
#include <cmath>

namespace dsphere::conformance {
namespace {

constexpr int kTexels = 45, kPixels = 161;

struct Pixel {
    int x, y;
    bool operator==(const Pixel&) const = default;
    friend void PrintTo(const Pixel& p, std::ostream* out) { *out << "(" << p.x << ", " << p.y << ")"; }
};

struct View {
    const char* before = "";  ///< LookAt
    const char* eye = "0 0 4";
    const char* parameters = "";  ///< of the shape, beyond its map
};

class Orientation : public Conformance {
  protected:
    Image render(int i, int j, const View& view) {
        RawMap map = test::constantMap(kTexels, kTexels, 0.0f);
        map.samples[std::size_t(j * kTexels + i)] = 65535.0f;
        test::writePgm16(folder_.path() / "map.pgm", map);
        std::string text = std::string(view.before) + "\nLookAt " + view.eye + R"(  0 0 0  0 1 0
            Camera "perspective" "float fov" 53.13010235415598
            Film "rgb" "integer xresolution" 161 "integer yresolution" 161
            WorldBegin
            Texture "h" "spectrum" "heightramp" "string ramp" "grey"
            Material "diffuse" "texture reflectance" "h"
            Shape "displacedsphere" "string displacementmap" "map.pgm" )" +
                           view.parameters;
        Scene scene = parseScene(text, "orientation", folder_.path());
        SceneMaps maps = loadSceneMaps(scene);
        PackedScene packed = packScene(scene, maps);
        return makeRenderer(packed, scene)->renderPlanes(kVerifyPlanes, {});
    }

    static Pixel brightest(const Image& image) {
        const auto& albedo = image.at("Albedo.R").floats();
        int index = int(std::max_element(albedo.begin(), albedo.end()) - albedo.begin());
        EXPECT_GT(albedo[std::size_t(index)], 0.8f);
        return {index % kPixels, index / kPixels};
    }

    Pixel place(int i, int j, const View& view = {}) { return brightest(render(i, j, view)); }

    static float at(const Image& image, const char* channel, Pixel p) {
        return image.at(channel).floats()[std::size_t(p.y * kPixels + p.x)];
    }

    test::TempFolder folder_;
};

constexpr View kBehind{.eye = "0 0 -4"}, kMirrored{.before = "Scale -1 1 1"};
constexpr View kMirroredBehind{.before = "Scale -1 1 1", .eye = "0 0 -4"};

TEST_F(Orientation, MiddleIsLongitudeZero) {
    Image image = render(22, 22, {});
    Pixel middle{80, 80};
    EXPECT_EQ(brightest(image), middle);
    EXPECT_EQ(image.at("id").uints()[80 * kPixels + 80], 1u);
    EXPECT_EQ(image.at("id").uints()[0], 0u);
    EXPECT_FLOAT_EQ(at(image, "Albedo.R", middle), 1.0f);
    EXPECT_FLOAT_EQ(at(image, "t", middle), 3.0f);
    EXPECT_FLOAT_EQ(at(image, "P.Z", middle), 1.0f);
    EXPECT_FLOAT_EQ(at(image, "N.Z", middle), 1.0f);
    EXPECT_NEAR(at(image, "u", middle), 0.5, 1e-6);
    EXPECT_NEAR(at(image, "v", middle), 0.5, 1e-6);
}

TEST_F(Orientation, NorthIsUp) {
    EXPECT_EQ(place(22, 14), (Pixel{80, 53}));
}

TEST_F(Orientation, SouthIsDown) {
    EXPECT_EQ(place(22, 30), (Pixel{80, 107}));
}

TEST_F(Orientation, EastIsLeft) {
    EXPECT_EQ(place(25, 22), (Pixel{59, 80}));
}

TEST_F(Orientation, WestIsRight) {
    EXPECT_EQ(place(19, 22), (Pixel{101, 80}));
}

// The first column is just east of the seam, the last just west.
TEST_F(Orientation, SeamFromBehind) {
    EXPECT_EQ(place(0, 22, kBehind), (Pixel{76, 80}));
    EXPECT_EQ(place(44, 22, kBehind), (Pixel{84, 80}));
}

// Half-way between their centres, at longitude 180 itself, h is half of each, whichever of the two is white.
TEST_F(Orientation, SeamIsInterpolatedAcross) {
    for (int i : {0, 44}) EXPECT_NEAR(at(render(i, 22, kBehind), "Albedo.R", {80, 80}), 0.5, 1e-4) << i;
}

// Node 0 stands at longitude 180, row 22 of 45 at the equator.
TEST_F(Orientation, SeamOfGridlineRegistration) {
    View view{.eye = "0 0 -4", .parameters = "\"string registration\" \"gridline\""};
    EXPECT_EQ(place(0, 22, view), (Pixel{80, 80}));
}

// The image's left edge at longitude 0 puts its middle at 180, and column 2 (longitude 20) in front. From the middle,
// 161 sin 20 / (4 - cos 20) = 17.993 pixels to the east: 62.507.
TEST_F(Orientation, LongitudeOriginZero) {
    const char* origin = "\"float lonorigin\" 0";
    EXPECT_EQ(place(22, 22, {.eye = "0 0 -4", .parameters = origin}), (Pixel{80, 80}));
    EXPECT_EQ(place(2, 22, {.parameters = origin}), (Pixel{62, 80}));
}

TEST_F(Orientation, MirroredEastIsRight) {
    EXPECT_EQ(place(25, 22, kMirrored), (Pixel{101, 80}));
    EXPECT_EQ(place(19, 22, kMirrored), (Pixel{59, 80}));
}

TEST_F(Orientation, MirroredNorthIsStillUp) {
    EXPECT_EQ(place(22, 14, kMirrored), (Pixel{80, 53}));
    EXPECT_EQ(place(22, 30, kMirrored), (Pixel{80, 107}));
}

TEST_F(Orientation, MirroredSeamFromBehind) {
    EXPECT_EQ(place(0, 22, kMirroredBehind), (Pixel{84, 80}));
    EXPECT_EQ(place(44, 22, kMirroredBehind), (Pixel{76, 80}));
}

// The mirror is the camera's alone: P and u of the same texel stay, only its pixel moves.
TEST_F(Orientation, MirrorLeavesTheWorldAlone) {
    Image plain = render(25, 22, {}), mirrored = render(25, 22, kMirrored);
    for (const char* channel : {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "u", "v", "t"})
        EXPECT_NEAR(at(plain, channel, {59, 80}), at(mirrored, channel, {101, 80}), 1e-6) << channel;
    EXPECT_GT(at(plain, "P.X", {59, 80}), 0.35f);
    EXPECT_NEAR(at(plain, "u", {59, 80}), 0.5 + 24.0 / 360.0, 2e-3);
}

}  // namespace
}  // namespace dsphere::conformance
