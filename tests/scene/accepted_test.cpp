// What pbrt's files hold beyond what dsphere reads: noted where it cannot change a picture, an error where it would.

#include "tests/scene/support.h"

namespace dsphere {
namespace {

/// The notes of a scene, without their places.
std::vector<std::string> notesOf(const Scene& scene) {
    std::vector<std::string> notes;
    for (const Notice& notice : scene.notices) {
        EXPECT_EQ(notice.kind, Notice::Kind::Note) << notice.text;
        EXPECT_EQ(notice.text.find("test.pbrt:"), 0u) << notice.text;
        notes.push_back(notice.text.substr(notice.text.find(": ") + 2));
    }
    return notes;
}

void expectNoted(const std::string& options, const std::string& world, const std::vector<std::string>& subjects) {
    const std::vector<std::string> notes = notesOf(parseParts(options, world));
    std::string all;
    for (const std::string& note : notes) all += note + "\n";
    ASSERT_EQ(notes.size(), subjects.size()) << all;
    for (std::size_t i = 0; i < notes.size(); ++i) EXPECT_EQ(notes[i].find(subjects[i] + " "), 0u) << notes[i];
}

TEST(Accepted, OptionsOfBothPbrts) {
    expectNoted("Film \"image\" \"float diagonal\" 35 \"float scale\" 1 \"float maxsampleluminance\" 1000000", "",
                {"parameter \"diagonal\" of Film \"image\"", "parameter \"scale\" of Film \"image\"",
                 "parameter \"maxsampleluminance\" of Film \"image\""});
    expectNoted("Film \"rgb\" \"string sensor\" \"cie1931\" \"float iso\" 100 \"bool savefp16\" false", "",
                {"parameter \"savefp16\"", "parameter \"iso\"", "parameter \"sensor\""});
    expectNoted("Sampler \"halton\" \"bool samplepixelcenter\" \"false\" \"string randomization\" \"owen\"", "",
                {"parameter \"samplepixelcenter\"", "parameter \"randomization\""});
    expectNoted("Integrator \"path\" \"float rrthreshold\" 1 \"string lightsamplestrategy\" \"spatial\"", "",
                {"parameter \"rrthreshold\"", "parameter \"lightsamplestrategy\""});
    expectNoted("Accelerator \"bvh\" \"string splitmethod\" \"sah\" ColorSpace \"srgb\" Option \"bool wavefront\" true",
                "", {"Accelerator", "ColorSpace", "parameter \"wavefront\" of Option"});
    expectNoted("Camera \"perspective\" \"float lensradius\" 0 \"float focaldistance\" 10 \"float shutterclose\" 1", "",
                {"parameter \"lensradius\"", "parameter \"focaldistance\"", "parameter \"shutterclose\""});
    expectNoted("TransformTimes 0 1 ActiveTransform All MediumInterface \"\" \"\"", "",
                {"TransformTimes", "ActiveTransform", "MediumInterface"});
}

TEST(Accepted, TheWorldOfBothPbrts) {
    expectNoted("", "ReverseOrientation Shape \"disk\" \"float alpha\" 1 \"float phimax\" 360",
                {"ReverseOrientation", "parameter \"alpha\" of Shape \"disk\"", "parameter \"phimax\""});
    expectNoted(
        "", "LightSource \"infinite\" \"integer nsamples\" 4 LightSource \"point\" \"integer samples\" 4",
        {"parameter \"nsamples\" of LightSource \"infinite\"", "parameter \"samples\" of LightSource \"point\""});
    expectNoted("",
                "Texture \"t\" \"spectrum\" \"checkerboard\" \"string mapping\" \"uv\" \"integer dimension\" 2\n"
                "\"float udelta\" 0 \"string aamode\" \"none\"",
                {"parameter \"mapping\"", "parameter \"udelta\"", "parameter \"dimension\"", "parameter \"aamode\""});
    expectNoted("",
                "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a\" \"string encoding\" \"sRGB\"\n"
                "\"bool trilinear\" false \"float uscale\" 1",
                {"parameter \"uscale\"", "parameter \"trilinear\"", "parameter \"encoding\""});
    expectNoted("",
                "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 2 0 0 2 0 0 2]\n"
                "\"vector3 S\" [1 0 0 1 0 0 1 0 0]",
                {"parameter \"N\" of Shape \"trianglemesh\"", "parameter \"S\""});
    expectNoted("", "Shape \"sphere\" \"float zmin\" -1 \"float zmax\" 1",
                {"parameter \"zmin\"", "parameter \"zmax\""});
}

TEST(Accepted, EachIsNotedOnce) {
    expectNoted("", "Shape \"sphere\" \"float alpha\" 1 Shape \"sphere\" \"float alpha\" 1", {"parameter \"alpha\""});
}

TEST(Accepted, WhatWouldChangeThePictureIsNot) {
    const std::pair<std::string, std::string> kWrong[] = {
        {"Film \"image\" \"float scale\" 2", "is 2; supported: it would scale the picture"},
        {"Film \"rgb\" \"float iso\" 200", "it would scale the picture"},
        {"Film \"image\" \"float maxsampleluminance\" 10", "at least 100000"},
        {"Film \"rgb\" \"string sensor\" \"canon_eos_5d\"", "unknown sensor"},
        {"Sampler \"halton\" \"bool samplepixelcenter\" true", "supported: false"},
        {"Camera \"perspective\" \"float lensradius\" .1", "supported: 0, a pinhole"},
        {"ColorSpace \"rec2020\"", "unknown colour space"},
        {"Option \"bool forcediffuse\" true", "supported: false"},
        {"WorldBegin Shape \"disk\" \"float alpha\" .5", "supported: 1, opaque"},
        {"WorldBegin Shape \"disk\" \"float phimax\" 180", "whole disks"},
        {"WorldBegin Shape \"sphere\" \"float zmin\" -.5", "whole spheres"},
        {"WorldBegin Texture \"t\" \"color\" \"checkerboard\" \"integer dimension\" 3", "supported: 2"},
        {"WorldBegin Texture \"t\" \"color\" \"checkerboard\" \"float udelta\" .5", "supported: 0"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"string filename\" \"a\" \"bool gamma\" false",
         "supported: true"},
        {"WorldBegin Texture \"t\" \"color\" \"imagemap\" \"string filename\" \"a\" \"float uscale\" 2",
         "supported: 1"},
        {"WorldBegin ReverseOrientation AreaLightSource \"diffuse\" Shape \"disk\"", "turns the side"},
        {"WorldBegin Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 1 0 0 1 0 1 1]",
         "the normal of point 2 is not that of triangle 0"},
    };
    for (const auto& [text, says] : kWrong) EXPECT_NE(errorOf(text).find(says), std::string::npos) << errorOf(text);
}

TEST(Accepted, DepthsBeyondTheGreatestAreCut) {
    const Scene scene = parseParts("Integrator \"volpath\" \"integer maxdepth\" 100");
    EXPECT_EQ(scene.integrator.max_depth, 64);
    ASSERT_EQ(scene.notices.size(), 1u);
    EXPECT_EQ(scene.notices[0].text, "test.pbrt:1:22: maxdepth 100 counts as 64, the greatest one");
}

TEST(Accepted, NumbersOfTheOtherKind) {
    const Scene scene = parseParts(
        "Camera \"perspective\" \"integer fov\" 45 Sampler \"a\" \"float pixelsamples\" 8\n"
        "Film \"rgb\" \"integer xresolution\" 64.0");
    EXPECT_EQ(scene.camera.fov_degrees, 45.0);
    EXPECT_EQ(scene.sampler.pixel_samples, 8);
    EXPECT_EQ(scene.film.width, 64);
    EXPECT_NE(errorOf("Sampler \"a\" \"float pixelsamples\" 8.5").find("expected an integer"), std::string::npos);
}

TEST(Accepted, ByteOrderMarkAndCarriageReturns) {
    const Scene scene = parse("\xef\xbb\xbfWorldBegin\r\n# comment\r\nShape \"sphere\"\r\n");
    EXPECT_EQ(scene.shapes[0].where.text(), "test.pbrt:3:1");
    EXPECT_EQ(errorOf("\xef\xbb\xbfWorldBegn"), errorOf("WorldBegn"));
}

TEST(Accepted, NamedCoordinateSystems) {
    const Scene scene = parse(
        "Translate 0 0 5 Camera \"perspective\" WorldBegin\n"
        "Translate 1 2 3 CoordinateSystem \"there\" Identity CoordSysTransform \"there\" Shape \"sphere\"\n"
        "CoordSysTransform \"camera\" Shape \"sphere\" CoordSysTransform \"world\" Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].world_from_object[3], dvec4(1, 2, 3, 1));
    EXPECT_EQ(scene.shapes[1].world_from_object[3], dvec4(0, 0, -5, 1));
    EXPECT_EQ(scene.shapes[2].world_from_object, dmat4(1.0));
    EXPECT_NE(errorOf("WorldBegin CoordSysTransform \"x\" Shape \"disk\"").find("undefined coordinate system"),
              std::string::npos);
}

TEST(Accepted, AttributeGivesParametersToWhatFollows) {
    const Scene scene = parse(
        "WorldBegin Attribute \"shape\" \"float radius\" 2 \"float alpha\" 1 \"string unknown\" \"x\"\n"
        "Attribute \"material\" \"rgb reflectance\" [.1 .2 .3] Attribute \"light\" \"float scale\" 3\n"
        "LightSource \"point\" Shape \"sphere\" Shape \"sphere\" \"float radius\" 5\n"
        "AttributeBegin Attribute \"shape\" \"float radius\" 7 Shape \"disk\" AttributeEnd\n"
        "Material \"diffuse\" Shape \"disk\"");
    const auto sphere = [&](int i) { return std::get<Sphere>(scene.shapes[std::size_t(i)].geometry).radius; };
    const auto disk = [&](int i) { return std::get<Disk>(scene.shapes[std::size_t(i)].geometry).radius; };
    EXPECT_EQ(std::get<PointLight>(scene.lights[0]).intensity, dvec3(3.0));
    EXPECT_EQ(sphere(0), 2.0);
    EXPECT_EQ(sphere(1), 5.0) << "what the directive says itself goes first";
    EXPECT_EQ(disk(2), 7.0);
    EXPECT_EQ(disk(3), 2.0);
    EXPECT_EQ(scene.shapes[3].material, Material(Matte{ConstantColour{dvec3(.1, .2, .3)}}));
    EXPECT_NE(errorOf("Attribute \"spoon\" \"float a\" 1").find("unknown target \"spoon\""), std::string::npos);
    EXPECT_NE(errorOf("WorldBegin Attribute \"shape\" \"float radius\" -2 Shape \"sphere\"").find("\"radius\" is -2"),
              std::string::npos);
}

TEST(Accepted, ATransformAfterTheCameraIsWarnedOf) {
    const auto warnings = [](const std::string& options) {
        std::vector<std::string> texts;
        for (const Notice& notice : parseParts(options).notices)
            if (notice.kind == Notice::Kind::Warning) texts.push_back(notice.text);
        return texts;
    };
    const std::vector<std::string> late = warnings("Camera \"perspective\"\nLookAt 0 1 3 0 0 0 0 1 0 Scale 1 1 2");
    ASSERT_EQ(late.size(), 1u);
    EXPECT_EQ(
        late[0],
        "test.pbrt:2:1: LookAt stands after Camera (at test.pbrt:1:1) and does not move it: the camera looks from "
        "the origin along +z");
    EXPECT_TRUE(warnings("LookAt 0 1 3 0 0 0 0 1 0 Camera \"perspective\" Translate 1 2 3").empty());
}

TEST(Accepted, BilinearMeshesOfFlatQuads) {
    const std::string quad = "Shape \"bilinearmesh\" \"point3 P\" [0 0 0  2 0 0  0 1 0  2 1 0]";
    const auto mesh = std::get<TriangleMesh>(parseParts("", quad).shapes[0].geometry);
    EXPECT_EQ(mesh.points, (std::vector<dvec3>{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_EQ(mesh.uvs, (std::vector<dvec2>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
    const Scene two = parseParts("",
                                 "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0]\n"
                                 "\"integer indices\" [0 1 2 3 2 3 4 5]");
    EXPECT_EQ(std::get<TriangleMesh>(two.shapes[0].geometry).triangles.size(), 4u);
    const auto wrong = [](const std::string& points, const std::string& before = "") {
        return errorOf("WorldBegin " + before + "Shape \"bilinearmesh\" \"point3 P\" [" + points + "]");
    };
    EXPECT_NE(wrong("0 0 0 1 0 0 0 1 0 1 1 1").find("patch 0 of the mesh, counted from 0, is curved"),
              std::string::npos);
    EXPECT_NE(wrong("0 0 0 1 0 0 0 1 0 .2 .2 0").find("is not convex"), std::string::npos);
    EXPECT_NE(wrong("0 0 0 1 0 0 1 1 0 0 1 0").find("is not convex"), std::string::npos) << "a bow tie";
    EXPECT_NE(wrong("0 0 0 1 0 0 0 1 0 2 2 0",
                    "Texture \"c\" \"color\" \"checkerboard\" Material \"matte\" \"texture "
                    "Kd\" \"c\" ")
                  .find("no parallelogram"),
              std::string::npos);
    EXPECT_EQ(parseParts("", "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 2 2 0]").shapes.size(), 2u);
}

TEST(Accepted, ImagesHaveALongitudeOriginOfTheirOwn) {
    const Scene scene =
        parseParts("",
                   "Texture \"a\" \"color\" \"imagemap\" \"string filename\" \"a\" \"float lonorigin\" 0\n"
                   "Texture \"b\" \"color\" \"imagemap\" \"string filename\" \"a\"\n"
                   "Material \"matte\" \"texture Kd\" \"a\" Shape \"displacedsphere\"\n"
                   "Material \"matte\" \"texture Kd\" \"b\" Shape \"displacedsphere\" \"float lonorigin\" 0");
    EXPECT_EQ(textureAs<ImageMap>(scene.shapes[0].material)->longitude_origin, 0.0);
    EXPECT_EQ(textureAs<ImageMap>(scene.shapes[1].material)->longitude_origin, -180.0);
    EXPECT_NE(errorOf("WorldBegin Texture \"a\" \"color\" \"imagemap\" \"float lonorigin\" 400").find("in [-360, 360]"),
              std::string::npos);
}

}  // namespace
}  // namespace dsphere
