// Rays aimed, in double, at texels' corners and along their edges.

#include "reference/surface.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>

namespace dsphere::conformance {
namespace {

/// A world's first shape and random places on the lattice of its nodes.
struct Lattice {
    const Heightmap& map;
    reference::Surface surface;
    double unit;
    Random random{11};

    explicit Lattice(const World& world)
        : map(*world.maps.maps[0]), surface(map, world.maps.reliefs[0]), unit(world.unit()) {}

    int pick(int n) { return int(random() % std::uint64_t(n)); }
    double longitude() { return nodeLongitude(map, pick(map.width)); }
    double latitude() { return nodeLatitude(map, pick(map.height)); }
    double anyLongitude() { return uniform(random, -kPi, kPi); }
    double anyLatitude() { return std::asin(uniform(random, -1.0, 1.0)); }
    /// The surface's point there, in units of R.
    dvec3 point(double longitude, double latitude) const {
        dvec3 w = direction(longitude, latitude);
        return surface.radius(w) / unit * w;
    }
    /// Somewhere above a point of the surface, at a distance of about 2 R.
    dvec3 above(const dvec3& p) { return p + 2.0 * glm::normalize(randomUnit(random) + 1.1 * glm::normalize(p)); }
};

struct EdgeCase {
    std::string name;
    int width, height;
    Registration registration = Registration::Texel;

    friend void PrintTo(const EdgeCase& c, std::ostream* out) { *out << c.name; }
};

class Edges : public Conformance, public testing::WithParamInterface<EdgeCase> {
  protected:
    static World makeWorld() {
        const EdgeCase& c = GetParam();
        DisplacedSphere sphere;
        sphere.max_displacement = 15.0;
        sphere.registration = c.registration;
        return sphereWorld(test::randomMap(c.width, c.height), sphere);
    }

    World world_ = makeWorld();
    Lattice lattice_{world_};
    Queries rays_;
};

TEST_P(Edges, ThroughCorners) {
    for (int k = 0; k < kRays; ++k) {
        dvec3 corner = lattice_.point(lattice_.longitude(), lattice_.latitude());
        rays_.push_back(aim(lattice_.above(corner), corner));
    }
    expectContract(probe(world_, rays_));
}

TEST_P(Edges, ThroughPointsOfEdges) {
    for (int k = 0; k < kRays; ++k) {
        dvec3 p = k % 2 ? lattice_.point(lattice_.longitude(), lattice_.anyLatitude())
                        : lattice_.point(lattice_.anyLongitude(), lattice_.latitude());
        rays_.push_back(aim(lattice_.above(p), p));
    }
    expectContract(probe(world_, rays_));
}

// In the plane of a meridian edge, from above and nearly along the ground.
TEST_P(Edges, AlongMeridianEdges) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.longitude(), latitude = lattice_.anyLatitude();
        double slope = uniform(lattice_.random, 0.05, 1.5) * (k % 2 ? 1.0 : -1.0);
        dvec3 p = lattice_.point(longitude, latitude);
        dvec3 back = std::sin(std::abs(slope)) * direction(longitude, latitude) +
                     std::copysign(std::cos(slope), slope) * north(longitude, latitude);
        rays_.push_back(aim(p + 2.0 * back, p));
    }
    expectContract(probe(world_, rays_));
}

// Towards east or west and down, through a point of a parallel's edge.
TEST_P(Edges, AlongParallelEdges) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.anyLongitude(), latitude = lattice_.latitude();
        double slope = uniform(lattice_.random, 0.02, 1.0), side = k % 2 ? 1.0 : -1.0;
        dvec3 p = lattice_.point(longitude, latitude);
        dvec3 back = std::sin(slope) * direction(longitude, latitude) + side * std::cos(slope) * east(longitude);
        rays_.push_back(aim(p + 2.0 * back, p));
    }
    expectContract(probe(world_, rays_));
}

// The ray's latitude has its extremum at the cone of a parallel, or a hair north or south of it, inside the shell.
TEST_P(Edges, TangentToAParallel) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.anyLongitude(), latitude = lattice_.latitude();
        double rise = uniform(lattice_.random, -0.6, 0.6), side = k % 2 ? 1.0 : -1.0;
        dvec3 touch = uniform(lattice_.random, 0.86, 1.0) * direction(longitude, latitude);
        if (k % 3) touch += logarithmic(lattice_.random, 1e-9, 1e-4) * north(longitude, latitude);
        dvec3 along = side * std::cos(rise) * east(longitude) + std::sin(rise) * direction(longitude, latitude);
        rays_.push_back({.origin = touch - 3.0 * along, .direction = along});
    }
    expectContract(probe(world_, rays_));
}

INSTANTIATE_TEST_SUITE_P(Maps, Edges,
                         testing::Values(EdgeCase{"Coarse", 24, 12}, EdgeCase{"Fine", 1024, 512},
                                         EdgeCase{"Gridline", 720, 361, Registration::Gridline}),
                         caseName<EdgeCase>);

}  // namespace
}  // namespace dsphere::conformance
