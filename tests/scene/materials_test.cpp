// Materials beyond matte, and textures made of others.

#include "scene/metals.h"
#include "tests/scene/support.h"

namespace dsphere {
namespace {

Material materialOf(const std::string& world) {
    return parseParts("", world).shapes.back().material;
}

TEST(Materials, RoughMatte) {
    Matte matte{ConstantColour{dvec3(0.1, 0.2, 0.3)}, 20.0};
    EXPECT_EQ(materialOf("Material \"matte\" \"rgb Kd\" [.1 .2 .3] \"float sigma\" 20"), Material{matte});
}

TEST(Materials, Mirrors) {
    EXPECT_EQ(materialOf("Material \"mirror\""), Material{Mirror{dvec3(0.9)}});
    EXPECT_EQ(materialOf("Material \"mirror\" \"rgb Kr\" [1 .5 0]"), (Material{Mirror{dvec3(1.0, 0.5, 0.0)}}));
    EXPECT_EQ(materialOf("Texture \"t\" \"color\" \"constant\" \"rgb value\" [.4 .4 .4] "
                         "Texture \"s\" \"color\" \"scale\" \"texture tex1\" \"t\" \"float tex2\" .5 "
                         "Material \"mirror\" \"texture Kr\" \"s\""),
              Material{Mirror{dvec3(0.2)}});
}

// pbrt v3's metal and v4's conductor read roughness by rules of their own.
TEST(Materials, Roughness) {
    auto alpha = [](const std::string& words) { return std::get<Conductor>(materialOf("Material " + words)).alpha; };
    EXPECT_DOUBLE_EQ(alpha("\"conductor\""), 0.1);
    EXPECT_DOUBLE_EQ(alpha("\"conductor\" \"float roughness\" .25"), 0.5);
    EXPECT_NEAR(alpha("\"metal\""), 0.1389, 1e-4) << "worked out by hand";
    EXPECT_DOUBLE_EQ(alpha("\"metal\" \"float roughness\" 1"), 1.0) << "1.62142, cut";
    EXPECT_DOUBLE_EQ(alpha("\"metal\" \"float roughness\" 0"), alpha("\"metal\" \"float roughness\" .001"));
    EXPECT_DOUBLE_EQ(alpha("\"conductor\" \"float roughness\" 0"), 0.001);
    for (const char* kind : {"\"metal\"", "\"conductor\""})
        EXPECT_DOUBLE_EQ(
            alpha(std::string(kind) + " \"float uroughness\" .3 \"float vroughness\" .3 \"bool remaproughness\" false"),
            0.3);
    EXPECT_NEAR(std::get<Plastic>(materialOf("Material \"plastic\"")).alpha, 0.4618, 1e-4);
}

TEST(Materials, Plastic) {
    auto plastic = std::get<Plastic>(materialOf("Material \"plastic\""));
    EXPECT_EQ(plastic.diffuse, Texture{ConstantColour{dvec3(0.25)}});
    EXPECT_EQ(plastic.specular, dvec3(0.25));
    plastic = std::get<Plastic>(
        materialOf("Texture \"c\" \"color\" \"checkerboard\" Material \"plastic\" \"texture Kd\" \"c\" "
                   "\"rgb Ks\" [0 .5 1] \"float roughness\" .2 \"bool remaproughness\" false"));
    EXPECT_EQ(plastic, (Plastic{Checkerboard{}, dvec3(0.0, 0.5, 1.0), 0.2}));
}

TEST(Materials, MetalsByName) {
    ASSERT_EQ(metals().size(), 4u);
    EXPECT_EQ(materialOf("Material \"metal\" \"bool remaproughness\" false \"float roughness\" .1"),
              Material{Conductor{}})
        << "copper is the default, here and in the model";
    for (const Metal& metal : metals()) {
        std::string name(metal.name);
        using Words = std::pair<std::string, std::string>;
        for (const auto& [eta, k] : {Words{name, name}, Words{"metal-" + name + "-eta", "metal-" + name + "-k"}}) {
            auto conductor = std::get<Conductor>(
                materialOf("Material \"conductor\" \"spectrum eta\" \"" + eta + "\" \"spectrum k\" \"" + k + "\""));
            EXPECT_EQ(conductor.eta, metal.eta) << name;
            EXPECT_EQ(conductor.k, metal.k) << name;
        }
    }
    auto own = std::get<Conductor>(materialOf("Material \"metal\" \"rgb eta\" [1 2 3] \"color k\" [4 5 6]"));
    EXPECT_EQ(own.eta, dvec3(1, 2, 3));
    EXPECT_EQ(own.k, dvec3(4, 5, 6));
}

// At normal incidence (n - 1)^2 + k^2 over (n + 1)^2 + k^2.
TEST(Materials, MetalsHaveTheirTints) {
    for (const Metal& metal : metals()) {
        dvec3 kk = metal.k * metal.k, less = metal.eta - 1.0, more = metal.eta + 1.0;
        dvec3 seen = (less * less + kk) / (more * more + kk);
        bool red = metal.name == "Cu" || metal.name == "Au";
        EXPECT_GT(seen.r, 0.9) << metal.name;
        if (red) {
            EXPECT_GT(seen.r, seen.g + 0.1) << metal.name;
            EXPECT_GT(seen.g, seen.b + 0.05) << metal.name;
        } else {
            EXPECT_GT(seen.b, 0.85) << metal.name;
        }
    }
}

TEST(Materials, NamedOnesOfEveryKind) {
    Scene scene = parse(R"(WorldBegin
        MakeNamedMaterial "a" "string type" "mirror" "rgb Kr" [.5 .5 .5]
        MakeNamedMaterial "b" "string type" "conductor" "spectrum eta" "Al" "spectrum k" "Al"
        MakeNamedMaterial "c" "string type" "plastic"
        NamedMaterial "a" Shape "sphere" NamedMaterial "b" Shape "sphere" NamedMaterial "c" Shape "disk")");
    EXPECT_EQ(scene.shapes[0].material, Material{Mirror{dvec3(0.5)}});
    EXPECT_EQ(std::get<Conductor>(scene.shapes[1].material).eta, metals()[3].eta);
    EXPECT_TRUE(std::holds_alternative<Plastic>(scene.shapes[2].material));
}

Texture textureOf(const std::string& textures) {
    return *dsphere::textureOf(
        parse("WorldBegin " + textures + " Material \"matte\" \"texture Kd\" \"t\" Shape \"displacedsphere\"")
            .shapes.at(0)
            .material);
}

TEST(CombinedTextures, Checkerboards) {
    EXPECT_EQ(textureOf("Texture \"t\" \"color\" \"checkerboard\""), Texture{Checkerboard{}});
    EXPECT_EQ(textureOf("Texture \"c\" \"color\" \"constant\" \"rgb value\" [.1 .2 .3] Texture \"t\" \"spectrum\" "
                        "\"checkerboard\" \"texture tex1\" \"c\" \"float tex2\" .5 \"float uscale\" 36 "
                        "\"float vscale\" -18"),
              (Texture{Checkerboard{dvec3(.1, .2, .3), dvec3(0.5), 36.0, -18.0}}));
}

TEST(CombinedTextures, ScaleFoldsIntoWhatItScales) {
    const std::string half = "Texture \"h\" \"color\" \"constant\" \"rgb value\" [.5 1 0] ";
    const std::string scale = "Texture \"t\" \"color\" \"scale\" \"texture tex1\" \"h\" \"texture tex2\" \"x\"";
    EXPECT_EQ(textureOf(half + "Texture \"x\" \"color\" \"heightramp\" \"string ramp\" \"grey\" " + scale),
              (Texture{HeightRamp{"grey", dvec3(.5, 1, 0)}}));
    EXPECT_EQ(
        textureOf(half + "Texture \"x\" \"color\" \"imagemap\" \"string filename\" \"a\" \"float scale\" 4 " + scale),
        (Texture{ImageMap{"folder/a", dvec3(2, 4, 0), -180.0, {}}}));
    EXPECT_EQ(textureOf(half + "Texture \"x\" \"color\" \"checkerboard\" \"float tex2\" .5 " + scale),
              (Texture{Checkerboard{dvec3(.5, 1, 0), dvec3(.25, .5, 0)}}));
    EXPECT_EQ(textureOf(half + "Texture \"x\" \"color\" \"constant\" " + scale),
              Texture{ConstantColour{dvec3(.5, 1, 0)}});
    EXPECT_EQ(textureOf("Texture \"t\" \"color\" \"scale\""), Texture{ConstantColour{dvec3(1.0)}});
}

// Only the end of a chain is cut to [0, 1].
TEST(CombinedTextures, ChainsOfScales) {
    const std::string chain =
        "Texture \"c\" \"color\" \"constant\" \"rgb value\" [.25 .5 1] "
        "Texture \"more\" \"color\" \"scale\" \"texture tex\" \"c\" \"float scale\" 4 ";
    EXPECT_EQ(textureOf(chain + "Texture \"t\" \"color\" \"scale\" \"texture tex\" \"more\" \"float scale\" .25"),
              Texture{ConstantColour{dvec3(.25, .5, 1)}});
    EXPECT_EQ(textureOf(chain + "Texture \"t\" \"color\" \"scale\" \"texture tex\" \"more\" \"float scale\" .5"),
              Texture{ConstantColour{dvec3(.5, 1, 1)}});
}

}  // namespace
}  // namespace dsphere
