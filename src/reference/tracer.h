#pragma once

// The scene's first hits, shadows and direct light in world space and double precision.

#include "reference/firsthit.h"
#include "reference/lights.h"
#include "reference/materials.h"
#include "reference/sampler.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dsphere::reference {

struct WorldHit {
    bool hit = false;
    bool inside = false;  ///< the ray starts in the shape's solid; the hit is its start
    int shape = -1;       ///< index in Scene::shapes
    double t_low = std::numeric_limits<double>::infinity(), t_high = std::numeric_limits<double>::infinity();
    double t_root = std::numeric_limits<double>::infinity();  ///< the likeliest t in the enclosure
    dvec3 position{0.0};                                      ///< world
    dvec3 object_position{0.0};                               ///< in the shape's object space
    dvec3 normal{0.0};                                        ///< world, unit: outward; a disk's is its +z, a
                                                              ///< triangle's its own
    dvec3 shading_normal{0.0};  ///< the same, but a flat shape's is turned to the side that the ray comes from
    dvec3 smooth_normal{0.0};   ///< the same, but of the smoother surface that light is reckoned with, if there is one

    double t() const { return t_root; }
};

/// World, unit, on the viewer's side: WorldHit::shading_normal and smooth_normal. Where they differ light fades as it
/// comes to graze the first, which decides on shadows.
struct Normals {
    dvec3 geometric, smooth;
};

/// A point of a shape as light is reckoned with. A device's own, rounded position and normals will do.
struct ShadingPoint {
    int shape = -1;
    dvec3 object_position{0.0};
    dvec3 position{0.0};  ///< world; directions to lights are taken from it
    Normals normals{dvec3(0.0), dvec3(0.0)};
    dvec3 towards_viewer{0.0};  ///< world, unit
    bool softened = false;      ///< the shape's facets are regularised
};

/// Refers to scene and maps, which must outlive it; thread-safe.
class Tracer {
  public:
    /// One map and relief a shape, in the scene's order; nullptr (and any relief) for other shapes. Shapes that
    /// share a map each build their own bounds. Also one image a shape, for those that an image map colours; needs not
    /// be given if none is; and the infinite light's image, if it has one.
    Tracer(const Scene& scene, std::vector<const Heightmap*> maps, std::vector<Relief> reliefs,
           std::vector<const ColourMap*> images = {}, const ColourMap* light_image = nullptr);

    /// The nearest hit over all shapes of a camera ray that ends at t_max; t in units of |direction|.
    WorldHit firstHit(const dvec3& origin, const dvec3& direction,
                      double t_max = std::numeric_limits<double>::infinity()) const;

    /// The nearest hit of a ray that leaves a shape, whose start is given in the shape's object space (see beside), by
    /// the rules of secondary rays.
    WorldHit nextHit(int own_shape, const dvec3& own_object_start, const dvec3& direction) const;

    /// Whether anything is hit between `origin` and origin + t_max direction (world). For the shape `own_shape` that
    /// the ray starts on (-1: none) the start is given in object space as well, so that no rounding of the world
    /// position enters; all shapes are met by the rules of secondary rays. The shape `emitter` (-1: none) is not met.
    bool occluded(const dvec3& origin, const dvec3& direction, double t_max, int own_shape,
                  const dvec3& own_object_origin, int emitter = -1) const;

    /// The ray in a shape's object space: the same t.
    Ray objectRay(int shape, const dvec3& origin, const dvec3& direction) const;
    /// First hit of an object-space ray with one shape.
    FirstHit hitShape(int shape, const Ray& object_ray) const;
    /// The world hit that an object-space hit of that shape means; `direction` is the world ray's.
    WorldHit worldHit(int shape, const FirstHit& hit, const dvec3& direction) const;

    /// The shape as light meets it at a hit of a ray with that direction.
    ShadingPoint shadingPoint(const WorldHit& hit, const dvec3& direction) const;

    /// The colour texture at a point; white if the material has none.
    dvec3 reflectance(int shape, const dvec3& object_position) const;
    const Reflector& reflector(const ShadingPoint& point) const {
        return (point.softened ? softened_ : reflectors_)[std::size_t(point.shape)];
    }
    const Lights& lights() const { return lights_; }

    /// The greatest radius R of a shape, the length that its tolerances are in, object units: a disk's own radius, of a
    /// mesh the distance of its farthest point from its middle.
    double unit(int shape) const;
    /// What R and device coordinates are counted from, object space: the origin, or the middle of a mesh.
    dvec3 middle(int shape) const;
    /// P' beside a point, where shadow rays start: moved along the geometric normal by `offset` R, object space.
    dvec3 beside(const ShadingPoint& point, double offset = 1e-6) const;

    /// What the shape sends towards the viewer by itself.
    dvec3 emission(const ShadingPoint& point) const;
    /// Light k's sample at a point.
    LightSample lightSample(const ShadingPoint& point, int k, const SampleSource& source) const;
    /// Whether the sample lies above the surface and is seen from `start` (object space, see beside).
    bool seen(const ShadingPoint& point, int k, const LightSample& sample, const dvec3& start) const;
    /// Bit k: light k's sample of vertex 0 is seen.
    std::uint32_t litLights(const ShadingPoint& point, const SampleSource& source) const;
    /// f cos(n, l) towards the viewer for light from a direction (unit); 0 below the surface, and of mirrors.
    dvec3 reflected(const ShadingPoint& point, const dvec3& l) const;
    /// reflected() for a texture colour that is known: to look it up takes longer than the rest on meshes and images.
    dvec3 reflected(const ShadingPoint& point, const dvec3& l, const dvec3& colour) const;
    /// Radiance towards the viewer as the planes of a pixel's centre hold it: emission, and of each light whose bit is
    /// set in `lit` the sample of vertex 0.
    dvec3 directLight(const ShadingPoint& point, const SampleSource& source, std::uint32_t lit) const;

    /// The surface of a displaced sphere; nullptr for other shapes.
    const Surface* surface(int shape) const;
    const dmat4& objectFromWorld(int shape) const { return object_from_world_[std::size_t(shape)]; }

  private:
    const Scene* scene_;
    std::vector<std::optional<Surface>> surfaces_;
    std::vector<dmat4> object_from_world_;
    std::vector<const ColourMap*> images_;
    std::vector<Reflector> reflectors_, softened_;
    Lights lights_;
};

}  // namespace dsphere::reference
