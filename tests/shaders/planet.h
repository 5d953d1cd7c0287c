#pragma once

#include "reference/surface.h"
#include "render/pack.h"
#include "tests/shaders/cpp_shaders.h"

#include <memory>

namespace dsphere::test {

/// A displaced sphere packed for the shader functions, and the reference's view of it.
struct Planet {
    Scene scene;
    SceneMaps maps;
    PackedScene packed;
    Resources resources;
    std::unique_ptr<reference::Surface> surface;

    /// Radius 1, displaced by `percent`; makes its resources current for the calling thread.
    Planet(RawMap raw, double percent, Registration registration = Registration::Texel) {
        DisplacedSphere sphere;
        sphere.max_displacement = percent;
        sphere.registration = registration;
        Shape shape;
        shape.geometry = sphere;
        scene.shapes.push_back(shape);
        maps.maps.push_back(std::make_unique<Heightmap>(makeHeightmap(std::move(raw), sphere)));
        maps.map_of_shape.push_back(0);
        maps.reliefs.push_back(makeRelief(sphere, *maps.maps[0], shape.where));
        packed = packScene(scene, maps);
        const PackedRelief& relief = packed.reliefs[0];
        resources.nodes = packed.nodes[0].get();
        resources.bounds = &relief.bounds;
        resources.longitude_edges = relief.shader.longitude_edges;
        resources.colatitude_edges = relief.shader.colatitude_edges;
        current_resources = &resources;
        surface = std::make_unique<reference::Surface>(*maps.maps[0], maps.reliefs[0]);
    }

    double unit() const { return maps.reliefs[0].greatest_radius; }  ///< R, object units
    const layout::MapData& map() const { return packed.reliefs[0].shader.data; }
    const layout::ObjectData& object() const { return packed.objects[0]; }
};

}  // namespace dsphere::test
