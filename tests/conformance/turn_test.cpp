// A map turned one way on a sphere turned the other way is the same surface.

#include "reference/camera.h"
#include "reference/tracer.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>
#include <limits>

namespace dsphere::conformance {
namespace {

struct TurnCase {
    std::string name;
    int columns;

    friend void PrintTo(const TurnCase& c, std::ostream* out) { *out << c.name; }
};

class Turn : public Conformance, public testing::WithParamInterface<TurnCase> {
  protected:
    static constexpr int kWidth = 512, kHeight = 256;

    // Features move east by the columns, the sphere west by their angle.
    static World turnedWorld(int columns) {
        RawMap map = test::fractalMap(kWidth, kHeight), moved = map;
        for (int j = 0; j < kHeight; ++j)
            for (int i = 0; i < kWidth; ++i)
                moved.samples[std::size_t(j * kWidth + (i + columns) % kWidth)] =
                    map.samples[std::size_t(j * kWidth + i)];
        DisplacedSphere sphere;
        sphere.max_displacement = 15.0;
        World world;
        world.addSphere(sphere, world.addMap(std::move(moved), sphere), turned(-360.0 * columns / kWidth));
        world.lookAt({0.5, 1.1, -2.9}, dvec3(0.0), {0.0, 1.0, 0.0}, 45.0);
        return world;
    }
};

// 1e-6 R / |cos| and 2 ulp, of the contract, about the reference's hit; infinite on a miss.
double alongRayBound(const World& world, const reference::Tracer& tracer, double x, double y, float t) {
    reference::CameraRay ray = reference::cameraRay(world.scene.camera, world.scene.film, x, y);
    reference::WorldHit truth = tracer.firstHit(ray.origin, ray.direction);
    if (!truth.hit) return std::numeric_limits<double>::infinity();
    float next = std::nextafter(t, std::numeric_limits<float>::infinity());
    return verify::contract::kAlongRay * world.unit() / std::abs(glm::dot(truth.normal, ray.direction)) +
           2.0 * (double(next) - double(t));
}

TEST_P(Turn, ByWholeTexelsChangesNothing) {
    World first = turnedWorld(0), second = turnedWorld(GetParam().columns);
    verify::Outcome a = picture(first), b = picture(second);
    expectContract(a.report);
    expectContract(b.report);
    reference::Tracer tracer(first.scene, first.maps.perShape(), first.maps.reliefs);
    const auto &t_a = a.device.at("t").floats(), &t_b = b.device.at("t").floats();
    std::uint64_t different = 0, compared = 0;
    for (std::size_t i = 0; i < t_a.size(); ++i) {
        if (std::isinf(t_a[i]) && std::isinf(t_b[i])) continue;
        ++compared;
        double bound = alongRayBound(first, tracer, double(i % 200) + 0.5, double(i / 200) + 0.5, t_a[i]);
        if (!(std::abs(double(t_a[i]) - double(t_b[i])) <= 2.0 * bound)) ++different;
    }
    EXPECT_GT(compared, 5000u);
    EXPECT_LE(different, a.report.tangent + b.report.tangent) << "only tangent rays may differ";
}

INSTANTIATE_TEST_SUITE_P(By, Turn,
                         testing::Values(TurnCase{"1Texel", 1}, TurnCase{"100Texels", 100}, TurnCase{"256Texels", 256},
                                         TurnCase{"511Texels", 511}),
                         caseName<TurnCase>);

}  // namespace
}  // namespace dsphere::conformance
