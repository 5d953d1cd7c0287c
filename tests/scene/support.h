#pragma once

#include "base/error.h"
#include "scene/parser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace dsphere {

inline Scene parse(const std::string& text) {
    return parseScene(text, "test.pbrt", "folder");
}

/// The message of the InvalidInput error that `text` must cause.
inline std::string errorOf(const std::string& text) {
    try {
        parse(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::InvalidInput) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "accepted:\n" << text;
    return "";
}

/// Everything but names and places.
inline void expectSame(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.film, b.film);
    EXPECT_EQ(a.sampler, b.sampler);
    EXPECT_EQ(a.integrator, b.integrator);
    EXPECT_EQ(a.pixel_filter, b.pixel_filter);
    EXPECT_EQ(a.lights, b.lights);
    ASSERT_EQ(a.shapes.size(), b.shapes.size());
    for (std::size_t i = 0; i < a.shapes.size(); ++i) {
        EXPECT_EQ(a.shapes[i].geometry, b.shapes[i].geometry) << "shape " << i;
        EXPECT_EQ(a.shapes[i].world_from_object, b.shapes[i].world_from_object) << "shape " << i;
        EXPECT_EQ(a.shapes[i].material, b.shapes[i].material) << "shape " << i;
    }
}

/// A scene whose only special parts are `options` and `world`; a sphere makes it complete.
inline Scene parseParts(const std::string& options, const std::string& world = "") {
    return parse(options + "\nWorldBegin\n" + world + "\nShape \"sphere\"\n");
}

/// The light of such a scene, of this kind.
template <typename Kind>
Kind onlyLight(const std::string& light) {
    const Scene scene = parseParts("", light);
    EXPECT_EQ(scene.lights.size(), 1u);
    return std::get<Kind>(scene.lights.at(0));
}

inline void expectNear(const dmat4& a, const dmat4& b, double tolerance = 1e-15) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(a[column][row], b[column][row], tolerance) << "row " << row << ", column " << column;
}

inline void expectNear(const dvec3& a, const dvec3& b, double tolerance = 1e-15) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

/// The matrix of these rows, as it is written on paper.
inline dmat4 rows(const dvec4& a, const dvec4& b, const dvec4& c, const dvec4& d = {0, 0, 0, 1}) {
    return glm::transpose(dmat4(a, b, c, d));
}

/// A folder of scene files that goes with the test.
class Folder {
  public:
    Folder() {
        auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::path(testing::TempDir()) / (std::string("dsphere_scene_") + test->name());
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A valid scene that uses every directive and every parameter.
inline const std::string kFullScene = R"(# a comment
Identity Scale -1 1 1
LookAt 0 0 -5  0 0 0  0 1 0
Translate 0 0 0 Rotate 10 0 1 0
Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 5 1]
ConcatTransform [1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1]
Camera "perspective" "float fov" 40 "float screenwindow" [-1 1 -.5 .5]
Film "gbuffer" "string filename" "a\\b\"c.exr" "integer xresolution" [64] "integer yresolution" 32
    "float cropwindow" [0 .5 .25 1]
Sampler "halton" "integer pixelsamples" 4 "integer seed" 7
Integrator "directlighting" "integer maxdepth" 3
PixelFilter "gaussian" "float xradius" 2 "float yradius" 1.5 "float sigma" .4
WorldBegin
Texture "heights" "spectrum" "heightramp" "string ramp" "viridis"
Texture "picture" "color" "imagemap" "string filename" "p.jpg" "float scale" 2 "string wrap" "repeat"
Texture "flat" "color" "constant" "rgb value" [.1 .2 .3]
Texture "checks" "spectrum" "checkerboard" "texture tex1" "flat" "float tex2" 0 "float uscale" 8 "float vscale" 4
Texture "dim" "color" "scale" "texture tex1" "picture" "rgb tex2" [.5 .5 .5]
Texture "dimmer" "spectrum" "scale" "texture tex" "dim" "float scale" .5
MakeNamedMaterial "ground" "string type" "diffuse" "texture reflectance" "heights" "float sigma" 20
MakeNamedMaterial "gold" "string type" "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k"
    "float uroughness" .1 "float vroughness" .1 "bool remaproughness" false
MakeNamedMaterial "paint" "string type" "plastic" "texture Kd" "checks" "rgb Ks" [.1 .1 .1] "float roughness" .3
LightSource "distant" "rgb L" [3 3 2.5] "point from" [10 5 -10] "point3 to" [0 0 0] "float scale" 2
LightSource "point" "color I" [1 2 3] "point3 from" [0 9 0] "color scale" [1 .5 .25]
LightSource "infinite" "rgb L" [.1 .2 .3] "float scale" .5 "string filename" "sky.exr"
AttributeBegin
    AreaLightSource "diffuse" "rgb L" [5 4 3] "bool twosided" true "float scale" 2
    Material "mirror" "texture Kr" "flat"
    Shape "disk"
AttributeEnd
NamedMaterial "gold"
Shape "sphere"
NamedMaterial "paint"
Shape "trianglemesh" "point3 P" [-9 0 -9 9 0 -9 9 0 9 -9 0 9] "integer indices" [0 1 2 2 3 0]
    "point2 uv" [0 0 1 0 1 1 0 1]
Material "matte" "texture Kd" "dimmer"
AttributeBegin
    NamedMaterial "ground"
    Rotate -30 0 0 1
    Shape "displacedsphere" "float radius" 1.5 "string displacementmap" "moon.png" "float maxdispl" -4
        "float midlevel" .5 "string filter" "bilinear" "string registration" "gridline"
        "float lonorigin" 0 "float heightmin" -10 "float heightmax" 100
        "float blur" 1.5 "float nodata" nan
AttributeEnd
TransformBegin
    Translate 3 0 0
    Shape "displacedsphere" "string displacementmap" "/data/moon.png" "float heightscale" 0.001
TransformEnd
Material "matte" "texture Kd" "flat"
Shape "sphere" "float radius" .25
Shape "disk" "float height" -1 "float radius" 9 "float innerradius" 2
WorldEnd
)";

}  // namespace dsphere
