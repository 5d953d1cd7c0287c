#include "image/noise.h"

namespace dsphere {
namespace {

// The 32-bit mixer "lowbias32" of Wellons, https://nullprogram.com/blog/2018/07/31/
std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ x >> 16;
}

}  // namespace

double latticeNoise(int x, int y, int z, std::uint32_t seed) {
    return hash(std::uint32_t(x) + hash(std::uint32_t(y) + hash(std::uint32_t(z) + hash(seed)))) / 4294967296.0;
}

double valueNoise(const dvec3& point, std::uint32_t seed) {
    const dvec3 cell = glm::floor(point), t = point - cell;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const double weight = (dx ? smoothStep(t.x) : 1.0 - smoothStep(t.x)) *
                              (dy ? smoothStep(t.y) : 1.0 - smoothStep(t.y)) *
                              (dz ? smoothStep(t.z) : 1.0 - smoothStep(t.z));
        sum += weight * latticeNoise(int(cell.x) + dx, int(cell.y) + dy, int(cell.z) + dz, seed);
    }
    return sum;
}

}  // namespace dsphere
