// Maps that stay in their file, because --mem-limit leaves no room for them: the same pictures, and right ones.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/cli/pictures.h"

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

class TiledMaps : public CliTest {
  protected:
    void render(Words options) {
        options.insert(options.begin(), "render");
        const Outcome outcome = run(options);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }

    void generate(const std::string& kind, const std::string& size, const std::string& name) {
        const Outcome outcome = run({"generate", kind, "--size", size, "-o", name});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }

    /// Both with all planes, once held and once from the file.
    void expectTheSamePicture(Words options) {
        Words held = options;
        held.insert(held.end(), {"-o", "held.exr", "--aov", "all", "--device", "cpu"});
        render(held);
        Words tiled = options;
        tiled.insert(tiled.end(), {"-o", "tiled.exr", "--aov", "all", "--device", "cpu", "--mem-limit", "1M"});
        render(tiled);
        expectSameChannels(readExr(path("held.exr")), readExr(path("tiled.exr")));
    }
};

// 40 tiles, of which 32 have room: rays drive out each other's.
TEST_F(TiledMaps, APictureDoesNotDependOnTheRoom) {
    generate("terraces", "2048,1024", "map.tif");
    expectTheSamePicture({"map.tif", "--resolution", "160,90", "--spp", "2"});
    for (const char* place : {"0,0,0.002", "89.9,10,0.2", "-89.99,100,0.01"})
        expectTheSamePicture({"map.tif", "--resolution", "96,54", "--spp", "1", "--pitch", "-10",
                              std::string("--lookat-latlon=") + place});
}

TEST_F(TiledMaps, PathsAndSeveralShapesToo) {
    generate("fractal", "1024,512", "map.tif");
    folder_.write("scene.pbrt", R"(
        Film "rgb" "integer xresolution" 96 "integer yresolution" 64 "string filename" "out.png"
        Sampler "independent" "integer pixelsamples" 2
        Integrator "path" "integer maxdepth" 3
        LookAt 0 1 4  0 0 0  0 1 0
        Camera "perspective" "float fov" 40
        WorldBegin
        LightSource "infinite" "rgb L" [0.3 0.3 0.4]
        LightSource "distant" "point3 from" [1 1 1] "point3 to" [0 0 0]
        Material "conductor" "float roughness" 0.3
        Shape "displacedsphere" "float radius" 1 "float maxdispl" 10 "string displacementmap" "map.tif"
        AttributeBegin
        Translate 1.6 0 0.5
        Material "matte" "rgb Kd" [0.7 0.3 0.2]
        Shape "displacedsphere" "float radius" 0.5 "float maxdispl" 20 "string displacementmap" "map.tif"
          "string registration" "gridline"
        AttributeEnd
        Shape "sphere" "float radius" 0.2
    )");
    expectTheSamePicture({"scene.pbrt"});
}

TEST_F(TiledMaps, VerifyHolds) {
    generate("spikes", "1024,512", "map.tif");
    const Outcome outcome =
        run({"verify", "map.tif", "--resolution", "120,68", "--mem-limit", "1M", "--device", "cpu"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(TiledMaps, BlurredOnesToo) {
    generate("spikes", "1024,512", "map.tif");
    expectTheSamePicture({"map.tif", "--blur", "1.5", "--resolution", "96,54", "--spp", "1"});
}

// A planet under each kind of smooth surface and each registration.
TEST_F(TiledMaps, SplinesAndSmoothNormalsAreRightToo) {
    generate("terraces", "1024,512", "map.tif");
    folder_.write("scene.pbrt", R"(
        Film "rgb" "integer xresolution" 120 "integer yresolution" 80 "string filename" "out.png"
        Sampler "independent" "integer pixelsamples" 1
        LookAt 0 1 4  0 0 0  0 1 0
        Camera "perspective" "float fov" 40
        WorldBegin
        LightSource "distant" "point3 from" [1 1 1] "point3 to" [0 0 0]
        Shape "displacedsphere" "float radius" 1 "float maxdispl" 10 "string displacementmap" "map.tif"
          "string filter" "bspline"
        Translate 1.5 0 0.5
        Rotate 70 1 0 0
        Shape "displacedsphere" "float radius" 0.5 "float maxdispl" 20 "string displacementmap" "map.tif"
          "string registration" "gridline" "string filter" "bspline"
        Translate -3 0 0
        Shape "displacedsphere" "float radius" 0.5 "float maxdispl" 20 "string displacementmap" "map.tif"
          "bool smoothnormals" true
    )");
    const Outcome outcome = run({"verify", "scene.pbrt", "--mem-limit", "1M", "--device", "cpu"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(TiledMaps, BaselinesAreRefused) {
    generate("fractal", "1024,512", "map.tif");
    const Outcome outcome = run({"render", "map.tif", "--marcher", "naive", "--mem-limit", "1M", "-o", "out.png"});
    EXPECT_EQ(outcome.code, 3) << outcome.out;
    EXPECT_TRUE(holds(outcome.err, "stays in its file is marched exactly alone"));
}

TEST_F(TiledMaps, ALimitThatIsNoSizeIsRefused) {
    EXPECT_EQ(run({"render", "planet.pbrt", "--mem-limit", "lots", "-o", "out.png"}).code, 2);
}

}  // namespace
}  // namespace dsphere::test
