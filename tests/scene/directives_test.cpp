// Every directive with its parameters, every default, and the two spellings of pbrt.

#include "tests/scene/support.h"

namespace dsphere {
namespace {

template <typename Geometry>
Geometry onlyGeometry(const std::string& shape) {
    Scene scene = parse("WorldBegin " + shape);
    EXPECT_EQ(scene.shapes.size(), 1u);
    return std::get<Geometry>(scene.shapes.at(0).geometry);
}

dvec3 sphereColour(const std::string& world) {
    Scene scene = parseParts("", world);
    return textureAs<ConstantColour>(scene.shapes.back().material)->rgb;
}

TEST(Directives, DefaultsOfAnEmptyScene) {
    Scene scene = parse("WorldBegin Shape \"sphere\"");
    EXPECT_EQ(scene.name, "test.pbrt");
    EXPECT_EQ(scene.camera, Camera{});
    EXPECT_EQ(scene.camera.fov_degrees, 90.0);
    EXPECT_EQ(scene.film, (Film{"dsphere.exr", 1280, 720, {0.0, 1.0, 0.0, 1.0}}));
    EXPECT_EQ(scene.sampler, (Sampler{16, 0}));
    EXPECT_EQ(scene.integrator, (Integrator{Integrator::Kind::Path, 5}));
    EXPECT_EQ(scene.pixel_filter, (PixelFilter{PixelFilter::Kind::Box, dvec2(0.5)}));
    EXPECT_TRUE(scene.lights.empty());
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].geometry).radius, 1.0);
    EXPECT_EQ(scene.shapes[0].world_from_object, dmat4(1.0));
    EXPECT_EQ(scene.shapes[0].material, Material{Matte{ConstantColour{dvec3(0.5)}}});
    EXPECT_EQ(scene.shapes[0].where.text(), "test.pbrt:1:12");
}

TEST(Directives, DefaultsOfNamedDirectivesAreTheSame) {
    Scene scene =
        parseParts("Camera \"perspective\" Film \"image\" Sampler \"random\" Integrator \"path\" PixelFilter \"box\"",
                   "Material \"matte\"");
    expectSame(scene, parseParts(""));
}

TEST(Directives, Camera) {
    Camera camera = parseParts("Camera \"perspective\" \"float fov\" [30.5] \"float screenwindow\" [-2 2 -1 1]").camera;
    EXPECT_EQ(camera.fov_degrees, 30.5);
    EXPECT_EQ(camera.screen_window, (std::array{-2.0, 2.0, -1.0, 1.0}));
    EXPECT_FALSE(camera.frame_aspect_ratio);
    EXPECT_EQ(parseParts("Camera \"perspective\" \"float frameaspectratio\" 2").camera.frame_aspect_ratio, 2.0);
}

TEST(Directives, FilmOfEveryName) {
    for (std::string name : {"image", "rgb", "gbuffer"}) {
        Film film =
            parseParts("Film \"" + name +
                       "\" \"string filename\" \"out/x.png\" \"integer xresolution\" 1 \"integer yresolution\" 1048576"
                       " \"float cropwindow\" [0 1 .25 .75]")
                .film;
        EXPECT_EQ(film, (Film{"out/x.png", 1, 1048576, {0.0, 1.0, 0.25, 0.75}})) << name;
    }
}

TEST(Directives, SamplerOfAnyName) {
    for (std::string name : {"halton", "zsobol", "stratified", "independent"}) {
        Sampler sampler = parseParts("Sampler \"" + name + "\" \"integer pixelsamples\" 64 \"integer seed\" 5").sampler;
        EXPECT_EQ(sampler, (Sampler{64, 5})) << name;
    }
}

TEST(Directives, Integrators) {
    using Kind = Integrator::Kind;
    EXPECT_EQ(parseParts("Integrator \"directlighting\"").integrator, (Integrator{Kind::DirectLighting, 5}));
    EXPECT_EQ(parseParts("Integrator \"path\" \"integer maxdepth\" 0").integrator, (Integrator{Kind::Path, 0}));
    EXPECT_EQ(parseParts("Integrator \"volpath\" \"integer maxdepth\" 9").integrator, (Integrator{Kind::Path, 9}));
    EXPECT_EQ(parseParts("Integrator \"path\" \"bool regularize\" true").integrator,
              (Integrator{Kind::Path, 5, 0.0, true}));
}

TEST(Directives, PixelFiltersInBothSpellings) {
    auto filter = [](const std::string& words) { return parseParts("PixelFilter " + words).pixel_filter; };
    using Kind = PixelFilter::Kind;
    EXPECT_EQ(filter("\"box\""), (PixelFilter{Kind::Box, dvec2(0.5)}));
    EXPECT_EQ(filter("\"box\" \"float xwidth\" 1"), (PixelFilter{Kind::Box, dvec2(1.0, 0.5)}));
    EXPECT_EQ(filter("\"box\" \"float yradius\" 8"), (PixelFilter{Kind::Box, dvec2(0.5, 8.0)}));
    EXPECT_EQ(filter("\"gaussian\""), (PixelFilter{Kind::Gaussian, dvec2(1.5), 2.0})) << "v4's";
    EXPECT_EQ(filter("\"gaussian\" \"float alpha\" 2"), (PixelFilter{Kind::Gaussian, dvec2(2.0), 2.0})) << "v3's";
    EXPECT_EQ(filter("\"gaussian\" \"float ywidth\" 3 \"float alpha\" .5"),
              (PixelFilter{Kind::Gaussian, dvec2(2.0, 3.0), 0.5}));
    EXPECT_EQ(filter("\"gaussian\" \"float xradius\" 3 \"float sigma\" 1"),
              (PixelFilter{Kind::Gaussian, dvec2(3.0, 1.5), 0.5}));
}

TEST(Directives, MaterialColours) {
    EXPECT_EQ(sphereColour("Material \"matte\" \"rgb Kd\" [.1 .2 .3]"), dvec3(.1, .2, .3));
    EXPECT_EQ(sphereColour("Material \"diffuse\" \"color reflectance\" [0 1 .5]"), dvec3(0, 1, .5));
    EXPECT_EQ(sphereColour("Material \"diffuse\" \"rgb Kd\" [.1 .2 .3]"), dvec3(.1, .2, .3));
    EXPECT_EQ(sphereColour("Material \"matte\" \"rgb reflectance\" [.1 .2 .3]"), dvec3(.1, .2, .3));
    EXPECT_EQ(sphereColour("Material \"matte\" \"float sigma\" 0"), dvec3(0.5));
}

TEST(Directives, Textures) {
    EXPECT_EQ(sphereColour("Texture \"t\" \"color\" \"constant\" Material \"matte\" \"texture Kd\" \"t\""), dvec3(1.0));
    EXPECT_EQ(sphereColour("Texture \"t\" \"spectrum\" \"constant\" \"color value\" [.1 .2 .3] "
                           "Material \"diffuse\" \"texture reflectance\" [\"t\"]"),
              dvec3(.1, .2, .3));
    for (std::string ramp : {"terrain", "viridis", "geoid", "grey"}) {
        Scene scene = parse("WorldBegin Texture \"h\" \"spectrum\" \"heightramp\" \"string ramp\" \"" + ramp +
                            "\" Material \"matte\" \"texture Kd\" \"h\" Shape \"displacedsphere\"");
        EXPECT_EQ(scene.shapes[0].material, Material{Matte{HeightRamp{.ramp = ramp}}});
    }
    Scene scene = parse(
        "WorldBegin Texture \"h\" \"color\" \"heightramp\" Material \"matte\" \"texture Kd\" \"h\" "
        "Shape \"displacedsphere\"");
    EXPECT_EQ(scene.shapes[0].material, Material{Matte{HeightRamp{.ramp = "terrain"}}});
}

TEST(Directives, ImageMaps) {
    const auto texture = [](const std::string& parameters) {
        Scene scene = parse("WorldBegin Texture \"t\" \"spectrum\" \"imagemap\" " + parameters +
                            " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"");
        return *textureAs<ImageMap>(scene.shapes[0].material);
    };
    EXPECT_EQ(texture("\"string filename\" \"a.png\""), (ImageMap{"folder/a.png", dvec3(1.0), -180.0, {}}));
    EXPECT_EQ(texture("\"string filename\" \"a.png\"").where.text(), "test.pbrt:1:64");
    EXPECT_EQ(texture("\"string filename\" \"/b.jpg\" \"float scale\" 2.5 \"string wrap\" \"repeat\""),
              (ImageMap{"/b.jpg", dvec3(2.5), -180.0, {}}));
}

TEST(Directives, NamedMaterials) {
    Scene scene = parse(R"(WorldBegin
        MakeNamedMaterial "red" "string type" "matte" "rgb Kd" [1 0 0]
        MakeNamedMaterial "blue" "rgb reflectance" [0 0 1] "string type" "diffuse"
        Shape "sphere" NamedMaterial "red" Shape "sphere"
        AttributeBegin NamedMaterial "blue" Shape "sphere" AttributeEnd Shape "sphere")");
    ASSERT_EQ(scene.shapes.size(), 4u);
    EXPECT_EQ(scene.shapes[0].material, Material{Matte{}});
    EXPECT_EQ(scene.shapes[1].material, Material{Matte{ConstantColour{dvec3(1, 0, 0)}}});
    EXPECT_EQ(scene.shapes[2].material, Material{Matte{ConstantColour{dvec3(0, 0, 1)}}});
    EXPECT_EQ(scene.shapes[3].material, scene.shapes[1].material) << "AttributeEnd restores the material";
}

TEST(Directives, DistantLight) {
    EXPECT_EQ(onlyLight<DistantLight>("LightSource \"distant\""), (DistantLight{dvec3(0, 0, -1), dvec3(1.0)}));
    auto light = onlyLight<DistantLight>(
        "LightSource \"distant\" \"rgb L\" [1 2 3] \"float scale\" 2 "
        "\"point from\" [0 7 1] \"point3 to\" [0 2 1]");
    EXPECT_EQ(light, (DistantLight{dvec3(0, 1, 0), dvec3(2, 4, 6)}));
    light = onlyLight<DistantLight>(
        "Translate 1 2 3 Rotate 90 0 0 1 LightSource \"distant\" \"point from\" [2 0 0] "
        "\"point to\" [0 0 0]");
    expectNear(light.direction, dvec3(0, 1, 0));
}

TEST(Directives, PointLight) {
    EXPECT_EQ(onlyLight<PointLight>("LightSource \"point\""), (PointLight{dvec3(0.0), dvec3(1.0)}));
    EXPECT_EQ(onlyLight<PointLight>("Translate 0 1 0 Scale 2 2 2 LightSource \"point\" \"color I\" [4 5 6] "
                                    "\"color scale\" [1 .5 0] \"point from\" [1 2 3]"),
              (PointLight{dvec3(2, 5, 6), dvec3(4, 2.5, 0)}));
}

TEST(Directives, DisplacedSphere) {
    EXPECT_EQ(onlyGeometry<DisplacedSphere>("Shape \"displacedsphere\""), DisplacedSphere{});
    auto sphere = onlyGeometry<DisplacedSphere>(R"(Shape "displacedsphere" "float radius" 2 "float maxdispl" -5
        "string displacementmap" "maps/moon.png" "float midlevel" .5 "string filter" "bilinear"
        "string registration" "texel" "float lonorigin" 0 "float heightmin" -1 "float heightmax" 9)");
    DisplacedSphere expected;
    expected.radius = 2;
    expected.max_displacement = -5;
    expected.map_path = "folder/maps/moon.png";
    expected.midlevel = 0.5;
    expected.registration = Registration::Texel;
    expected.longitude_origin = 0.0;
    expected.height_min = -1.0;
    expected.height_max = 9.0;
    EXPECT_EQ(sphere, expected);
}

TEST(Directives, SmoothDisplacedSpheres) {
    auto read = [](const char* parameters) {
        return onlyGeometry<DisplacedSphere>(std::string("Shape \"displacedsphere\" ") + parameters);
    };
    EXPECT_EQ(read("\"string filter\" \"bspline\"").filter, Filter::BSpline);
    EXPECT_EQ(read("\"string displacementfunction\" \"ripples\"").ripples, (Ripples{12, 12}));
    EXPECT_EQ(
        read("\"integer vfrequency\" 512 \"string displacementfunction\" \"ripples\" \"integer ufrequency\" 1").ripples,
        (Ripples{1, 512}));
    EXPECT_FALSE(read("").ripples);
    for (const char* spelling : {"true", "\"true\"", "[true]"})
        EXPECT_TRUE(read((std::string("\"bool smoothnormals\" ") + spelling).c_str()).smooth_normals) << spelling;
    EXPECT_FALSE(read("\"bool smoothnormals\" false").smooth_normals);
}

TEST(Directives, DisplacedSphereInTrueScale) {
    auto sphere = onlyGeometry<DisplacedSphere>(R"(Shape "displacedsphere" "float radius" 6371000
        "string displacementmap" "/maps/geoid.gtx" "string registration" "gridline" "float heightscale" 1e4)");
    EXPECT_EQ(sphere.map_path, "/maps/geoid.gtx");
    EXPECT_EQ(sphere.registration, Registration::Gridline);
    EXPECT_EQ(sphere.height_scale, 1e4);
    EXPECT_FALSE(sphere.height_min || sphere.height_max || sphere.longitude_origin);
}

TEST(Directives, BlurAndNodata) {
    auto with = [](const std::string& parameters) {
        return onlyGeometry<DisplacedSphere>("Shape \"displacedsphere\" " + parameters);
    };
    EXPECT_EQ(with("").blur, 0.0);
    EXPECT_FALSE(with("").nodata);
    EXPECT_EQ(with("\"float blur\" 1000").blur, 1000.0);
    EXPECT_EQ(with("\"float nodata\" [-9999]").nodata, -9999.0);
    EXPECT_EQ(with("\"float nodata\" -3.4028235e38").nodata, -3.4028235e38);
    for (std::string nan : {"nan", "NaN", "NAN", "[nan]"}) {
        auto nodata = with("\"float nodata\" " + nan).nodata;
        EXPECT_TRUE(nodata && std::isnan(*nodata)) << nan;
    }
}

TEST(Directives, SphereAndDisk) {
    EXPECT_EQ(onlyGeometry<Sphere>("Shape \"sphere\" \"float radius\" 1e-3").radius, 1e-3);
    EXPECT_EQ(onlyGeometry<Disk>("Shape \"disk\""), (Disk{0.0, 1.0, 0.0}));
    EXPECT_EQ(onlyGeometry<Disk>("Shape \"disk\" \"float height\" -2 \"float radius\" 5 \"float innerradius\" 1"),
              (Disk{-2.0, 5.0, 1.0}));
}

TEST(Directives, NumbersAndWordsInEverySpelling) {
    auto radius = [](const std::string& value) {
        return onlyGeometry<Sphere>("Shape \"sphere\" \"float radius\" " + value).radius;
    };
    EXPECT_EQ(radius("+2"), 2.0);
    EXPECT_EQ(radius(".5"), 0.5);
    EXPECT_EQ(radius("[ 2. ]"), 2.0);
    EXPECT_EQ(radius("1E+2"), 100.0);
    EXPECT_EQ(radius("[3]#comment"), 3.0);
    EXPECT_EQ(onlyGeometry<Sphere>("Shape\"sphere\"\"  float   radius \"4").radius, 4.0);
    EXPECT_EQ(parse("WorldBegin\r\nShape \"sphere\"\r\n").shapes[0].where.text(), "test.pbrt:2:1");
    EXPECT_EQ(parse(kFullScene).film.filename, "a\\b\"c.exr");
}

}  // namespace
}  // namespace dsphere
