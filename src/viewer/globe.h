#pragma once

#include "base/math.h"
#include "scene/scene.h"
#include "surface/nodes.h"

#include <array>
#include <optional>
#include <vector>

namespace dsphere::viewer {

/// A place on a planet as people name it: degrees, and what the map stores there.
struct Place {
    double latitude, longitude;
    std::optional<double> stored;  ///< in the map's units; unset without a map
};

/// A shape of the scene as the camera moves about it. World space.
class Globe {
  public:
    /// `nodes` (null: no map) must outlive the globe; of the shape, as is the relief.
    Globe(const Shape& shape, const NodeGrid* nodes, const Relief& relief);
    /// The shape of a scene that a view begins with: the first displaced sphere, else the first shape.
    static std::size_t shapeOf(const Scene& scene);

    const dvec3& centre() const { return centre_; }
    double radius() const { return radius_; }        ///< R: the greatest, as the longest axis of the transform shows it
    const dvec3& north() const { return north_; }    ///< unit
    const dvec3& origin() const { return origin_; }  ///< unit: towards latitude 0, longitude 0
    const dvec3& east() const { return east_; }      ///< unit: towards latitude 0, longitude 90
    /// A sphere of whatever kind: it has places. Disks and meshes have none.
    bool round() const { return pieces_.empty() && !disk_; }
    /// A displaced sphere: nothing can be inside it. A plain sphere may hold the whole scene.
    bool solid() const { return solid_; }

    /// Distance of the ground from the centre in a direction of any length but 0; of a round one.
    double ground(const dvec3& direction) const;
    /// Of a point above the ground; below it is negative. Of a round one.
    double altitude(const dvec3& point) const;
    /// How far a point is from the surface, about: negative inside a solid one alone.
    double clearance(const dvec3& point) const;
    /// `point` is not the centre of this round one.
    Place placeOf(const dvec3& point) const;
    /// Unit, outward: where latitude and longitude (degrees) are.
    dvec3 direction(double latitude, double longitude) const;

  private:
    using Triangle = std::array<dvec3, 3>;

    dvec3 objectDirection(const dvec3& world) const;
    double sampleAt(const dvec3& object_direction) const;
    void takePieces(const TriangleMesh& mesh);
    double distanceToDisk(const dvec3& point) const;

    const NodeGrid* nodes_;
    Relief relief_;
    dmat4 world_from_object_, object_from_world_;
    dvec3 centre_, north_, origin_, east_;
    double radius_ = 1.0;
    bool solid_ = false;
    std::optional<Disk> disk_;
    std::vector<Triangle> pieces_;  ///< of a mesh, world
};

/// All shapes of a scene, one Globe each, in order: what the camera must not pass through.
class Bodies {
  public:
    explicit Bodies(std::vector<Globe> globes);

    const Globe& operator[](std::size_t shape) const { return globes_[shape]; }
    std::size_t count() const { return globes_.size(); }
    /// A ball about all of them.
    const dvec3& middle() const { return middle_; }
    double reach() const { return reach_; }
    /// The distance to the nearest.
    double clearance(const dvec3& point) const;
    /// Where the eye comes on its way between two points (not the same) without coming nearer to any of them than
    /// `lowest`, in R of each, or than this share of how near it is at the start.
    dvec3 wayTo(const dvec3& from, const dvec3& to, double lowest, double share = 0.5) const;
    /// Out of the solid ones, to `lowest` above their ground.
    dvec3 outOfGround(const dvec3& eye, double lowest) const;

  private:
    std::vector<Globe> globes_;
    dvec3 middle_{0.0};
    double reach_ = 0.0;
};

}  // namespace dsphere::viewer
