#pragma once

// Maps and what is made of them, for the tests of grids and bounds.

#include "surface/nodes.h"
#include "tests/support/testmaps.h"

#include <memory>

namespace dsphere::test {

inline RawMap rawOf(int width, int height, std::vector<float> samples) {
    RawMap raw;
    raw.width = width;
    raw.height = height;
    raw.samples = std::move(samples);
    return raw;
}

/// A map, its shape and its relief.
struct Planet {
    DisplacedSphere shape;
    Heightmap map;
    Relief relief;
};

/// The map stretched over [0, 1] by heightmax; maxdispl in percent of the radius 2.
inline std::unique_ptr<Planet> makePlanet(RawMap raw, Registration registration, double max_displacement,
                                          double longitude_origin = -180.0, Filter filter = Filter::Bilinear) {
    auto planet = std::make_unique<Planet>();
    planet->shape.radius = 2.0;
    planet->shape.max_displacement = max_displacement;
    planet->shape.height_max = 65535.0;
    planet->shape.registration = registration;
    planet->shape.filter = filter;
    planet->shape.longitude_origin = longitude_origin;
    planet->map = makeHeightmap(std::move(raw), planet->shape);
    planet->relief = makeRelief(planet->shape, planet->map, {});
    return planet;
}

/// Ripples on the radius 2.
inline std::unique_ptr<Planet> makeRipples(const Ripples& ripples, double max_displacement, double longitude_origin) {
    auto planet = std::make_unique<Planet>();
    planet->shape.radius = 2.0;
    planet->shape.max_displacement = max_displacement;
    planet->shape.ripples = ripples;
    planet->shape.longitude_origin = longitude_origin;
    planet->map = loadHeightmap(planet->shape);
    planet->relief = makeRelief(planet->shape, planet->map, {});
    return planet;
}

/// The direction, of any length, of face coordinates (a, b), by the convention of Bounds, written anew.
inline dvec3 faceDirection(int face, double a, double b) {
    int axis = face / 2;
    dvec3 w(0.0);
    w[axis] = face % 2 == 1 ? -1.0 : 1.0;
    w[(axis + 1) % 3] = a;
    w[(axis + 2) % 3] = b;
    return w;
}

}  // namespace dsphere::test
