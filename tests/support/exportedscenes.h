#pragma once

// Scenes in the style of exporters' files for pbrt: what they write by default, around a displaced sphere.

namespace dsphere::test {

struct ExportedScene {
    const char *name, *text;
};

inline constexpr ExportedScene kExportedScenes[] = {
    {"tungsten", R"(Integrator "path" "integer maxdepth" [ 65 ]
Transform [ 1 -0 -0 -0 -0 1 -0 -0 -0 -0 -1 -0 -0 -1 6.8 1  ]
Sampler "sobol" "integer pixelsamples" [ 4 ]
PixelFilter "triangle" "float xwidth" [ 1.000000 ] "float ywidth" [ 1.000000 ]
Film "image" "integer xresolution" [ 96 ] "integer yresolution" [ 54 ] "string filename" [ "tungsten.png" ]
Camera "perspective" "float fov" [ 19.500000 ]
WorldBegin
	MakeNamedMaterial "Floor" "string type" [ "matte" ] "rgb Kd" [ 0.725000 0.710000 0.680000 ]
	MakeNamedMaterial "Ball" "string type" [ "metal" ] "rgb eta" [ 0.2 0.92 1.1 ] "rgb k" [ 3.9 2.45 2.14 ] "float uroughness" [ 0.1 ] "float vroughness" [ 0.1 ] "bool remaproughness" [ "false" ]
	NamedMaterial "Floor"
	Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] "point P" [ -4 0 -4 -4 0 4 4 0 4 4 0 -4 ] "normal N" [ 0 1 0 0 1 0 0 1 0 0 1 0 ] "float uv" [ 0 0 1 0 1 1 0 1 ]
	NamedMaterial "Ball"
	TransformBegin
		Transform [ 0.8 0 0 0 0 0.8 0 0 0 0 0.8 0 0 0.85 0 1 ]
		Shape "displacedsphere" "string displacementfunction" [ "ripples" ] "float maxdispl" [ 4 ]
	TransformEnd
	AttributeBegin
		AreaLightSource "diffuse" "rgb L" [ 17.000000 12.000000 4.000000 ]
		Translate 0 3.5 0
		Rotate 90 1 0 0
		Shape "disk" "float radius" [ 0.7 ]
	AttributeEnd
	LightSource "infinite" "rgb L" [ 0.2 0.2 0.2 ]
WorldEnd
)"},
    {"maya", R"(# Exported
Film "image" "string filename" ["maya.exr"]
    "integer xresolution" [96] "integer yresolution" [54] "float cropwindow" [0 1 0 1]
    "float scale" [1] "float diagonal" [35] "float maxsampleluminance" [1000000]
Sampler "lowdiscrepancy" "integer pixelsamples" [4]
PixelFilter "mitchell" "float B" [0.333333] "float C" [0.333333] "float xwidth" [2] "float ywidth" [2]
Accelerator "bvh" "integer maxnodeprims" [4] "string splitmethod" ["sah"]
Integrator "directlighting" "string strategy" ["all"] "integer maxdepth" [5]
Scale -1 1 1
LookAt 0 2 5   0 0 0   0 1 0
Camera "perspective" "float fov" [37.8] "float shutteropen" [0] "float shutterclose" [1]
    "float lensradius" [0] "float focaldistance" [5] "float screenwindow" [-1.777 1.777 -1 1]
WorldBegin
AttributeBegin
    CoordinateSystem "keyLight"
    LightSource "distant" "color L" [3 3 3] "color scale" [1 1 1] "point from" [1 2 3] "point to" [0 0 0]
    LightSource "point" "color I" [2 2 2] "point from" [3 1 2] "integer nsamples" [1]
AttributeEnd
AttributeBegin
    ReverseOrientation
    Texture "checks" "color" "checkerboard" "integer dimension" [2] "string mapping" ["uv"]
        "float uscale" [16] "float vscale" [8] "float udelta" [0] "float vdelta" [0] "string aamode" ["closedform"]
        "color tex1" [.8 .8 .8] "color tex2" [.1 .1 .3]
    Material "plastic" "texture Kd" ["checks"] "color Ks" [.2 .2 .2] "float roughness" [.1]
    Shape "displacedsphere" "string displacementfunction" ["ripples"] "float maxdispl" [3] "float alpha" [1]
        "float shadowalpha" [1]
AttributeEnd
WorldEnd
)"},
    {"blender", R"(Option "string rendercoordsys" "cameraworld"
ColorSpace "srgb"
Film "rgb"
    "string filename" [ "blender.exr" ]
    "integer xresolution" [ 96 ]
    "integer yresolution" [ 54 ]
    "string sensor" [ "cie1931" ]
    "float iso" [ 100 ]
    "bool savefp16" [ true ]
PixelFilter "gaussian" "float xradius" [ 1.5 ] "float yradius" [ 1.5 ] "float sigma" [ 0.5 ]
Sampler "zsobol" "integer pixelsamples" [ 4 ] "integer seed" [ 0 ] "string randomization" [ "fastowen" ]
Integrator "volpath" "integer maxdepth" [ 5 ] "bool regularize" [ false ] "string lightsampler" [ "bvh" ]
Accelerator "bvh"
Scale -1 1 1
LookAt 0 2 5  0 0 0  0 1 0
Camera "perspective" "float fov" [ 40 ] "float lensradius" [ 0 ] "float focaldistance" [ 10 ]
WorldBegin
MediumInterface "" ""
AttributeBegin
    Rotate -90 1 0 0
    LightSource "infinite" "rgb L" [ 0.05 0.05 0.05 ] "float scale" [ 1 ]
AttributeEnd
AttributeBegin
    LightSource "distant" "blackbody L" [ 5800 ] "float scale" [ 3 ] "point3 from" [ 2 3 4 ] "point3 to" [ 0 0 0 ]
AttributeEnd
MakeNamedMaterial "ground" "string type" [ "diffuse" ] "rgb reflectance" [ 0.5 0.5 0.5 ]
MakeNamedMaterial "coat" "string type" [ "conductor" ] "spectrum eta" [ "metal-Cu-eta" ]
    "spectrum k" [ "metal-Cu-k" ] "float roughness" [ 0.2 ]
AttributeBegin
    Attribute "shape" "float alpha" [ 1 ]
    NamedMaterial "ground"
    Translate 0 -1.2 0
    Rotate -90 1 0 0
    Shape "bilinearmesh" "point3 P" [ -3 -3 0 3 -3 0 -3 3 0 3 3 0 ] "integer indices" [ 0 1 2 3 ]
        "normal N" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] "point2 uv" [ 0 0 1 0 0 1 1 1 ]
AttributeEnd
AttributeBegin
    NamedMaterial "coat"
    ReverseOrientation
    Shape "displacedsphere" "string displacementfunction" "ripples" "float maxdispl" 3
AttributeEnd
)"},
};

}  // namespace dsphere::test
