#pragma once

// Scene -> PackedScene: the one place where double becomes float.

#include "render/packimage.h"
#include "render/packmap.h"
#include "render/pathtables.h"
#include "render/raster.h"
#include "render/traits.h"
#include "surface/scenemaps.h"

#include <memory>
#include <vector>

namespace dsphere {

/// A map, or one of its levels of detail, under one relief: its nodes and bounds, ready to upload. Several may share
/// their nodes.
struct PackedRelief {
    int map = 0;                     ///< index in PackedScene::nodes
    double base = 1.0, scale = 0.0;  ///< r = base + scale * stored value, units of R
    Filter filter = Filter::Bilinear;
    bool smooth_normals = false;
    Bounds bounds;
    PackedMap shader;
    int coarser = -1;  ///< index in PackedScene::reliefs of the next level of detail; -1: none
};

/// Which levels of detail of its maps a scene is packed with.
enum class Levels { Finest, All };

/// A shape, ready to upload.
struct PackedObject {
    layout::ObjectData data = {};
    double unit = 1.0;      ///< the object-space length that is 1 on the device
    int relief = -1;        ///< index in PackedScene::reliefs; -1: none
    int image = -1;         ///< index in PackedScene::images; -1: none
    PackedCentres centres;  ///< of the image's texels; empty without one
};

/// What changes from picture to picture while the maps stay: camera, lights and colours. A renderer has one of its own.
struct PackedState {
    std::vector<PackedObject> objects;            ///< one per shape, in order
    std::vector<layout::LightData> lights;        ///< one per light
    std::vector<layout::MaterialData> materials;  ///< one per object; regularized ones from MAX_OBJECTS on
};

struct PackedScene {
    PackedState state;                               ///< as the scene was when it was packed
    std::vector<std::unique_ptr<Heightmap>> halves;  ///< levels of detail beyond the maps of SceneMaps
    std::vector<std::unique_ptr<NodeGrid>> nodes;    ///< one a map of SceneMaps, then one a half, which they refer to
    std::vector<int> half_of_nodes;                  ///< by index in `nodes`: of the map halved from it, or kNotHalved
    std::vector<PackedRelief> reliefs;               ///< distinct ones, and their levels of detail
    std::vector<ImageWords> images;                  ///< one an image of SceneMaps, which they refer to
    std::vector<layout::vec4> ramp_points;           ///< all ramps, RAMP_POINTS each
    std::vector<layout::TriangleData> triangles;     ///< of all meshes
    PathTables tables;
    int light_image = -1;            ///< index in `images` of the infinite light's, -1: none
    std::uint64_t memory_limit = 0;  ///< SceneMaps'
    SceneTraits traits;
};

/// From a shape's space on the device, in object units, to the world: a mesh lies about its own middle there.
dmat4 worldFromDevice(const Shape& shape);

/// Error (InvalidInput) with more than MAX_OBJECTS shapes, MAX_LIGHTS lights, MAX_TRIANGLES triangles, MAX_MARCHES rays
/// a pixel, or MAX_DEPTH reflections.
PackedScene packScene(const Scene& scene, const SceneMaps& maps, Levels levels = Levels::Finest);

/// Takes the camera and film of `scene`, which has changed in nothing else since it was packed.
void packCamera(PackedState& state, const Scene& scene);

/// Takes the lights and the constant and ramp colours of `scene`, which has changed in nothing else. `tables`: those of
/// its PackedScene.
void packLook(PackedState& state, const PathTables& tables, const Scene& scene, const SceneMaps& maps);

}  // namespace dsphere
