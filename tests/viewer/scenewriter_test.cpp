#include "viewer/scenewriter.h"

#include "scene/parser.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

void expectRoundTrip(const std::string& text) {
    Scene scene = parseScene(text, "a.pbrt", "/maps");
    std::string written = sceneText(scene, "/maps");
    Scene again = parseScene(written, "b.pbrt", "/maps");
    EXPECT_EQ(scene.camera, again.camera) << written;
    EXPECT_EQ(scene.sampler, again.sampler);
    EXPECT_EQ(scene.film.width, again.film.width);
    EXPECT_EQ(scene.film.height, again.film.height);
    EXPECT_EQ(scene.film.crop, again.film.crop);
    EXPECT_EQ(scene.integrator, again.integrator);
    EXPECT_EQ(scene.pixel_filter, again.pixel_filter);
    EXPECT_EQ(scene.lights, again.lights) << written;
    ASSERT_EQ(scene.shapes.size(), again.shapes.size());
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        EXPECT_EQ(scene.shapes[i].geometry, again.shapes[i].geometry) << written;
        EXPECT_EQ(scene.shapes[i].world_from_object, again.shapes[i].world_from_object) << written;
        EXPECT_EQ(scene.shapes[i].material, again.shapes[i].material) << written;
    }
}

TEST(SceneWriter, BringsEverythingBackBitForBit) {
    expectRoundTrip(
        "Scale -1 1 1 LookAt 1.1 .3 3.7  .1 0 0  0 1 0 Camera \"perspective\" \"float fov\" 37.3\n"
        "Film \"rgb\" \"integer xresolution\" 321 \"integer yresolution\" 123\n"
        "Sampler \"independent\" \"integer pixelsamples\" 7 \"integer seed\" 5\nWorldBegin\n"
        "LightSource \"distant\" \"point3 from\" [1.3 .7 -.2] \"rgb L\" [1 2 3] \"float scale\" .3\n"
        "LightSource \"point\" \"point3 from\" [1 2 .1] \"rgb I\" [5 4 3]\n"
        "Texture \"r\" \"spectrum\" \"heightramp\" \"string ramp\" \"viridis\"\n"
        "Texture \"i\" \"spectrum\" \"imagemap\" \"string filename\" \"b.png\" \"float scale\" .9 \"float lonorigin\" "
        "0\n"
        "Material \"matte\" \"texture Kd\" \"r\"\nRotate 33.3 1 2 3 Translate .1 .2 .3\n"
        "Shape \"displacedsphere\" \"string displacementmap\" \"deep/a \\\" b.png\" \"float heightscale\" .1\n"
        "  \"float midlevel\" .5 \"float heightmin\" -3 \"float heightmax\" 9.1 \"string registration\" \"gridline\"\n"
        "  \"float lonorigin\" 0 \"float blur\" 1.5 \"float nodata\" -32768 \"float radius\" 1.7\n"
        "Material \"matte\" \"texture Kd\" \"i\"\nShape \"disk\" \"float radius\" 2 \"float innerradius\" 1\n"
        "Material \"matte\" \"rgb Kd\" [.1 .2 .3]\nShape \"sphere\" \"float radius\" .3\n"
        "Shape \"displacedsphere\" \"float maxdispl\" -3.3\n"
        "Shape \"displacedsphere\" \"string displacementmap\" \"a.png\" \"string filter\" \"bspline\"\n"
        "Shape \"displacedsphere\" \"string displacementmap\" \"a.png\" \"bool smoothnormals\" true\n"
        "Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\" \"integer ufrequency\" 7\n");
}

TEST(SceneWriter, MaterialsLightsAndMeshes) {
    expectRoundTrip(R"(Film "rgb" "float cropwindow" [0 .3 .1 1]
        Integrator "path" "integer maxdepth" 3 "bool regularize" true
        PixelFilter "gaussian" "float xradius" 1.7 "float yradius" 2 "float sigma" .47
        WorldBegin
        Shape "sphere"
        LightSource "point"
        AttributeBegin
            Rotate 33 1 2 3 Scale 1 -1 1
            LightSource "infinite" "string filename" "sky.exr" "rgb L" [.1 .2 .3]
        AttributeEnd
        AttributeBegin
            AreaLightSource "diffuse" "rgb L" [1 2 3] "bool twosided" true
            Material "mirror" "rgb Kr" [.1 .2 .3]
            Scale .1 .1 .1 Rotate 12 0 0 1
            Shape "disk"
        AttributeEnd
        LightSource "distant"
        Material "metal" "spectrum eta" "Ag" "spectrum k" "Ag" "float roughness" .07
        Shape "sphere"
        AreaLightSource "diffuse" "rgb L" [3 3 3]
        Texture "i" "color" "imagemap" "string filename" "b.png" "float scale" .9
        Texture "s" "color" "scale" "texture tex" "i" "rgb scale" [.1 .7 3]
        Material "plastic" "texture Kd" "s" "rgb Ks" [.3 .2 .1]
        Shape "sphere" "float radius" .3)");
    expectRoundTrip(R"(Integrator "directlighting" "integer maxdepth" 0
        PixelFilter "sinc" "float xwidth" 3 "float tau" 2.5
        WorldBegin
        LightSource "infinite"
        Texture "c" "color" "checkerboard" "rgb tex1" [.1 .2 .3] "float tex2" .7 "float uscale" 12 "float vscale" -6
        Material "matte" "texture Kd" "c" "float sigma" 17.3
        Shape "trianglemesh" "point3 P" [0 0 0 1.1 0 0 1 0 1 0 .1 1] "integer indices" [0 1 2 0 2 3]
            "point2 uv" [0 0 .3 0 .3 1 0 1]
        Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0]
        Texture "r" "color" "heightramp"
        Texture "s" "color" "scale" "texture tex1" "r" "rgb tex2" [.1 .5 .9]
        Material "plastic" "texture Kd" "s"
        Shape "displacedsphere")");
}

TEST(SceneWriter, PixelFilters) {
    for (const char* filter : {"\"box\" \"float xwidth\" 1", "\"triangle\"", "\"mitchell\" \"float B\" .2"})
        expectRoundTrip(std::string("PixelFilter ") + filter + "\nWorldBegin Shape \"sphere\"");
}

TEST(SceneWriter, OrthographicCamera) {
    expectRoundTrip(
        "LookAt 0 0 5  0 0 0  0 1 0 Camera \"orthographic\" \"float screenwindow\" [-2 2 -1.1 1.3]\n"
        "WorldBegin\nShape \"sphere\"\n");
}

// Normalising once more moves the last bit of many directions; what is written survives it.
TEST(SceneWriter, DirectionsOfLightsSurvive) {
    for (int i = 0; i < 200; ++i) {
        std::string from =
            std::to_string(i * 37 % 101 - 50) + " " + std::to_string(i * 53 % 97 - 48) + " " + std::to_string(i + 1);
        expectRoundTrip("WorldBegin\nLightSource \"distant\" \"point3 from\" [" + from +
                        "] \"point3 to\" [0 0 0]\nShape \"sphere\"\n");
    }
}

}  // namespace
}  // namespace dsphere::viewer
