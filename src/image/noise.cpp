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

// What the points of the lattice with that y and z have in common.
std::uint32_t lineHash(int y, int z, std::uint32_t seed) {
    return hash(std::uint32_t(y) + hash(std::uint32_t(z) + hash(seed)));
}

double share(std::uint32_t hash) {
    return hash / 4294967296.0;
}

}  // namespace

double latticeNoise(int x, int y, int z, std::uint32_t seed) {
    return share(hash(std::uint32_t(x) + lineHash(y, z, seed)));
}

double valueNoise(const dvec3& point, std::uint32_t seed) {
    const dvec3 cell = glm::floor(point), t = point - cell;
    const std::uint32_t x = std::uint32_t(int(cell.x));
    const int y = int(cell.y), z = int(cell.z);
    const double in_x = smoothStep(t.x), in_y = smoothStep(t.y), in_z = smoothStep(t.z);
    double sum = 0.0;
    for (int dz = 0; dz < 2; ++dz)
        for (int dy = 0; dy < 2; ++dy) {
            const std::uint32_t row = lineHash(y + dy, z + dz, seed);
            const double across = dy ? in_y : 1.0 - in_y, up = dz ? in_z : 1.0 - in_z;
            sum += (1.0 - in_x) * across * up * share(hash(x + row));
            sum += in_x * across * up * share(hash(x + 1u + row));
        }
    return sum;
}

}  // namespace dsphere
