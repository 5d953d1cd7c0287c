// All mistakes of a scene in one run, each once, and none that only follows from another.

#include "base/limits.h"
#include "tests/scene/support.h"

#include <sstream>

namespace dsphere {
namespace {

std::vector<std::string> errorsOf(const std::string& text) {
    std::istringstream lines(errorOf(text));
    std::vector<std::string> errors;
    for (std::string line; std::getline(lines, line);) errors.push_back(line);
    return errors;
}

/// Each error begins with "test.pbrt:" and its place, and says what is wanted of it; there are no others.
void expectErrors(const std::string& text, const std::vector<std::pair<std::string, std::string>>& wanted) {
    const std::vector<std::string> errors = errorsOf(text);
    std::string all;
    for (const std::string& error : errors) all += error + "\n";
    ASSERT_EQ(errors.size(), wanted.size()) << text << "\n" << all;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(errors[i].find("test.pbrt:" + wanted[i].first + ": "), 0u) << errors[i];
        EXPECT_NE(errors[i].find(wanted[i].second), std::string::npos) << errors[i];
    }
}

TEST(Recovery, TwelveMistakesComeInOneRun) {
    expectErrors(R"(Camera "perspectiv" "float fov" 40
Film "rgb" "integer xresolution" [0] "string filname" "a.exr"
Sampler "halton" "integer pixelsamples" many
Integrator "bdpt" "integer maxdepth" 3
Translate 1 2
WorldBegin
LightSource "spot" "point3 from" [0 0 1]
MakeNamedMaterial "gold" "string type" "metall"
Material "matte" "rgb Kd" [.5 2 .5]
Shpae "sphere"
NamedMaterial "gold"
NamedMaterial "silver"
Shape "sphere" "float radius" -1
Texture "t" "spectrum" "imagemap"
Shape "disk"
)",
                 {{"1:8", "unknown camera \"perspectiv\""},
                  {"2:35", "parameter \"xresolution\" is 0"},
                  {"2:38", "unknown parameter \"filname\""},
                  {"3:41", "expected an integer, found \"many\""},
                  {"4:12", "unknown integrator \"bdpt\""},
                  {"6:1", "expected a number, found \"WorldBegin\""},
                  {"7:13", "unknown light \"spot\""},
                  {"8:40", "unknown type \"metall\""},
                  {"9:31", "parameter \"Kd\" is 2"},
                  {"10:1", "unknown directive \"Shpae\""},
                  {"12:15", "undefined material \"silver\""},
                  {"13:31", "parameter \"radius\" is -1"},
                  {"14:1", "lacks \"string filename\""}});
}

TEST(Recovery, AllWrongParametersOfADirective) {
    expectErrors(
        "WorldBegin Shape \"displacedsphere\" \"float blur\" -1\n\"float radius\" 0\n\"float smooth\" 1\n"
        "\"string filter\" \"cubic\"\n\"floot maxdispl\" 3\n\"float midlevel\" nan\n\"float maxdispl 3\" 3",
        {{"1:49", "\"blur\" is -1"},
         {"2:16", "\"radius\" is 0"},
         {"3:1", "unknown parameter \"smooth\""},
         {"4:17", "unknown filter \"cubic\""},
         {"5:1", "unknown parameter type \"floot\""},
         {"6:18", "not a finite number"},
         {"7:1", "declared as \"type name\""}});
}

TEST(Recovery, WhatFailedIsNotMissedLater) {
    expectErrors(R"(WorldBegin
Texture "t" "color" "imagemap" "string file" "a.png"
Texture "s" "color" "scale" "texture tex" "t" "float scale" .5
MakeNamedMaterial "m" "string type" "glass"
NamedMaterial "m"
Material "matte" "texture Kd" "s"
Shape "cone" "float radius" 1 "point3 P" [1 2 3]
)",
                 {{"2:32", "unknown parameter \"file\""},
                  {"4:37", "unknown type \"glass\""},
                  {"7:7", "unknown shape \"cone\""}});
}

TEST(Recovery, UnbalancedBlocksAreToldOnce) {
    expectErrors("WorldBegin\nAttributeEnd\nShape \"sphere\"", {{"2:1", "AttributeEnd without AttributeBegin"}});
    expectErrors("WorldBegin AttributeBegin\nTransformEnd\nAttributeEnd\nShape \"sphere\"",
                 {{"2:1", "TransformEnd inside the AttributeBegin"}});
    expectErrors("AttributeBegin\nAttributeEnd\nWorldBegin Shape \"sphere\" \"float radius\" 0",
                 {{"1:1", "AttributeBegin stands before WorldBegin"}, {"3:42", "\"radius\" is 0"}});
}

TEST(Recovery, AWorldWithoutItsBeginningIsToldOnce) {
    expectErrors("Material \"matte\" LightSource \"infinite\" Shape \"sphere\"", {{"1:1", "before WorldBegin"}});
    expectErrors("Material \"matte\"\nCamera \"perspective\"\nWorldBegin Shape \"sphere\"",
                 {{"1:1", "before WorldBegin"}});
    expectErrors("WorldBegin Shape \"sphere\" WorldEnd\nIdentity Identity\nShape \"x\"", {{"2:1", "after WorldEnd"}});
}

TEST(Recovery, AMissingValueLeavesTheNextParameter) {
    expectErrors("Camera \"perspective\" \"float fov\" \"float lensradius\" 0\nWorldBegin Shape \"sphere\"",
                 {{"1:34", "expected a value of parameter \"fov\""}});
    expectErrors(
        "Camera \"perspective\" \"float screenwindow\" [0 1\nFilm \"rgb\" \"float x\" 1\nWorldBegin Shape \"disk\"",
        {{"2:1", "expected ']' after the values of parameter \"screenwindow\", found \"Film\""},
         {"2:12", "unknown parameter \"x\""}});
}

TEST(Recovery, StringsThatDoNotEnd) {
    expectErrors(
        "Film \"rgb\" \"string filename\" \"a.exr\nSampler \"x\" \"integer pixelsamples\" 0\n"
        "WorldBegin Shape \"sphere\"",
        {{"1:30", "unterminated string"}, {"2:36", "\"pixelsamples\" is 0"}});
}

TEST(Recovery, TwentyErrorsAndNoMore) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 20; ++i) text += "Shape \"cone\"\n";
    EXPECT_EQ(errorsOf(text).size(), 20u);
    text += "Shape \"cone\"\n";
    const std::vector<std::string> errors = errorsOf(text);
    ASSERT_EQ(errors.size(), 21u);
    EXPECT_EQ(errors[19].find("test.pbrt:21:7: "), 0u);
    EXPECT_EQ(errors[20], "more errors follow; these are the first 20");
}

TEST(Recovery, ErrorsOfIncludesComeInOrder) {
    Folder folder;
    const auto part = folder.write("part.pbrt", "Shape \"cone\"\nMaterial \"glass\"\n");
    const auto path = folder.write("scene.pbrt", "Camera \"x\"\nWorldBegin\nInclude \"part.pbrt\"\nShape \"cube\"\n");
    try {
        parseSceneFile(path);
        FAIL();
    } catch (const Error& error) {
        const std::string text = error.what();
        const std::size_t places[] = {text.find(path.string() + ":1:8: "), text.find(part.string() + ":1:7: "),
                                      text.find(part.string() + ":2:10: "), text.find(path.string() + ":4:7: ")};
        for (std::size_t place : places) EXPECT_NE(place, std::string::npos) << text;
        EXPECT_TRUE(std::is_sorted(std::begin(places), std::end(places))) << text;
    }
}

TEST(Recovery, NamesMayLieInAnIncludeThatIsMissing) {
    Folder folder;
    const auto path = folder.write("scene.pbrt",
                                   "WorldBegin Include \"none.pbrt\"\nNamedMaterial \"gold\"\nAttributeEnd\n"
                                   "Material \"matte\" \"texture Kd\" \"t\"\nShape \"sphere\"\n");
    try {
        parseSceneFile(path);
        FAIL();
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find(path.string() + ":1:20: cannot open"), 0u);
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

TEST(Recovery, WhatIsRefusedIsToldWhereItBegins) {
    expectErrors(
        "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\nMediumInterface \"fog\" \"\"\nWorldBegin\n"
        "ObjectBegin \"a\"\nShape \"sphere\"\nObjectEnd\nObjectInstance \"a\"\nObjectInstance \"a\"\n"
        "ActiveTransform EndTime\nShape \"sphere\"",
        {{"1:1", "media are not supported"},
         {"4:1", "instances are not supported"},
         {"9:1", "motion is not supported"}});
    expectErrors("WorldBegin MediumInterface \"air\" \"\" Shape \"sphere\"", {{"1:28", "media are not supported"}});
}

TEST(Limits, EndTheTextWhereTheyArePassed) {
    using namespace limits;
    std::string shapes = "WorldBegin\n", lights = "WorldBegin\n", deep = "WorldBegin\n", names = "WorldBegin\n";
    for (std::size_t i = 0; i < kShapes + 3; ++i) shapes += "Shape \"sphere\"\n";
    expectErrors(shapes, {{"66:1", "the scene has more than 64 shapes"}});
    for (std::size_t i = 0; i < kLights + 2; ++i) lights += "LightSource \"point\"\n";
    expectErrors(lights + "Shape \"sphere\"", {{"34:1", "the scene has more than 32 lights"}});
    for (std::size_t i = 0; i < kBlockDepth + 2; ++i) deep += "AttributeBegin\n";
    deep += "Shape \"sphere\"\n";
    for (std::size_t i = 0; i < kBlockDepth + 2; ++i) deep += "AttributeEnd\n";
    expectErrors(deep, {{"1026:1", "more than 1024 blocks are open"}});
    for (std::size_t i = 0; i < kDefinitions + 2; ++i)
        names += "MakeNamedMaterial \"" + std::to_string(i) + "\" \"string type\" \"matte\"\n";
    expectErrors(names + "Shape \"sphere\"", {{"65537:1", "more than 65536 names"}});
}

TEST(Limits, OfMeshesAndMarches) {
    std::string mesh = "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [";
    for (int i = 0; i < 64; ++i) mesh += "0 1 2 ";
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 9; ++i) text += mesh + "]\n";
    expectErrors(text, {{"10:1", "more than 512 triangles"}});
    text = "WorldBegin\n";
    for (int i = 0; i < 10; ++i) text += "LightSource \"point\"\n";
    for (int i = 0; i < 60; ++i) text += "Shape \"sphere\"\n";
    expectErrors(text, {{"70:1", "the shapes times the lights and the camera are more than 640 here"}});
}

TEST(Limits, OfOneDirective) {
    std::string many = "Camera \"perspective\"";
    for (int i = 0; i < 300; ++i) many += "\n\"float x" + std::to_string(i) + "\" 1";
    EXPECT_NE(errorOf(many + "\nWorldBegin Shape \"sphere\"").find("has more than 256 parameters"), std::string::npos);
    std::string values = "Camera \"perspective\" \"float screenwindow\" [";
    for (int i = 0; i < 70000; ++i) values += "1 ";
    expectErrors(values + "]\nWorldBegin Shape \"sphere\"",
                 {{"1:22", "parameter \"screenwindow\" has more than 65536 values"}});
}

TEST(Limits, OfTheText) {
    Folder folder;
    const auto part = folder.write("part.pbrt", std::string(std::size_t(9) << 20, '\n'));
    const auto path =
        folder.write("scene.pbrt", "WorldBegin Include \"part.pbrt\"\nInclude \"part.pbrt\"\nShape \"disk\"");
    try {
        parseSceneFile(path);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find(path.string() + ":2:9: "), 0u) << error.what();
        EXPECT_NE(std::string(error.what()).find("at most 16777216 bytes"), std::string::npos) << error.what();
    }
}

TEST(Limits, OfNumbersThatFloatsHold) {
    expectErrors(
        "LookAt 0 0 1e30 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 1e-9\nWorldBegin\n"
        "Shape \"sphere\" \"float radius\" 1e-30\nScale 1e30 1e30 1e30\nShape \"sphere\"\nIdentity\n"
        "Translate 1e40 0 0\nShape \"disk\"\nIdentity\n"
        "Shape \"displacedsphere\" \"float maxdispl\" 1e10\nLightSource \"point\" \"point3 from\" [1e30 0 0]\n"
        "LightSource \"point\" \"rgb I\" [1e30 0 0]\n",
        {{"2:1", "the eye is at 0 0 1e+30"},
         {"2:34", "\"fov\" is 1e-09"},
         {"4:1", "the shape's size in the world is 1e-30"},
         {"6:1", "the shape's size in the world is 1e+30"},
         {"9:1", "the shape lies at 1e+40 0 0"},
         {"11:42", "\"maxdispl\" is 10000000000"},
         {"12:1", "the point light is at 1e+30 0 0"},
         {"13:1", "I times scale is 1e+30"}});
}

}  // namespace
}  // namespace dsphere
