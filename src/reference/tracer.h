#pragma once

// The scene's first hits, shadows and direct light in world space and double precision.

#include "reference/firsthit.h"
#include "scene/scene.h"
#include "surface/colourmap.h"

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
    dvec3 normal{0.0};                                        ///< world, unit: outward; a disk's is its +z
    dvec3 shading_normal{0.0};  ///< the same, but a disk's is turned to the side that the ray comes from
    dvec3 smooth_normal{0.0};   ///< the same, but of the smoother surface that light is reckoned with, if there is one

    double t() const { return t_root; }
};

/// A shadow ray's direction from a world point and its end, in units of that direction's length.
struct LightRay {
    dvec3 direction;
    double t_max;  ///< infinite (distant, unit direction) or 1 (point: the direction reaches the light)
};
LightRay lightRay(const Light& light, const dvec3& world_point);

/// Refers to scene and maps, which must outlive it; thread-safe.
class Tracer {
  public:
    /// One map and relief a shape, in the scene's order; nullptr (and any relief) for spheres and disks. Shapes that
    /// share a map each build their own bounds. Also one image a shape, for those that an image map colours; needs not
    /// be given if none is.
    Tracer(const Scene& scene, std::vector<const Heightmap*> maps, std::vector<Relief> reliefs,
           std::vector<const ColourMap*> images = {});

    /// The nearest hit over all shapes of a camera ray; t in units of |direction|.
    WorldHit firstHit(const dvec3& origin, const dvec3& direction) const;

    /// Whether anything is hit between `origin` and origin + t_max direction (world). For the shape `own_shape` that
    /// the ray starts on (-1: none) the start is given in object space as well, so that no rounding of the world
    /// position enters; all shapes are met by the rules of secondary rays.
    bool occluded(const dvec3& origin, const dvec3& direction, double t_max, int own_shape,
                  const dvec3& own_object_origin) const;

    /// The ray in a shape's object space: the same t.
    Ray objectRay(int shape, const dvec3& origin, const dvec3& direction) const;
    /// First hit of an object-space ray with one shape.
    FirstHit hitShape(int shape, const Ray& object_ray) const;
    /// The world hit that an object-space hit of that shape means; `direction` is the world ray's.
    WorldHit worldHit(int shape, const FirstHit& hit, const dvec3& direction) const;

    dvec3 reflectance(int shape, const dvec3& object_position) const;
    /// Radiance towards the viewer: the sum over the lights whose bit is set in `lit` of reflectance / pi max(0, N.L)
    /// times the distant light's radiance or the point light's intensity over its squared distance. Normals are world
    /// ones, unit, on the viewer's side (WorldHit::shading_normal and smooth_normal, which is N). Where they differ the
    /// light fades as it comes to graze the first, which decides on shadows.
    struct Normals {
        dvec3 geometric, smooth;
    };
    dvec3 shade(int shape, const dvec3& object_position, const Normals& normals, std::uint32_t lit) const;
    /// The same with the world point that directions to lights are taken from: a device's own, rounded one.
    dvec3 shadeAt(int shape, const dvec3& object_position, const dvec3& world_point, const Normals& normals,
                  std::uint32_t lit) const;

    /// The surface of a displaced sphere; nullptr for other shapes.
    const Surface* surface(int shape) const;
    const dmat4& objectFromWorld(int shape) const { return object_from_world_[std::size_t(shape)]; }

  private:
    const Scene* scene_;
    std::vector<std::optional<Surface>> surfaces_;
    std::vector<dmat4> object_from_world_;
    std::vector<const ColourMap*> images_;
};

}  // namespace dsphere::reference
