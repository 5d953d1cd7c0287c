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
    /// Of a row that is an edge: gridline registration's first and last are the poles, which are points.
    double parallel() {
        int poles = map.registration == Registration::Gridline ? 1 : 0;
        return nodeLatitude(map, poles + pick(map.height - 2 * poles));
    }
    double anyLongitude() { return uniform(random, -kPi, kPi); }
    double anyLatitude() { return std::asin(uniform(random, -1.0, 1.0)); }
    /// The surface's point there, in units of R.
    dvec3 point(double longitude, double latitude) const {
        dvec3 w = direction(longitude, latitude);
        return surface.radius(w) / unit * w;
    }
    /// Whether n is the normal of the patch at p or of one that p is within 1e-6 R of, to the contract's angle. Short
    /// steps first: within a steep patch the normal turns by more than that angle in 1e-6 R.
    bool meetsNormal(const dvec3& p, const dvec3& n) const {
        double longitude = std::atan2(p.x, p.z), latitude = std::asin(p.y / glm::length(p));
        for (double step : {3e-8, 1e-7, 3e-7, 1e-6}) {
            for (int k = 0; k < 9; ++k) {
                dvec3 across = double(k % 3 - 1) * east(longitude) + double(k / 3 - 1) * north(longitude, latitude);
                dvec3 truth = surface.normal((p + step * across) * unit);
                double angle = std::atan2(glm::length(glm::cross(truth, n)), glm::dot(truth, n));
                if (glm::degrees(angle) <= verify::contract::kNormalDegrees) return true;
            }
        }
        return false;
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

    // Half the nodes and edges are ridges, which a ray that is aimed at them may pass to either side.
    static void expectAimedAtRidges(verify::Report report) {
        report.normal_degrees.clear();
        expectContractButTangents(std::move(report));
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
    expectAimedAtRidges(probe(world_, rays_));
}

TEST_P(Edges, ThroughPointsOfEdges) {
    for (int k = 0; k < kRays; ++k) {
        dvec3 p = k % 2 ? lattice_.point(lattice_.longitude(), lattice_.anyLatitude())
                        : lattice_.point(lattice_.anyLongitude(), lattice_.latitude());
        rays_.push_back(aim(lattice_.above(p), p));
    }
    expectAimedAtRidges(probe(world_, rays_));
}

// A pole is the tip of a cone, which a ray that is aimed at it may meet or pass.
TEST_P(Edges, AslantThroughPoles) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.anyLongitude(), latitude = k % 2 ? 0.5 * kPi : -0.5 * kPi;
        double slope = uniform(lattice_.random, 0.02, 1.0);
        dvec3 p = lattice_.point(longitude, latitude);
        rays_.push_back(aim(
            p + 2.0 * (std::sin(slope) * direction(longitude, latitude) + std::cos(slope) * north(longitude, latitude)),
            p));
    }
    expectAimedAtRidges(probe(world_, rays_));
}

// A hit on an edge may take the normal of any patch that meets there, but none other.
TEST_P(Edges, NormalsAreThoseOfAPatchThatMeets) {
    for (int k = 0; k < kRays; ++k) {
        dvec3 p = lattice_.point(lattice_.longitude(), k % 2 ? lattice_.latitude() : lattice_.anyLatitude());
        rays_.push_back(aim(lattice_.above(p), p));
    }
    PackedScene packed = packScene(world_.scene, world_.maps);
    std::vector<layout::ProbeHit> hits = makeProbe(packed)->trace(rays_);
    std::size_t right = 0, found = 0;
    for (const layout::ProbeHit& hit : hits) {
        if ((hit.flags & 1u) == 0) continue;
        ++found;
        right += lattice_.meetsNormal(dvec3(hit.position), dvec3(hit.normal)) ? 1 : 0;
    }
    EXPECT_GE(found, kLeastRays / 2);
    EXPECT_GE(double(right), verify::contract::kNormalShare * double(found));
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
    expectContractButNormals(probe(world_, rays_));
}

// Towards east or west and down, through a point of a parallel's edge.
TEST_P(Edges, AlongParallelEdges) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.anyLongitude(), latitude = lattice_.parallel();
        double slope = uniform(lattice_.random, 0.02, 1.0), side = k % 2 ? 1.0 : -1.0;
        dvec3 p = lattice_.point(longitude, latitude);
        dvec3 back = std::sin(slope) * direction(longitude, latitude) + side * std::cos(slope) * east(longitude);
        rays_.push_back(aim(p + 2.0 * back, p));
    }
    expectContractButNormals(probe(world_, rays_));
}

// The ray's latitude has its extremum at the cone of a parallel, or a hair north or south of it, inside the shell.
TEST_P(Edges, TangentToAParallel) {
    for (int k = 0; k < kRays; ++k) {
        double longitude = lattice_.anyLongitude(), latitude = lattice_.parallel();
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
