// Roots that are found side by side against those that are found one by one.

#include "query/roots.h"
#include "tests/query/fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dsphere::query {
namespace {

class Roots : public QueryTest {
  protected:
    /// Rays to places all over the sphere and near its poles, and where a device in floats would find the ground there.
    void makeHits(const ShapeFrame& shape, std::size_t count) {
        std::mt19937_64 random(7);
        const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        for (std::size_t i = 0; i < count; ++i) {
            const double reach = i % 3 == 0 ? std::pow(10.0, uniform(-6.0, -1.0)) : 1.5;
            const dvec3 up =
                glm::normalize(dvec3(reach * uniform(-1.0, 1.0), i % 2 ? 1.0 : -1.0, reach * uniform(-1.0, 1.0)));
            const double colatitude = std::atan2(std::hypot(up.x, up.z), up.y);
            const HeightSample ground = shape.heights->at(std::atan2(up.x, up.z), colatitude);
            const dvec3 p = (shape.base + shape.scale * ground.value) * up;
            const dvec3 away = glm::normalize(up + dvec3(uniform(-0.9, 0.9), uniform(-0.9, 0.9), uniform(-0.9, 0.9)));
            const dvec3 origin = transformPoint(shape.frame_from_device, p + uniform(0.1, 9.0) * away);
            const dvec3 direction = transformVector(shape.frame_from_device, -uniform(0.1, 9.0) * away);
            rays_.push_back({{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}});
            positions_.push_back(dvec3(glm::vec3(p + uniform(-2e-7, 2e-7) * away)));
        }
        for (std::size_t i = 0; i < count; ++i) hits_.push_back({&rays_[i], positions_[i]});
        places_.resize(count);
    }

    /// Every ninth ray goes down the axis, where no longitude is; every ninth has a direction whose square is infinite.
    void makeIrregular(const ShapeFrame& shape) {
        for (std::size_t i = 0; i < rays_.size(); i += 9) {
            const double pole = i % 2 ? 1.0 : -1.0;
            const double ground = shape.base + shape.scale * shape.heights->at(0.0, i % 2 ? 0.0 : kPi).value;
            const dvec3 origin = transformPoint(shape.frame_from_device, dvec3(0.0, 4.0 * pole, 0.0));
            const dvec3 direction = transformVector(shape.frame_from_device, dvec3(0.0, -pole, 0.0));
            rays_[i] = {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}};
            hits_[i].position = positions_[i] = dvec3(0.0, pole * ground, 0.0);
            if (i + 1 < rays_.size())
                for (double& d : rays_[i + 1].direction) d *= 1e180;
        }
    }

    void expectTheSame(const std::string& shapes, const Engine::Options& options = {}) {
        World scene = world(shapes, options);
        const ShapeFrame& shape = scene.engine.shapes()[0];
        makeHits(shape, 5003);  // no multiple of the lanes
        makeIrregular(shape);
        findRoots(places_, shape, hits_);
        std::size_t on_ground = 0;
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            Place expected;
            findRoot(expected, shape, rays_[i], positions_[i]);
            const Place& place = places_[i];
            ASSERT_NEAR(place.t, expected.t, 2e-13 * (1.0 + expected.t)) << i;
            ASSERT_LT(glm::length(place.position - expected.position), 2e-13) << i;
            ASSERT_NEAR(std::sin(0.5 * (place.longitude - expected.longitude)) * std::sin(expected.colatitude), 0.0,
                        1e-13)
                << i;
            ASSERT_NEAR(place.colatitude, expected.colatitude, 1e-13) << i;
            ASSERT_NEAR(place.height.value * shape.scale, expected.height.value * shape.scale, 1e-12) << i;
            const double radius = shape.base + shape.scale * place.height.value;
            on_ground += std::abs(glm::length(place.position) - radius) < 2e-12;
        }
        EXPECT_GT(on_ground, hits_.size() * 99 / 100);  // rays that graze may move too far to be followed
    }

    std::vector<QueryRay> rays_;
    std::vector<dvec3> positions_;
    std::vector<FoundHit> hits_;
    std::vector<Place> places_;
};

TEST_F(Roots, OfTexels) {
    expectTheSame(planet("\"float maxdispl\" 5"));
}

TEST_F(Roots, OfGridlinesOnAPlacedSphere) {
    expectTheSame("Translate 1 2 3 Rotate 40 1 2 3 Scale 2 -3 2\n" +
                  planet("\"float maxdispl\" 20 \"string registration\" \"gridline\" \"float radius\" 3"));
}

TEST_F(Roots, OfAFewSteepTexels) {
    expectTheSame(planet("\"float maxdispl\" 60", "coarse.pgm"));
}

TEST_F(Roots, OfASplineOneByOne) {
    expectTheSame(planet("\"float maxdispl\" 5 \"string filter\" \"bspline\""));
}

}  // namespace
}  // namespace dsphere::query
