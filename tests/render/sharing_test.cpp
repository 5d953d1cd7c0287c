// Several shapes of one map: what is loaded, packed and uploaded once, and what is not.

#include "tests/render/world.h"

namespace dsphere::test {
namespace {

class SharingTest : public WorldTest {
  protected:
    /// Index of each object's relief.
    static std::vector<int> reliefsOf(const World& world) {
        std::vector<int> reliefs;
        for (const PackedObject& object : world.packed.state.objects) reliefs.push_back(object.relief);
        return reliefs;
    }
};

TEST_F(SharingTest, OneReliefForEqualShapes) {
    World same = world(planet() + "Translate 1 0 0\n" + planet());
    EXPECT_EQ(same.maps.maps.size(), 1u);
    EXPECT_EQ(same.packed.nodes.size(), 1u);
    EXPECT_EQ(same.packed.reliefs.size(), 1u);
    EXPECT_EQ(reliefsOf(same), (std::vector<int>{0, 0}));
}

TEST_F(SharingTest, RadiusAloneIsTheSameRelief) {
    World scaled = world(planet() + planet("\"float maxdispl\" 10 \"float radius\" 2"));
    EXPECT_EQ(scaled.packed.reliefs.size(), 1u) << "in units of R they are one";
}

TEST_F(SharingTest, AnotherDisplacementSharesTheNodes) {
    World two = world(planet() + planet("\"float maxdispl\" -20"));
    EXPECT_EQ(two.packed.nodes.size(), 1u);
    EXPECT_EQ(two.packed.reliefs.size(), 2u);
    EXPECT_EQ(two.packed.reliefs[1].map, 0);
    EXPECT_EQ(reliefsOf(two), (std::vector<int>{0, 1}));
}

// Pipelines are made from the one before the other is known.
TEST_F(SharingTest, TraitsOfASceneAreThoseOfItsPacking) {
    for (const std::string& shapes :
         {planet(), planet() + "Translate 3 0 0\nShape \"sphere\"\nShape \"disk\"\n",
          planet("\"string filter\" \"bspline\"") + planet("\"bool smoothnormals\" true"),
          planet("\"string filter\" \"bspline\" \"bool smoothnormals\" true"),
          std::string(
              "Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\" \"float maxdispl\" 5\n")}) {
        World made = world(shapes);
        EXPECT_EQ(traitsOf(made.scene), made.packed.traits) << shapes;
    }
}

TEST_F(SharingTest, AnotherMapOrReadingOfItSharesNothing) {
    World maps = world(planet() + planet("\"float maxdispl\" 10", "other.pgm"));
    EXPECT_EQ(maps.packed.nodes.size(), 2u);
    EXPECT_EQ(maps.packed.reliefs.size(), 2u);
    World readings = world(planet() + planet("\"float maxdispl\" 10 \"string registration\" \"gridline\"") +
                           planet("\"float maxdispl\" 10 \"float lonorigin\" 0"));
    EXPECT_EQ(readings.maps.maps.size(), 3u);
    EXPECT_EQ(readings.packed.reliefs.size(), 3u);
}

TEST_F(SharingTest, ShapesWithoutAMapHaveNoRelief) {
    World mixed = world("Shape \"sphere\"\n" + planet() + "Shape \"disk\"\n");
    EXPECT_EQ(reliefsOf(mixed), (std::vector<int>{-1, 0, -1}));
    EXPECT_EQ(mixed.packed.traits.kinds, 7u);
}

TEST_F(SharingTest, TooManyShapes) {
    std::string shapes;
    for (int i = 0; i <= MAX_OBJECTS; ++i) shapes += "Shape \"sphere\"\n";
    EXPECT_THROW(world(shapes), Error);
}

// Each shape is seen through its own map, whatever it shares with the others.
TEST_F(SharingTest, PicturesOfTogetherAndAlone) {
    const std::string left = "AttributeBegin\nTranslate -1.3 0 0\n" + planet() + "AttributeEnd\n";
    const std::string middle =
        "AttributeBegin\nRotate 40 0 1 0\n" + planet("\"float maxdispl\" -20") + "AttributeEnd\n";
    const std::string right =
        "AttributeBegin\nTranslate 1.3 0 0\n" + planet("\"float maxdispl\" 30", "other.pgm") + "AttributeEnd\n";
    gpu::Device device({"", true});
    auto render = [&](const std::string& shapes) {
        World made = world(shapes);
        return Renderer(device, made.packed, made.scene, Marcher::Exact).renderPlanes(kAovPlanes, {});
    };
    Image all = render(left + middle + right);
    int seen[4] = {};
    int shape = 0;
    for (const std::string& alone : {left, middle, right}) {
        Image one = render(alone);
        ++shape;
        for (std::size_t i = 0; i < all.pixelCount(); ++i) {
            if (all.at("id").uints()[i] != unsigned(shape)) continue;
            ++seen[shape];
            for (const char* name : {"t", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "u", "v"})
                ASSERT_NEAR(all.at(name).floats()[i], one.at(name).floats()[i], pipelineDrift(device))
                    << name << " of shape " << shape;
        }
        EXPECT_GT(seen[shape], 50) << "shape " << shape;
    }
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace dsphere::test
