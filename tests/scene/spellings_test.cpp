// pbrt v3 and v4 say the same scene in different words.

#include "tests/scene/support.h"

namespace dsphere {
namespace {

TEST(Spellings, OfPbrtGiveTheSameScene) {
    Scene v3 = parse(R"(
        LookAt 0 1 -5  0 0 0  0 1 0
        Camera "perspective" "float fov" [35]
        Film "image" "string filename" ["o.exr"] "integer xresolution" [320] "integer yresolution" [200]
        Sampler "02sequence" "integer pixelsamples" [8]
        Integrator "path" "integer maxdepth" [7]
        PixelFilter "gaussian" "float xwidth" [1.5] "float ywidth" [1.5] "float alpha" [2]
        WorldBegin
        LightSource "distant" "color L" [2 2 2] "point from" [1 1 -1] "point to" [0 0 0] "color scale" [.5 .5 .5]
        LightSource "point" "color I" [3 3 3] "point from" [0 4 0]
        AttributeBegin
            Rotate -90 1 0 0
            LightSource "infinite" "color L" [.5 .5 .5] "string mapname" ["sky.exr"]
        AttributeEnd
        Texture "ramp" "color" "heightramp"
        Texture "photo" "color" "imagemap" "string filename" ["p.jpg"]
        Texture "half" "color" "constant" "color value" [.5 .5 .5]
        Texture "faint" "color" "scale" "texture tex1" ["photo"] "texture tex2" ["half"]
        Texture "checks" "color" "checkerboard" "texture tex1" ["half"] "float uscale" [8] "float vscale" [8]
        MakeNamedMaterial "planet" "string type" ["matte"] "texture Kd" ["ramp"]
        MakeNamedMaterial "gold" "string type" ["metal"] "spectrum eta" ["Au"] "spectrum k" ["Au"]
            "float roughness" [.2] "bool remaproughness" ["false"]
        AttributeBegin
            NamedMaterial "planet"
            Shape "displacedsphere" "string displacementmap" ["m.png"] "float maxdispl" [5]
        AttributeEnd
        AttributeBegin
            AreaLightSource "diffuse" "color L" [4 4 4] "color scale" [2 1 .5] "bool twosided" ["true"]
            Material "matte" "color Kd" [0 0 0]
            Shape "disk" "float radius" [.5]
        AttributeEnd
        NamedMaterial "gold"
        Shape "sphere"
        Material "mirror" "color Kr" [.8 .8 .8]
        Shape "sphere" "float radius" [.2]
        Material "plastic" "texture Kd" ["checks"] "color Ks" [.5 .5 .5] "float roughness" [.05]
        Shape "trianglemesh" "point P" [-9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9] "integer indices" [0 1 2  2 3 0]
            "float uv" [0 0 1 0 1 1 0 1]
        Material "matte" "texture Kd" ["faint"] "float sigma" [20]
        Shape "disk" "float radius" [3]
        WorldEnd)");
    Scene v4 = parse(R"(
        LookAt 0 1 -5  0 0 0  0 1 0
        Camera "perspective" "float fov" 35
        Film "rgb" "string filename" "o.exr" "integer xresolution" 320 "integer yresolution" 200
        Sampler "zsobol" "integer pixelsamples" 8
        Integrator "volpath" "integer maxdepth" 7
        PixelFilter "gaussian" "float sigma" .5
        WorldBegin
        LightSource "distant" "rgb L" [2 2 2] "point3 from" [1 1 -1] "point3 to" [0 0 0] "float scale" .5
        LightSource "point" "rgb I" [3 3 3] "point3 from" [0 4 0]
        AttributeBegin
            Rotate -90 1 0 0
            LightSource "infinite" "float scale" .5 "string filename" "sky.exr"
        AttributeEnd
        Texture "ramp" "spectrum" "heightramp" "string ramp" "terrain"
        Texture "photo" "spectrum" "imagemap" "string filename" "p.jpg"
        Texture "faint" "spectrum" "scale" "texture tex" "photo" "float scale" .5
        Texture "checks" "spectrum" "checkerboard" "rgb tex1" [.5 .5 .5] "float uscale" 8 "float vscale" 8
        MakeNamedMaterial "planet" "string type" "diffuse" "texture reflectance" "ramp"
        MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k"
            "float roughness" .2 "bool remaproughness" false
        AttributeBegin
            NamedMaterial "planet"
            Shape "displacedsphere" "string displacementmap" "m.png" "float maxdispl" 5
        AttributeEnd
        AttributeBegin
            AreaLightSource "diffuse" "rgb L" [8 4 2] "bool twosided" true
            Material "diffuse" "rgb reflectance" [0 0 0]
            Shape "disk" "float radius" .5
        AttributeEnd
        NamedMaterial "gold"
        Shape "sphere"
        Material "mirror" "rgb Kr" [.8 .8 .8]
        Shape "sphere" "float radius" .2
        Material "plastic" "texture Kd" "checks" "rgb Ks" [.5 .5 .5] "float roughness" .05
        Shape "trianglemesh" "point3 P" [-9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9] "integer indices" [0 1 2  2 3 0]
            "point2 uv" [0 0 1 0 1 1 0 1]
        Material "diffuse" "texture reflectance" "faint" "float sigma" 20
        Shape "disk" "float radius" 3)");
    expectSame(v3, v4);
    EXPECT_EQ(v3.lights.size(), 4u);
    EXPECT_EQ(v3.shapes.size(), 6u);
}

}  // namespace
}  // namespace dsphere
