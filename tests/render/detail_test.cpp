// Levels of detail on the device: a ray marches one level, exactly as if that were the map, and never sees the map
// itself off by more pixels than it was allowed.

#include "reference/surface.h"
#include "surface/levels.h"
#include "tests/render/world.h"

#include <cmath>

namespace dsphere::test {
namespace {

class DetailTest : public WorldTest {
  protected:
    DetailTest() {
        writePgm16(folder_.path() / "large.pgm", fractalMap(2048, 1024));
        writePgm16(folder_.path() / "nodes.pgm", fractalMap(2048, 1025));
    }

    Image rendered(const World& world, const PackedScene& packed, float pixels) {
        return Renderer(device_, packed, world.scene, {Marcher::Exact, 3e-6f, pixels}).renderPlanes(kVerifyPlanes, {});
    }
    Image rendered(const World& world, float pixels) {
        return rendered(world, packScene(world.scene, world.maps, Levels::All), pixels);
    }
    World large(const std::string& parameters = "\"float maxdispl\" 10") const {
        return world(planet(parameters, "large.pgm"));
    }
    static void expectSame(const Image& a, const Image& b) {
        ASSERT_EQ(a.channels.size(), b.channels.size());
        for (std::size_t c = 0; c < a.channels.size(); ++c)
            EXPECT_EQ(a.channels[c].pixels, b.channels[c].pixels) << a.channels[c].name;
    }

    gpu::Device device_{{"", true}};
};

TEST_F(DetailTest, ALevelIsMarchedAsIfItWereTheMap) {
    World whole = large();
    World halves = large();
    for (int level = 1; level <= 2; ++level)
        halves.maps.maps[0] = std::make_unique<Heightmap>(*halved(*halves.maps.maps[0]));
    // From four radii a picture 72 pixels wide has pixels of dozens of texels: every ray takes the coarsest level.
    Image detail = rendered(whole, 1.0f);
    expectSame(detail, rendered(halves, packScene(halves.scene, halves.maps), 0.0f));
    Image exact = rendered(whole, 0.0f);
    EXPECT_NE(detail.at("t").pixels, exact.at("t").pixels);
}

// A retry starts late on its ray, but on the level that pixels have where the ray enters the shell.
TEST_F(DetailTest, RetriedRaysKeepTheirLevel) {
    const World whole = large("\"float maxdispl\" 300");
    World halves = large("\"float maxdispl\" 300");
    for (int level = 1; level <= 2; ++level)
        halves.maps.maps[0] = std::make_unique<Heightmap>(*halved(*halves.maps.maps[0]));
    const PackedScene packed = packScene(whole.scene, whole.maps, Levels::All);
    Renderer renderer(device_, packed, whole.scene, {Marcher::Exact, 3e-6f, 1000.0f});
    const Image detail = renderer.renderPlanes(kVerifyPlanes, {});
    EXPECT_GT(renderer.stats().retried_pixels, 0u);
    expectSame(detail, rendered(halves, packScene(halves.scene, halves.maps), 0.0f));
}

TEST_F(DetailTest, NoHitIsFartherOffThanItsPixels) {
    for (const World& made :
         {large("\"float maxdispl\" 300"),
          world(planet("\"float maxdispl\" -30 \"string registration\" \"gridline\"", "nodes.pgm"))}) {
        PackedScene packed = packScene(made.scene, made.maps, Levels::All);
        ASSERT_EQ(packed.reliefs.size(), 3u);
        reference::Surface surface(*made.maps.maps[0], made.maps.reliefs[0]);
        Raster raster = makeRaster(made.scene.camera, made.scene.film);
        double pixel_at_1 =
            glm::length(raster.direction.right) / glm::length(raster.direction.at(0.5 * kWidth, 0.5 * kHeight));
        for (float pixels : {0.05f, 1.0f}) {
            Image image = rendered(made, packed, pixels);
            double greatest = 0.0;
            for (std::size_t i = 0; i < image.pixelCount(); ++i) {
                if (image.at("id").uints()[i] == 0) continue;
                dvec3 p(image.at("P.X").floats()[i], image.at("P.Y").floats()[i], image.at("P.Z").floats()[i]);
                greatest = std::max(greatest, std::abs(surface.f(p)) / (pixel_at_1 * image.at("t").floats()[i]));
            }
            EXPECT_LE(greatest, pixels);
        }
    }
}

TEST_F(DetailTest, TexelsLargerThanPixelsAreTheMapsOwn) {
    World near = large();
    near.scene.camera.camera_from_world = dmat4(1.0);
    near.scene.camera.camera_from_world[3] = dvec4(0.0, 0.0, 1.15, 1.0);
    expectSame(rendered(near, 1.0f), rendered(near, 0.0f));
}

TEST_F(DetailTest, AMapWithoutLevelsIsTheMap) {
    World small = world(planet());
    PackedScene packed = packScene(small.scene, small.maps, Levels::All);
    EXPECT_EQ(packed.reliefs.size(), 1u);
    expectSame(rendered(small, packed, 2.0f), rendered(small, packed, 0.0f));
    World unpacked = large();
    expectSame(rendered(unpacked, unpacked.packed, 2.0f), rendered(unpacked, unpacked.packed, 0.0f));
}

TEST_F(DetailTest, ObjectsTakeLevelsOfTheirOwn) {
    World near = world(planet("\"float maxdispl\" 10", "large.pgm"));
    World both = world(planet("\"float maxdispl\" 10", "large.pgm") + "Translate 20 0 -40\nScale 5 5 5\n" +
                       planet("\"float maxdispl\" 20", "large.pgm"));
    PackedScene packed = packScene(both.scene, both.maps, Levels::All);
    EXPECT_EQ(packed.halves.size(), 2u) << "halves are shared";
    EXPECT_EQ(packed.reliefs.size(), 6u);
    Image image = rendered(both, packed, 1.0f);
    Image alone = rendered(near, 1.0f);
    const auto &id = image.at("id").uints(), &id_alone = alone.at("id").uints();
    int second = 0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        second += id[i] == 2;
        if (id_alone[i] == 0) continue;
        EXPECT_NEAR(image.at("object.X").floats()[i], alone.at("object.X").floats()[i], pipelineDrift(device_));
    }
    EXPECT_GT(second, 50);
    for (const std::string& message : device_.validationMessages()) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace dsphere::test
