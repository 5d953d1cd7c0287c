// What a user may get wrong, where the message points, and what it says.

#include "tests/scene/support.h"

#include <vector>

namespace dsphere {
namespace {

struct Malformed {
    std::string text;
    std::string place;  // line:column
    std::string says;
};

void expectAll(const std::vector<Malformed>& cases) {
    for (const Malformed& wrong : cases) {
        std::string message = errorOf(wrong.text);
        EXPECT_EQ(message.find("test.pbrt:" + wrong.place + ": "), 0u) << wrong.text << "\n" << message;
        EXPECT_NE(message.find(wrong.says), std::string::npos) << wrong.text << "\n" << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << "a message is one line: " << message;
    }
}

TEST(Malformed, Text) {
    expectAll({
        {"Camera \"persp", "1:8", "unterminated string"},
        {"Camera \"persp\nective\"", "1:8", "unterminated string"},
        {"Film \"a\\n\"", "1:9", "unknown escape"},
        {"Film \"a\\", "1:9", "unknown escape"},
        {std::string("World\0Begin", 11), "1:6", "control character 0x00"},
        {"Film \"a\tb\"", "1:8", "control character 0x09"},
        {"# only\n\n  Shpae", "3:3", "unknown directive \"Shpae\"; supported: Include, LookAt"},
        {"\"Camera\"", "1:1", "expected a directive, found \"Camera\""},
        {"[ 1 2 ]", "1:1", "expected a directive, found '['"},
        {"worldbegin", "1:1", "unknown directive \"worldbegin\""},
        {"SurfaceIntegrator", "1:1", "unknown directive \"SurfaceIntegrator\""},
        {"MediumInterface \"air\"", "1:17", "medium \"air\": media are not supported"},
    });
}

TEST(Malformed, Structure) {
    expectAll({
        {"", "1:1", "no WorldBegin"},
        {"Camera \"perspective\"\n", "2:1", "no WorldBegin"},
        {"WorldBegin\n", "2:1", "no shape"},
        {"WorldBegin WorldEnd", "1:20", "no shape"},
        {"Shape \"sphere\"", "1:1", "Shape stands before WorldBegin"},
        {"LightSource \"distant\"", "1:1", "LightSource stands before WorldBegin"},
        {"AttributeBegin", "1:1", "before WorldBegin"},
        {"WorldEnd", "1:1", "before WorldBegin"},
        {"WorldBegin\nCamera \"perspective\"", "2:1", "Camera stands after WorldBegin"},
        {"WorldBegin WorldBegin", "1:12", "WorldBegin stands after WorldBegin"},
        {"WorldBegin Shape \"sphere\" WorldEnd\nIdentity", "2:1", "after WorldEnd"},
        {"WorldBegin AttributeEnd", "1:12", "AttributeEnd without AttributeBegin"},
        {"WorldBegin TransformEnd", "1:12", "TransformEnd without TransformBegin"},
        {"WorldBegin AttributeBegin\n TransformEnd", "2:2", "TransformEnd inside the AttributeBegin of test.pbrt:1:12"},
        {"WorldBegin TransformBegin\n AttributeEnd", "2:2", "AttributeEnd inside the TransformBegin of test.pbrt:1:12"},
        {"WorldBegin Shape \"sphere\"\n AttributeBegin", "2:2", "AttributeBegin is not closed before the end"},
        {"WorldBegin Shape \"sphere\"\n TransformBegin WorldEnd", "2:2",
         "TransformBegin is not closed before WorldEnd"},
        {"Film \"rgb\"\nFilm \"rgb\"", "2:1", "Film is given twice, first at test.pbrt:1:1"},
        {"Camera \"perspective\" Camera \"perspective\"", "1:22", "Camera is given twice"},
        {"Sampler \"a\" Sampler \"b\"", "1:13", "Sampler is given twice"},
        {"Include 5", "1:9", "expected a file's name in double quotes, found \"5\""},
    });
}

TEST(Malformed, Transforms) {
    expectAll({
        {"Translate 1 2", "1:14", "expected a number, found the end of the file"},
        {"Translate 1 2 x", "1:15", "expected a number, found \"x\""},
        {"Translate 1 2 \"3\"", "1:15", "expected a number"},
        {"Translate [1 2 3]", "1:11", "expected a number, found '['"},
        {"Translate 1 2 nan", "1:15", "\"nan\" is not a finite number"},
        {"Translate 1 2 -inf", "1:15", "\"-inf\" is not a finite number"},
        {"Translate 1 2 1e999", "1:15", "\"1e999\" is not a finite number"},
        {"Translate 1 2 3e", "1:15", "expected a number, found \"3e\""},
        {"Translate 1 2 +-3", "1:15", "expected a number"},
        {"Translate 1 2 3 4", "1:17", "unknown directive \"4\""},
        {"Rotate 90 0 0 0", "1:1", "the axis of Rotate is 0 0 0"},
        {"LookAt 0 0 1  0 0 1  0 1 0", "1:1", "degenerate LookAt"},
        {"LookAt 0 0 1  0 0 0  0 0 7", "1:1", "degenerate LookAt"},
        {"LookAt 0 0 1  0 0 0  0 0 0", "1:1", "degenerate LookAt"},
        {"LookAt 1e308 0 0  -1e308 0 0  0 1 0", "1:1", "degenerate LookAt"},
        {"Scale 1e200 1 1\nScale 1e200 1 1", "2:1", "Scale overflows"},
        {"Transform 1 0 0", "1:11", "expected '['"},
        {"Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0]", "1:41", "expected a number, found ']'"},
        {"Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 2]", "1:44", "expected ']'"},
        {"ConcatTransform [1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1]", "1:1", "ConcatTransform is not affine"},
        {"Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2]", "1:1", "not affine"},
        {"Scale 0 1 1 Camera \"perspective\"", "1:13", "the camera's transform is singular"},
        {"WorldBegin Scale 1 1 0 Shape \"sphere\"", "1:24", "the shape's transform is singular"},
        {"WorldBegin Scale 1e-150 1e-150 1e-150 Shape \"sphere\"", "1:39", "singular"},
    });
}

TEST(Malformed, Parameters) {
    expectAll({
        {"Camera perspective", "1:8", "expected the camera in double quotes, found \"perspective\""},
        {"Camera \"perspective\" \"fov\" 5", "1:22", "declared as \"type name\""},
        {"Camera \"perspective\" \"float fov x\" 5", "1:22", "declared as \"type name\""},
        {"Camera \"perspective\" \"\" 5", "1:22", "declared as \"type name\""},
        {"Camera \"perspective\" \"flaot fov\" 5", "1:22",
         "unknown parameter type \"flaot\"; supported: float, integer"},
        {"Camera \"perspective\" \"float fvo\" 5", "1:22",
         "unknown parameter \"fvo\" of Camera \"perspective\"; supported: float fov, float halffov, float "
         "screenwindow"},
        {"Camera \"perspective\" \"bool fov\" 5", "1:22", "has type bool; supported: float"},
        {"Camera \"perspective\" \"float fov\"", "1:33", "expected a value of parameter \"fov\""},
        {"Camera \"perspective\" \"float fov\" ]", "1:34", "expected a value of parameter \"fov\", found ']'"},
        {"Camera \"perspective\" \"float fov\" []", "1:22", "takes 1 value, found 0"},
        {"Camera \"perspective\" \"float fov\" [5 6]", "1:22", "takes 1 value, found 2"},
        {"Camera \"perspective\" \"float fov\" [[5]]", "1:35", "expected ']' after the values"},
        {"Camera \"perspective\" \"float fov\" [5", "1:36", "expected ']' after the values"},
        {"Camera \"perspective\" \"float fov\" \"5\"", "1:34", "expected a number, found \"5\""},
        {"Camera \"perspective\" \"float fov\" five", "1:34", "expected a number, found \"five\""},
        {"Camera \"perspective\" \"float fov\" 5\n\"float fov\" 6", "2:1", "given twice, first at test.pbrt:1:22"},
        {"Film \"rgb\" \"integer xresolution\" 10.5", "1:34", "expected an integer, found \"10.5\""},
        {"Film \"rgb\" \"integer xresolution\" 4294967297", "1:34",
         "\"4294967297\" does not fit an integer of 32 bits"},
        {"Film \"rgb\" \"string filename\" x.exr", "1:30", "takes a word in double quotes, found \"x.exr\""},
        {"Film \"rgb\" \"bool filename\" true", "1:12", "has type bool; supported: string"},
        {"WorldBegin Material \"matte\" \"rgb Kd\" .5", "1:29", "takes 3 values in [ ], found 1"},
        {"WorldBegin Material \"matte\" \"spectrum Kd\" \"x\"", "1:29", "has type spectrum; supported: rgb, texture"},
        {"WorldBegin LightSource \"point\" \"vector from\" [0 0 0]", "1:32", "has type vector; supported: point"},
        {"WorldBegin LightSource \"distant\" \"spectrum L\" [400 1]", "1:34", "has type spectrum; supported: rgb"},
    });
}

TEST(Malformed, Options) {
    expectAll({
        {"Camera \"fisheye\"", "1:8", "unknown camera \"fisheye\"; supported: perspective, orthographic"},
        {"Camera \"orthographic\" \"float fov\" 40", "1:23", "fov"},
        {"Camera \"perspective\" \"float fov\" 0", "1:34", "parameter \"fov\" is 0; supported: in [0.0001, 179.99]"},
        {"Camera \"perspective\" \"float fov\" 180", "1:34", "is 180; supported: in [0.0001, 179.99]"},
        {"Camera \"perspective\" \"float lensradius\" 1", "1:41", "is 1; supported: 0, a pinhole"},
        {"Camera \"perspective\" \"float screenwindow\" [-1 1 1 1]", "1:1", "screenwindow is empty"},
        {"Camera \"perspective\" \"float screenwindow\" [-1 1 1]", "1:22", "takes 4 values in [ ], found 3"},
        {"Camera \"perspective\" \"float frameaspectratio\" 0", "1:47", "in [9.5"},
        {"Camera \"perspective\" \"float frameaspectratio\" 1 \"float screenwindow\" [-1 1 -1 1]", "1:1", "exclude"},
        {"Film \"sphere\"", "1:6", "unknown film \"sphere\"; supported: image, rgb, gbuffer"},
        {"Film \"rgb\" \"integer xresolution\" 0", "1:34", "is 0; supported: in [1, 1048576]"},
        {"Film \"rgb\" \"integer yresolution\" 1048577", "1:34", "is 1048577; supported: in [1, 1048576]"},
        {"Film \"rgb\" \"string filename\" \"\"", "1:30", "filename is empty"},
        {"Film \"rgb\" \"float cropwindow\" [.5 .5 0 1]", "1:1", "cropwindow [0.5 0.5 0 1] holds no pixel"},
        {"Film \"rgb\" \"float cropwindow\" [.6 .5 0 1]", "1:1", "holds no pixel"},
        {"Film \"rgb\" \"float cropwindow\" [0 1 -.1 1]", "1:36", "is -0.1; supported: in [0, 1]"},
        {"Film \"rgb\" \"integer xresolution\" 2 \"float cropwindow\" [.1 .2 0 1]", "1:1", "holds no pixel of 2 x 720"},
        {"Film \"rgb\" \"float diameter\" 35", "1:12", "unknown parameter \"diameter\""},
        {"Sampler \"halton\" \"integer pixelsamples\" 0", "1:41", "is 0; supported: in [1, 65536]"},
        {"Sampler \"halton\" \"integer seed\" -1", "1:33", "is -1; supported: in [0, 2147483647]"},
        {"Sampler \"halton\" \"string pixelsamples\" \"1\"", "1:18", "has type string; supported: integer"},
        {"Integrator \"bdpt\"", "1:12", "unknown integrator \"bdpt\"; supported: directlighting, path, volpath"},
        {"Integrator \"path\" \"integer maxdepth\" -1", "1:38", "is -1; supported: in [0, "},
        {"Integrator \"directlighting\" \"bool regularize\" true", "1:29", "supported: integer maxdepth"},
        {"Integrator \"path\"\nIntegrator \"path\"", "2:1", "Integrator is given twice"},
        {"PixelFilter \"catmull\"", "1:13",
         "unknown pixel filter \"catmull\"; supported: box, gaussian, triangle, mitchell, sinc"},
        {"PixelFilter \"box\" \"float xwidth\" 0", "1:34", "supported: in [0.01, 8]"},
        {"PixelFilter \"box\" \"float sigma\" 1", "1:19", "unknown parameter \"sigma\""},
        {"PixelFilter \"gaussian\" \"float xwidth\" 2\n\"float yradius\" 2", "2:1",
         "yradius is pbrt v4's, and xwidth (at test.pbrt:1:24) is pbrt v3's: give one spelling"},
        {"PixelFilter \"gaussian\" \"float alpha\" 2 \"float sigma\" 1", "1:40", "give one spelling"},
        {"PixelFilter \"gaussian\" \"float sigma\" 0", "1:38", "supported: in [0.03, 20]"},
        {"WorldBegin PixelFilter \"box\"", "1:12", "PixelFilter stands after WorldBegin"},
        {"Integrator \"directlighting\" \"string strategies\" \"all\"", "1:29", "supported: integer maxdepth"},
    });
}

TEST(Malformed, MaterialsAndTextures) {
    expectAll({
        {"WorldBegin Material \"coateddiffuse\"", "1:21",
         "unknown material \"coateddiffuse\"; supported: matte, diffuse, metal, conductor, mirror, plastic"},
        {"WorldBegin Material \"matte\" \"rgb Kd\" [0 0 1.5]", "1:43", "is 1.5; supported: in [0, 1]"},
        {"WorldBegin Material \"matte\" \"rgb Kd\" [0 0 -1]", "1:43", "is -1; supported: in [0, 1]"},
        {"WorldBegin Material \"matte\" \"float sigma\" 91", "1:43", "is 91; supported: in [0, 90]"},
        {"WorldBegin Material \"matte\" \"rgb Kd\" [0 0 0] \"rgb reflectance\" [0 0 0]", "1:46", "give one"},
        {"WorldBegin Material \"matte\" \"texture Kd\" \"none\"", "1:42", "undefined texture \"none\""},
        {"WorldBegin Material \"matte\" \"texture Kd\" [\"a\" \"b\"]", "1:29", "takes 1 value, found 2"},
        {"WorldBegin NamedMaterial \"none\"", "1:26", "undefined material \"none\""},
        {"WorldBegin MakeNamedMaterial \"a\"", "1:12", "lacks \"string type\"; supported: matte, diffuse"},
        {"WorldBegin MakeNamedMaterial \"a\" \"string type\" \"glass\"", "1:48", "unknown type \"glass\""},
        {"WorldBegin MakeNamedMaterial \"a\" \"string type\" \"matte\" MakeNamedMaterial \"a\" \"string type\" "
         "\"matte\"",
         "1:74", "material \"a\" is defined twice"},
        {"WorldBegin Texture \"t\" \"float\" \"constant\"", "1:24", "unknown texture type \"float\"; supported: color"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\"", "1:12", "lacks \"string filename\""},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"string filename\" \"\"", "1:61", "name is empty"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"string filename\" \"a\" \"string wrap\" \"clamp\"", "1:79",
         "unknown wrap \"clamp\"; supported: repeat"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"float scale\" -1", "1:57", "supported: at least 0"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"bool cubic\" \"false\"", "1:43",
         "supported: string filename, float scale, float lonorigin, string wrap"},
        {"WorldBegin Texture \"t\" \"color\" \"dots\"", "1:32",
         "supported: constant, heightramp, imagemap, checkerboard, scale"},
        {"WorldBegin Texture \"t\" \"color\" \"constant\" \"float value\" 1", "1:43", "has type float; supported: rgb"},
        {"WorldBegin Texture \"t\" \"color\" \"heightramp\" \"string ramp\" \"jet\"", "1:59",
         "unknown ramp \"jet\"; supported: terrain, viridis, geoid, grey"},
        {"WorldBegin Texture \"t\" \"color\" \"constant\" Texture \"t\" \"color\" \"constant\"", "1:51",
         "texture \"t\" is defined twice"},
        {"WorldBegin Texture \"h\" \"color\" \"heightramp\" Material \"matte\" \"texture Kd\" \"h\"\nShape \"disk\"",
         "2:1", "a disk has not; supported on: displacedsphere"},
    });
}

TEST(Malformed, RoughAndShinyMaterials) {
    expectAll({
        {"WorldBegin Material \"mirror\" \"rgb Kr\" [0 0 2]", "1:44", "is 2; supported: in [0, 1]"},
        {"WorldBegin Material \"mirror\" \"float Kr\" 1", "1:30", "has type float; supported: rgb, texture"},
        {"WorldBegin Material \"metal\" \"rgb eta\" [1 -1 1]", "1:42", "is -1; supported: in [0, 1000]"},
        {"WorldBegin Material \"conductor\" \"spectrum eta\" \"metal-Fe-eta\"", "1:48",
         "unknown spectrum \"metal-Fe-eta\" of eta; supported: Cu, Au, Ag, Al, also as \"metal-Cu-eta\""},
        {"WorldBegin Material \"conductor\" \"spectrum k\" \"metal-Cu-eta\"", "1:46", "of k; supported: Cu"},
        {"WorldBegin Material \"conductor\" \"spectrum k\" [300 1 800 2]", "1:33", "takes 1 value, found 4"},
        {"WorldBegin Material \"conductor\" \"rgb reflectance\" [1 1 1]", "1:33", "unknown parameter \"reflectance\""},
        {"WorldBegin Material \"metal\" \"float uroughness\" .1 \"float vroughness\" .2", "1:29",
         "uroughness 0.1 is not vroughness 0.2; supported: the same roughness"},
        {"WorldBegin Material \"metal\"\n\"float vroughness\" .2", "2:1", "uroughness 0.01 is not vroughness 0.2"},
        {"WorldBegin Material \"plastic\" \"float roughness\" -1", "1:49", "supported: at least 0"},
        {"WorldBegin Material \"plastic\" \"bool remaproughness\" 1", "1:53", "supported: true, false"},
        {"WorldBegin Material \"plastic\" \"float eta\" 1.5", "1:31", "unknown parameter \"eta\""},
        {"WorldBegin Texture \"h\" \"color\" \"heightramp\"\nMaterial \"plastic\" \"texture Ks\" \"h\"", "2:33",
         "texture \"h\" varies, and Ks must not; supported: constant, or scale of such"},
        {"WorldBegin Texture \"h\" \"color\" \"heightramp\"\nMaterial \"mirror\" \"texture Kr\" \"h\"", "2:32",
         "and Kr must not"},
    });
}

TEST(Malformed, CombinedTextures) {
    const std::string image = "WorldBegin Texture \"i\" \"color\" \"imagemap\" \"string filename\" \"a.png\"\n";
    expectAll({
        {"WorldBegin Texture \"t\" \"color\" \"checkerboard\" \"rgb tex1\" [0 0 2]", "1:63", "in [0, 1]"},
        {"WorldBegin Texture \"t\" \"color\" \"checkerboard\" \"integer dimension\" 3", "1:67",
         "\"dimension\" of Texture \"checkerboard\" is 3; supported: 2"},
        {image + "Texture \"t\" \"color\" \"checkerboard\" \"texture tex2\" \"i\"", "2:51",
         "texture \"i\" varies, and tex2 must not"},
        {"WorldBegin Texture \"t\" \"color\" \"checkerboard\" \"float uscale\" 1e9", "1:62", "in [-65536, 65536]"},
        {image + "Texture \"t\" \"color\" \"scale\" \"texture tex1\" \"i\" \"texture tex2\" \"i\"", "2:1",
         "tex1 and tex2 both vary; supported: one of them constant"},
        {image + "Texture \"t\" \"color\" \"scale\" \"texture tex1\" \"i\" \"float scale\" 1", "2:48",
         "scale is pbrt v4's, and tex1 (at test.pbrt:2:29) is pbrt v3's: give one spelling"},
        {image + "Texture \"t\" \"color\" \"scale\" \"texture tex\" \"none\"", "2:43", "undefined texture \"none\""},
        {image + "Texture \"t\" \"color\" \"scale\" \"texture tex\" \"i\" \"float scale\" -1", "2:61",
         "is -1; supported: in [0, 1000000]"},
        {image + "Texture \"t\" \"float\" \"checkerboard\"", "2:13", "unknown texture type \"float\""},
        {image + "Texture \"h\" \"color\" \"heightramp\" Texture \"s\" \"color\" \"scale\" \"texture tex\" \"h\"\n"
                 "Material \"plastic\" \"texture Kd\" \"s\" Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]",
         "3:37", "a trianglemesh has not; supported on: displacedsphere"},
    });
}

TEST(Malformed, InfiniteAndAreaLights) {
    const std::string area = "WorldBegin AreaLightSource \"diffuse\"\n";
    expectAll({
        {"WorldBegin LightSource \"infinite\" \"string mapname\" \"a\" \"string filename\" \"a\"", "1:56",
         "mapname and filename mean the same: give one"},
        {"WorldBegin LightSource \"infinite\" \"string filename\" \"\"", "1:53", "the image's name is empty"},
        {"WorldBegin LightSource \"infinite\" \"integer sample\" 4", "1:35", "unknown parameter \"sample\""},
        {"WorldBegin Scale 2 2 2\nLightSource \"infinite\"", "2:1", "supported: rotations and mirrorings"},
        {"WorldBegin Scale 1 1 .9\nLightSource \"infinite\"", "2:1", "transform scales or shears"},
        {"WorldBegin LightSource \"infinite\"\nLightSource \"infinite\"", "2:1",
         "a second infinite light, the first being at test.pbrt:1:12; supported: one"},
        {"AreaLightSource \"diffuse\"", "1:1", "AreaLightSource stands before WorldBegin"},
        {"WorldBegin AreaLightSource \"area\"", "1:28", "unknown area light \"area\"; supported: diffuse"},
        {"WorldBegin AreaLightSource \"diffuse\" \"rgb L\" [-1 0 0]", "1:47", "supported: at least 0"},
        {"WorldBegin AreaLightSource \"diffuse\" \"rgb L\" [1e300 0 0] \"float scale\" 1e300", "1:12",
         "L times scale is inf"},
        {"WorldBegin AreaLightSource \"diffuse\" \"float power\" 5", "1:38", "lights are not scaled by their power"},
        {area + "Shape \"displacedsphere\"", "2:1",
         "for this displacedsphere, which cannot shine; supported: sphere, disk"},
        {area + "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]", "2:1", "supported: sphere, disk"},
        {area + "Scale 1 2 1 Shape \"disk\"", "2:13", "this disk that shines changes angles"},
        {"WorldBegin AreaLightSource \"diffuse\" \"bool twosided\" true\nShape \"sphere\"", "2:1",
         "a sphere cannot shine on both sides"},
    });
}

TEST(Malformed, TriangleMeshes) {
    const std::string mesh = "WorldBegin Shape \"trianglemesh\"\n", p = "\"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0] ";
    std::string many = "\"integer indices\" [";
    for (int i = 0; i < 65; ++i) many += "0 1 2 ";
    expectAll({
        {mesh, "1:12", "lacks \"point3 P\""},
        {mesh + p, "1:12", "lacks \"integer indices\" of its 4 points"},
        {mesh + "\"point3 P\" [0 0 0 1]", "2:1", "has 4 numbers; supported: 3 for each of 1 to 192 points"},
        {mesh + "\"point3 P\" []", "2:1", "has 0 numbers"},
        {mesh + p + "\"integer indices\" [0 1 2 3]", "2:38",
         "has 4 numbers; supported: 3 for each of 1 to 64 triangles"},
        {mesh + p + many + "]", "2:38", "has 195 numbers"},
        {mesh + p + "\"integer indices\" [0 1 4]", "2:61", "index 4 names no point; supported: in [0, 3]"},
        {mesh + p + "\"integer indices\" [0 -1 2]", "2:59", "index -1 names no point"},
        {mesh + p + "\"integer indices\" [0 1 2.5]", "2:61", "expected an integer"},
        {mesh + p + "\"integer indices\" [0 1 2 1 1 2]", "1:12", "triangle 1 of the mesh, counted from 0, has no area"},
        {mesh + "\"point3 P\" [0 0 0 1 1 1 3 3 3]", "1:12", "triangle 0 of the mesh"},
        {mesh + "\"point3 P\" [0 0 0 1 0 0 0 1 0] \"point2 uv\" [0 0 1 1]", "2:32",
         "has 4 numbers; supported: 2 for each of the 3 points"},
        {mesh + "\"point3 P\" [0 0 0 1 0 0 0 1 0] \"float uv\" [0 0 1 0 1 1]\n\"float st\" [0 0 1 0 1 1]", "3:1",
         "uv and st mean the same"},
        {mesh + "\"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal M\" [0 0 1 0 0 1 0 0 1]", "2:32",
         "unknown parameter \"M\" of Shape \"trianglemesh\"; supported: point P, integer indices"},
    });
}

TEST(Malformed, LightsAndShapes) {
    expectAll({
        {"WorldBegin LightSource \"spot\"", "1:24", "unknown light \"spot\"; supported: distant, point, infinite"},
        {"WorldBegin LightSource \"distant\" \"point to\" [0 0 0]", "1:12", "no direction"},
        {"WorldBegin Scale 1 1 0 LightSource \"distant\"", "1:24", "no direction"},
        {"WorldBegin LightSource \"point\" \"rgb I\" [1 -2 3]", "1:43", "is -2; supported: at least 0"},
        {"WorldBegin LightSource \"point\" \"float scale\" -1", "1:46", "is -1; supported: at least 0"},
        {"WorldBegin LightSource \"point\" \"rgb I\" [1e300 0 0] \"float scale\" 1e300", "1:12",
         "I times scale is inf"},
        {"WorldBegin Scale 1e300 1 1 LightSource \"point\" \"point from\" [1e300 0 0]", "1:28",
         "the point light is at inf 0 0"},
        {"WorldBegin Shape \"cone\"", "1:18",
         "unknown shape \"cone\"; supported: displacedsphere, sphere, disk, trianglemesh, bilinearmesh"},
        {"WorldBegin Shape \"sphere\" \"float radius\" 0", "1:42", "is 0; supported: greater than 0"},
        {"WorldBegin Shape \"sphere\" \"float radius\" -1", "1:42", "is -1; supported: greater than 0"},
        {"WorldBegin Shape \"sphere\" \"float phimin\" 90", "1:27", "supported: float radius"},
        {"WorldBegin Shape \"disk\" \"float innerradius\" 1", "1:12", "innerradius 1 is not below the radius 1"},
        {"WorldBegin Shape \"disk\" \"float innerradius\" -1", "1:45", "at least 0"},
        {"WorldBegin Shape \"displacedsphere\" \"float radius\" 0", "1:51", "greater than 0"},
        {"WorldBegin Shape \"displacedsphere\" \"string filter\" \"cubic\"", "1:52", "unknown filter \"cubic\""},
        {"WorldBegin Shape \"displacedsphere\" \"string displacementfunction\" \"waves\"", "1:66",
         "unknown displacementfunction \"waves\"; supported: ripples"},
        {"WorldBegin Shape \"displacedsphere\" \"integer ufrequency\" 3", "1:36", "belongs to a displacementfunction"},
        {"WorldBegin Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\"\n \"integer ufrequency\" 0",
         "2:23", "supported: in [1, 512]"},
        {"WorldBegin Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\"\n \"string filter\" "
         "\"bspline\"",
         "2:2", "filter and displacementfunction exclude each other"},
        {"WorldBegin Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\"\n \"string "
         "displacementmap\" \"a.png\"",
         "2:2", "displacementmap and displacementfunction exclude each other"},
        {"WorldBegin Shape \"displacedsphere\" \"bool smoothnormals\" 1", "1:57", "supported: true, false"},
        {"WorldBegin Shape \"displacedsphere\" \"float smoothnormals\" 1", "1:36", "supported: bool"},
        {"WorldBegin Shape \"displacedsphere\" \"string registration\" \"pixel\"", "1:58",
         "supported: texel, gridline"},
        {"WorldBegin Shape \"displacedsphere\" \"float lonorigin\" 361", "1:54", "in [-360, 360]"},
        {"WorldBegin Shape \"displacedsphere\" \"string displacementmap\" \"\"", "1:61", "name is empty"},
        {"WorldBegin Shape \"displacedsphere\" \"float maxdispl\" 1 \"float heightscale\" 1", "1:12",
         "exclude each other"},
        {"WorldBegin Shape \"displacedsphere\" \"float heightmin\" 3 \"float heightmax\" 3", "1:12",
         "heightmin equals heightmax"},
        {"WorldBegin Shape \"displacedsphere\" \"float smooth\" 1", "1:36", "unknown parameter \"smooth\""},
        {"WorldBegin Shape \"displacedsphere\" \"float blur\" -1", "1:49", "is -1; supported: in [0, 1000]"},
        {"WorldBegin Shape \"displacedsphere\" \"float blur\" 1000.5", "1:49", "supported: in [0, 1000]"},
        {"WorldBegin Shape \"displacedsphere\" \"float blur\" nan", "1:49", "not a finite number"},
        {"WorldBegin Shape \"displacedsphere\" \"float midlevel\" nan", "1:53", "not a finite number"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" inf", "1:51", "not a finite number"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" -nan", "1:51", "not a finite number"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" none", "1:51", "expected a number"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" \"nan\"", "1:51", "expected a number"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" 1e39", "1:51", "supported: in [-3.4028235e+38"},
        {"WorldBegin Shape \"displacedsphere\" \"float nodata\" [nan 1]", "1:36", "takes 1 value, found 2"},
    });
}

}  // namespace
}  // namespace dsphere
