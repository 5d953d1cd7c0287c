#include "verify/testscenes.h"

#include "image/generate.h"
#include "scene/parser.h"

#include <array>

namespace dsphere::verify {

namespace {

struct Description {
    const char* name;
    const char* text;  ///< after the film and before nothing else: camera, options and world
};

// The maps and images are named by what they hold: see madeMap and madeImage.
constexpr std::array kDescriptions = {
    Description{"bilinear, 10,000 R away", R"(
LookAt 6000 5000 6200  0 0 0  0 1 0  Camera "perspective" "float fov" .013
WorldBegin
LightSource "distant" "point3 from" [1 1 .3] "point3 to" [0 0 0]
Texture "h" "color" "heightramp" "string ramp" "viridis"  Material "matte" "texture Kd" "h"
Shape "displacedsphere" "string displacementmap" "fractal" "float maxdispl" 10
)"},
    Description{"needles, near the ground", R"(
LookAt 0 .5 1.35  .5 .6 -.4  0 1 0  Camera "perspective" "float fov" 60
WorldBegin
LightSource "distant" "point3 from" [1 .8 -.2] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementmap" "spikes" "float maxdispl" 40
)"},
    Description{"checkerboard map over a pole", R"(
LookAt .3 2.4 .2  0 0 0  0 0 1  Camera "perspective" "float fov" 50
WorldBegin
LightSource "point" "point3 from" [1.5 1.5 1] "rgb I" [5 5 4]  LightSource "distant" "point3 from" [-1 1 .3] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementmap" "checkerboard" "float maxdispl" 15
)"},
    Description{"B-spline", R"(
LookAt .5 1 2.4  0 0 0  0 1 0  Camera "perspective" "float fov" 52
WorldBegin
LightSource "distant" "point3 from" [1 .6 .4] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementmap" "fractal" "string filter" "bspline" "float maxdispl" 20
)"},
    Description{"ripples", R"(
LookAt .5 1 2.4  0 0 0  0 1 0  Camera "perspective" "float fov" 52
WorldBegin
LightSource "distant" "point3 from" [1 .6 .4] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementfunction" "ripples" "float maxdispl" 12 "float midlevel" .5
)"},
    Description{"bilinear with smooth normals", R"(
LookAt .5 1 2.4  0 0 0  0 1 0  Camera "perspective" "float fov" 52
WorldBegin
LightSource "distant" "point3 from" [1 .6 .4] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementmap" "fractal" "bool smoothnormals" true "float maxdispl" 15
)"},
    Description{"three surfaces under a lamp", R"(
LookAt .4 2.3 8.2  0 -.15 0  0 1 0  Camera "perspective" "float fov" 30
PixelFilter "gaussian"  Integrator "path" "integer maxdepth" 4 "bool regularize" true
WorldBegin
LightSource "infinite" "rgb L" [.11 .13 .17]
AttributeBegin Translate -3.2 5.2 2.6 AreaLightSource "diffuse" "rgb L" [34 31 26]
  Material "matte" "rgb Kd" [0 0 0] Shape "sphere" "float radius" .8 AttributeEnd
AttributeBegin Texture "squares" "color" "checkerboard" "float uscale" 40 "float vscale" 40 "rgb tex1" [.6 .6 .6] "rgb tex2" [.4 .4 .4]
  Material "matte" "texture Kd" "squares" Shape "trianglemesh" "integer indices" [0 1 2  0 2 3]
  "point3 P" [-20 -1.12 20  20 -1.12 20  20 -1.12 -20  -20 -1.12 -20] "point2 uv" [0 0  1 0  1 1  0 1] AttributeEnd
AttributeBegin Translate -2.25 0 .1 Material "matte" "rgb Kd" [.52 .51 .49] "float sigma" 25
  Shape "displacedsphere" "string displacementmap" "moon" "float maxdispl" 5 AttributeEnd
AttributeBegin Translate .05 0 -.6 Material "plastic" "rgb Kd" [.3 .5 .2] "rgb Ks" [.35 .35 .35] "float roughness" .05
  Shape "displacedsphere" "string displacementmap" "fractal" "string filter" "bspline" "float radius" .92 "float maxdispl" 20 AttributeEnd
AttributeBegin Translate 2.25 0 .2 Material "conductor" "spectrum eta" "metal-Cu-eta" "spectrum k" "metal-Cu-k" "float roughness" .03
  Shape "displacedsphere" "string displacementfunction" "ripples" "float radius" .95 "float maxdispl" 12 "float midlevel" .5 AttributeEnd
)"},
    Description{"images, mirror and panel", R"(
LookAt 1.2 1.4 4.2  .1 -.2 0  0 1 0  Camera "perspective" "float fov" 50
Integrator "path" "integer maxdepth" 3
WorldBegin
AttributeBegin Rotate -80 1 0 0 LightSource "infinite" "string mapname" "sky" AttributeEnd
AttributeBegin Translate -1.2 2.2 .9 Rotate 110 1 .4 0 AreaLightSource "diffuse" "rgb L" [9 8 6] "bool twosided" true
  Material "matte" "rgb Kd" [0 0 0] Shape "disk" "float height" .05 "float radius" .9 "float innerradius" .3 AttributeEnd
Texture "colours" "color" "imagemap" "string filename" "colours"
AttributeBegin Material "matte" "texture Kd" "colours" Shape "displacedsphere" "string displacementmap" "fractal" "float maxdispl" 15 AttributeEnd
AttributeBegin Translate 1.6 -.3 .7 Material "mirror" "rgb Kr" [.9 .8 .7] Shape "sphere" "float radius" .5 AttributeEnd
AttributeBegin Translate -1.5 .2 .3 Rotate 40 1 .5 0 Material "matte" "texture Kd" "colours" Shape "disk" "float radius" .8 AttributeEnd
)"},
    Description{"six planets and a disk, orthographic", R"(
LookAt .5 1.4 6  0 0 0  0 1 0  Camera "orthographic" "float screenwindow" [-3 3 -2.25 2.25]
WorldBegin
LightSource "distant" "point3 from" [1 .7 .6] "point3 to" [0 0 0]  LightSource "point" "point3 from" [0 2 2] "rgb I" [6 6 6]
AttributeBegin Translate -1.7 .8 0 Shape "displacedsphere" "string displacementmap" "fractal" "float radius" .7 "float maxdispl" 10 AttributeEnd
AttributeBegin Translate 0 .8 .5 Scale 1 .7 1 Shape "displacedsphere" "string displacementmap" "moon" "float radius" .7 "float maxdispl" 8 AttributeEnd
AttributeBegin Translate 1.7 .8 0 Shape "displacedsphere" "string displacementmap" "spikes" "float radius" .7 "float maxdispl" 20 AttributeEnd
AttributeBegin Translate -1.7 -.9 0 Shape "displacedsphere" "string displacementmap" "fractal" "float radius" .6 "float maxdispl" -10 AttributeEnd
AttributeBegin Translate 0 -.9 .5 Shape "displacedsphere" "string displacementmap" "checkerboard" "float radius" .6 "float maxdispl" 5 AttributeEnd
AttributeBegin Translate 1.7 -.9 0 Shape "displacedsphere" "string displacementmap" "moon" "float radius" .6 "float maxdispl" 12 AttributeEnd
AttributeBegin Rotate 80 1 0 0 Shape "disk" "float radius" 1 "float innerradius" .4 AttributeEnd
)"},
};

RawMap madeMap(const std::string& name) {
    const MapKind kind = name == "spikes"         ? MapKind::Spikes
                         : name == "checkerboard" ? MapKind::Checkerboard
                         : name == "moon"         ? MapKind::Moon
                                                  : MapKind::Fractal;
    const MapGenerator generator(kind, 256, 128, 1);
    RawMap map;
    map.width = generator.width();
    map.height = generator.height();
    map.full_scale = 65535.0;
    map.type = "made in memory";
    std::vector<std::uint16_t> row(std::size_t(map.width));
    for (int j = 0; j < map.height; ++j) {
        generator.fillRow(j, row);
        map.samples.insert(map.samples.end(), row.begin(), row.end());
    }
    return map;
}

// `sky`: light in floats, bright and dark by places, one texel a sun. Else 8-bit codes of all colours.
RawColour madeImage(const std::string& name) {
    RawColour image;
    image.width = 32;
    image.height = 16;
    image.type = "made in memory";
    for (int j = 0; j < image.height; ++j)
        for (int i = 0; i < image.width; ++i)
            for (int c = 0; c < 3; ++c)
                if (name == "sky")
                    image.linear.push_back(
                        i == 9 && j == 4 ? 15.0f : (1.0f + 0.1f * float(c)) * 0.05f * float((i * 7 + j * 5) % 11));
                else
                    image.srgb.push_back(std::uint8_t((i * 37 + j * 91 + c * 53) % 256));
    return image;
}

int addImage(SceneMaps& maps, const std::string& path) {
    maps.images.push_back(std::make_unique<ColourMap>(madeImage(path), path));
    return int(maps.images.size()) - 1;
}

// As loadSceneMaps, each map anew.
SceneMaps madeMaps(const Scene& scene) {
    SceneMaps maps;
    for (const Shape& shape : scene.shapes) {
        maps.map_of_shape.push_back(-1);
        maps.reliefs.push_back({});
        const auto* image = textureAs<ImageMap>(shape.material);
        maps.image_of_shape.push_back(image ? addImage(maps, image->path) : -1);
        const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) continue;
        maps.maps.push_back(std::make_unique<Heightmap>(
            sphere->ripples ? loadHeightmap(*sphere) : makeHeightmap(madeMap(sphere->map_path), *sphere)));
        maps.map_of_shape.back() = int(maps.maps.size()) - 1;
        maps.reliefs.back() = makeRelief(*sphere, *maps.maps.back(), shape.where);
    }
    for (const Light& light : scene.lights)
        if (const auto* sky = std::get_if<InfiniteLight>(&light); sky && !sky->map_path.empty())
            maps.light_image = addImage(maps, sky->map_path);
    return maps;
}

}  // namespace

int testSceneCount() {
    return int(kDescriptions.size());
}

TestScene makeTestScene(int i) {
    const Description& description = kDescriptions[std::size_t(i)];
    TestScene made;
    made.scene = parseScene(
        std::string("Film \"rgb\" \"integer xresolution\" 96 \"integer yresolution\" 72\n") + description.text,
        description.name, "");
    made.maps = madeMaps(made.scene);
    return made;
}

}  // namespace dsphere::verify
