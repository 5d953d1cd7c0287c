#pragma once

// Scenes and their maps built in code, for the conformance cases.

#include "surface/scenemaps.h"

namespace dsphere::conformance {

/// What the environment's DSPHERE_TEST_SURFACE makes of every displaced sphere: "bspline" or "ripples" (in place of its
/// map) run all cases for that surface; unset: as the case says.
enum class TestSurface { AsGiven, BSpline, Ripples };
TestSurface testSurface();

/// Movable, not copyable. Shapes refer to `maps.maps` by index.
struct World {
    Scene scene;  ///< film 200x150
    SceneMaps maps;

    World();

    /// Adds a map read with the sphere's registration and longitude origin, and returns its index.
    int addMap(RawMap raw, const DisplacedSphere& sphere);
    void addSphere(const DisplacedSphere& sphere, int map, const dmat4& world_from_object = dmat4(1.0));
    /// A plain sphere or disk.
    void addPlain(const Geometry& geometry, const dmat4& world_from_object);
    void addSun(const dvec3& towards);
    void addLamp(const dvec3& position, double intensity);
    /// `fov` in degrees over the shorter axis.
    void lookAt(const dvec3& eye, const dvec3& target, const dvec3& up, double fov);

    /// The greatest radius R of a shape that is a displaced sphere, object units.
    double unit(std::size_t shape = 0) const { return maps.reliefs[shape].greatest_radius; }
};

/// One displaced sphere whose object space is the world.
World sphereWorld(RawMap raw, const DisplacedSphere& sphere);
/// The same of radius 1 and that displacement in percent.
World sphereWorld(RawMap raw, double percent);

/// The fov in degrees under which a sphere of radius 1, that far away, spans that share of the film's height.
double pictureFov(double distance, double share);

dmat4 translation(const dvec3& offset);
dmat4 scaling(const dvec3& factors);
/// About +y, so that longitudes grow by that much.
dmat4 turned(double degrees);

/// The unit vector at a longitude (east of +z) and latitude (north of the equator), radians.
dvec3 direction(double longitude, double latitude);
/// Unit vectors towards east and north there.
dvec3 east(double longitude);
dvec3 north(double longitude, double latitude);

/// Longitude and latitude in radians of node (i, j) of a map; i may exceed the width.
double nodeLongitude(const Heightmap& map, int i);
double nodeLatitude(const Heightmap& map, int j);

}  // namespace dsphere::conformance
