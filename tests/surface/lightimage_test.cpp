// The image of an infinite light among a scene's maps.

#include <gtest/gtest.h>

#include "surface/scenemaps.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

class LightImage : public testing::Test {
  protected:
    /// A scene of one sphere under an image of this content.
    Scene lit(const std::string& name, const std::string& bytes) {
        InfiniteLight light;
        light.map_path = folder_.write(name, bytes).string();
        light.where = {"sky.pbrt", 3, 7};
        Scene scene;
        scene.shapes.resize(1);
        scene.shapes[0].geometry = Sphere{};
        scene.lights = {PointLight{}, light};
        return scene;
    }
    static std::string errorOf(const Scene& scene) {
        return messageOf(ExitCode::InvalidInput, [&] { loadSceneMaps(scene); });
    }

    const TempFolder folder_;
};

TEST_F(LightImage, IsLoadedOnceBesideTheTextures) {
    Scene scene = lit("sky.pfm", pfmFile(2, 1, {0.25f, 3.0f}, true));
    SceneMaps maps = loadSceneMaps(scene);
    EXPECT_EQ(maps.light_image, 0);
    EXPECT_EQ(maps.images.at(0)->texel(1, 0), dvec3(3.0));
    EXPECT_EQ(maps.image(0), nullptr);
    const std::string path = std::get<InfiniteLight>(scene.lights[1]).map_path;
    scene.shapes[0].material = Plastic{ImageMap{path, dvec3(1.0), -180.0, {}}};
    maps = loadSceneMaps(scene);
    EXPECT_EQ(maps.images.size(), 1u);
    EXPECT_EQ(maps.light_image, 0);
    EXPECT_EQ(maps.image(0), maps.images[0].get());
    scene.lights.pop_back();
    EXPECT_EQ(loadSceneMaps(scene).light_image, -1);
    scene.lights[0] = InfiniteLight{};
    EXPECT_EQ(loadSceneMaps(scene).light_image, -1) << "a constant light has no image";
}

TEST_F(LightImage, SquareOnesAreRefused) {
    const std::string message = errorOf(lit("sky.pfm", pfmFile(2, 2, {1, 1, 1, 1}, true)));
    EXPECT_EQ(message.find("sky.pbrt:3:7: "), 0u) << message;
    EXPECT_TRUE(holds(message, "sky.pfm: the image is square (2x2), as pbrt v4's equal-area maps are"));
    EXPECT_TRUE(holds(message, "supported: equirectangular"));
}

TEST_F(LightImage, ErrorsNameThePlace) {
    EXPECT_TRUE(holds(errorOf(lit("sky.pfm", pfmFile(2, 1, {1, -2}, true))),
                      "sky.pbrt:3:7: " + (folder_.path() / "sky.pfm").string() +
                          ": the light at column 1, row 0 is -2; supported: at least 0"));
    EXPECT_TRUE(holds(errorOf(lit("sky.pfm", "")), "sky.pbrt:3:7: "));
}

}  // namespace
}  // namespace dsphere::test
