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
    Planet(RawMap raw, double percent, Registration registration = Registration::Texel,
           Filter filter = Filter::Bilinear) {
        DisplacedSphere sphere;
        sphere.max_displacement = percent;
        sphere.registration = registration;
        sphere.filter = filter;
        pack(sphere, makeHeightmap(std::move(raw), sphere));
    }

    /// The same of ripples.
    Planet(const Ripples& ripples, double percent) {
        DisplacedSphere sphere;
        sphere.max_displacement = percent;
        sphere.ripples = ripples;
        pack(sphere, loadHeightmap(sphere));
    }

    Planet(const Planet&) = delete;  // the thread's current resources are its own
    Planet& operator=(const Planet&) = delete;

    double unit() const { return maps.reliefs[0].greatest_radius; }  ///< R, object units
    const layout::MapData& map() const { return packed.reliefs[0].shader.data; }
    const layout::ObjectData& object() const { return packed.state.objects[0].data; }

  private:
    void pack(const DisplacedSphere& sphere, Heightmap map) {
        Shape shape;
        shape.geometry = sphere;
        scene.shapes.push_back(shape);
        maps.maps.push_back(std::make_unique<Heightmap>(std::move(map)));
        maps.map_of_shape.push_back(0);
        maps.reliefs.push_back(makeRelief(sphere, *maps.maps[0], shape.where));
        packed = packScene(scene, maps);
        const PackedRelief& relief = packed.reliefs[0];
        resources.nodes = packed.nodes[0].get();
        resources.bounds = &relief.bounds;
        resources.edges[0] = relief.shader.longitude_edges;
        resources.edges[1] = relief.shader.colatitude_edges;
        resources.edges[2] = relief.shader.longitude_phases;
        resources.edges[3] = relief.shader.colatitude_phases;
        if (sphere.filter == Filter::BSpline) {
            const SplineNodes spline(*resources.nodes);
            for (int j = 0; j <= resources.nodes->rows(); ++j) resources.spline_nodes.push_back(spline.row(j));
        }
        current_resources = &resources;
        surface = std::make_unique<reference::Surface>(*maps.maps[0], maps.reliefs[0]);
    }
};

}  // namespace dsphere::test
