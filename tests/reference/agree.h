#pragma once

#include "reference/firsthit.h"
#include "tests/reference/maps.h"
#include "tests/reference/oracle.h"

#include <atomic>
#include <string>

namespace dsphere::reference::test {

struct Tally {
    std::atomic<int> rays = 0, hits = 0, tangent = 0, finer = 0;
};

/// Expects the certified first hit of a camera ray from outside to be that of the oracle's dense search and f to change
/// its sign within the enclosure (only a tangent ray may fail these, or one whose hit lies in front of the oracle's and
/// is confirmed by it: `finer`), and the least f of a miss not to lie above the
/// oracle's.
void expectAgreement(const std::string& name, const Surface& surface, const Oracle& oracle, const Ray& ray, int samples,
                     Tally& tally);

}  // namespace dsphere::reference::test
