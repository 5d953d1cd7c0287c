#include "tests/reference/agree.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {

void expectAgreement(const std::string& name, const Surface& surface, const Oracle& oracle, const Ray& ray, int samples,
                     Tally& tally) {
    const DenseHit dense = oracle.search(ray, surface.greatestRadius(), samples);
    const FirstHit hit = firstHit(surface, ray);
    ++tally.rays;
    tally.hits += hit.hit;
    bool agree = hit.hit == dense.hit;
    if (hit.hit) {
        const double low = double(oracle.f(ray, hit.t_low)), high = double(oracle.f(ray, hit.t_high));
        EXPECT_GT(low, -surface.evaluationError()) << name;
        EXPECT_LT(high, surface.evaluationError()) << name;
        const bool crosses = low > 0.0 && high < 0.0;
        // A crossing that the oracle itself confirms, in front of its first: its samples stood too far apart.
        const bool finer = crosses && (!dense.hit || hit.t_high < dense.t);
        tally.finer += finer;
        agree = finer || (agree && crosses && hit.t_low <= dense.t && dense.t <= hit.t_high);
        EXPECT_LE(std::abs(double(oracle.f(hit.position.x, hit.position.y, hit.position.z))),
                  1e-14 * surface.greatestRadius() + surface.evaluationError())
            << name;
    }
    if (agree && hit.hit) return;
    const FirstHit verdict = classify(surface, ray);
    tally.tangent += verdict.verdict == Verdict::Tangent;
    if (!agree) {
        EXPECT_EQ(verdict.verdict, Verdict::Tangent) << name << ": certified " << hit.hit << " at " << hit.t_low
                                                     << ", dense " << dense.hit << " at " << double(dense.t);
    }
    if (!hit.hit && !dense.hit && dense.sampled) {
        EXPECT_GT(verdict.least_f, 0.0) << name;
        EXPECT_LE(verdict.least_f, double(dense.least_f) + 1e-9) << name;
        EXPECT_NEAR(verdict.least_f, double(oracle.f(ray, verdict.least_t)), 1e-9) << name;
    }
}

}  // namespace dsphere::reference::test
