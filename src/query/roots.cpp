#include "query/roots.h"

#include <algorithm>
#include <cmath>

// Compiled for AVX2 too, and the processor chooses. Sanitizers are not ready yet when it does.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FOR_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define FOR_SIMD
#endif
#define INLINED inline __attribute__((always_inline))

namespace dsphere::query {

namespace {

constexpr std::size_t kLanes = 64;

/// A number of each hit.
struct alignas(64) Lanes {
    double at[kLanes];

    double& operator[](std::size_t i) { return at[i]; }
    double operator[](std::size_t i) const { return at[i]; }
};

/// Of up to kLanes hits, in units of R on the device, with what the loops below find one after the other.
struct Work {
    std::size_t count;             ///< of the hits, rounded up for the vectors
    Lanes ox, oy, oz, dx, dy, dz;  ///< rays in their own frame, then in the shape's
    Lanes px, py, pz, square, t;   ///< points of the rays near the hits; the directions' squares
    Lanes longitude, colatitude, column, row;
    Lanes nw, ne, sw, se, east, south, rows_inverse;  ///< the patch there: BilinearPatch
    Lanes stored, per_longitude, per_colatitude, mixed;
    Lanes left;  ///< 1: one step on the patch does not do
};

// atan2(y, x) to 4e-16, for compilers to make vectors of. With x in 0 to 0.66 or, through pi / 4, -0.21 to 0: the
// rational function is that of Moshier's Cephes library.
INLINED double angleOf(double y, double x) {
    const double a = std::abs(x), b = std::abs(y);
    const double less = a < b ? a : b, more = a < b ? b : a;
    const bool through = less > 0.66 * more;
    const double q = (through ? less - more : less) / (through ? less + more : more), z = q * q;
    const double p =
        (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
         1.228866684490136173410e2) *
            z -
        6.485021904942025371773e1;
    const double divisor =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    const double small = (through ? 0.25 * kPi : 0.0) + (q + q * z * p / divisor);
    const double upper = a < b ? 0.5 * kPi - small : small;
    return std::copysign(x < 0.0 ? kPi - upper : upper, y);
}

// The rays' points nearest to the hits, and their places on the map.
FOR_SIMD void lookBelow(Work& work, const dmat4& device_from_frame, const MapSteps& steps) {
    const double(&m)[16] = reinterpret_cast<const double(&)[16]>(device_from_frame);
    for (std::size_t i = 0; i < work.count; ++i) {
        const double a = work.ox[i], b = work.oy[i], c = work.oz[i], d = work.dx[i], e = work.dy[i], f = work.dz[i];
        const double ox = m[12] + a * m[0] + b * m[4] + c * m[8], dx = d * m[0] + e * m[4] + f * m[8];
        const double oy = m[13] + a * m[1] + b * m[5] + c * m[9], dy = d * m[1] + e * m[5] + f * m[9];
        const double oz = m[14] + a * m[2] + b * m[6] + c * m[10], dz = d * m[2] + e * m[6] + f * m[10];
        const double square = dx * dx + dy * dy + dz * dz;
        const double t = ((work.px[i] - ox) * dx + (work.py[i] - oy) * dy + (work.pz[i] - oz) * dz) / square;
        const double x = ox + t * dx, y = oy + t * dy, z = oz + t * dz;
        work.dx[i] = dx, work.dy[i] = dy, work.dz[i] = dz;
        work.px[i] = x, work.py[i] = y, work.pz[i] = z;
        work.square[i] = square, work.t[i] = t;
        // Elsewhere squares overflow or vanish, or there is no longitude: any place does.
        const double rho2 = x * x + z * z;
        const bool regular = (square > 1e-200) & (square < 1e200) & (rho2 > 1e-200);
        work.left[i] = regular ? 0.0 : 1.0;
        work.longitude[i] = regular ? angleOf(x, z) : 0.0;
        work.colatitude[i] = regular ? angleOf(std::sqrt(rho2), y) : 0.0;
        work.column[i] = work.longitude[i] * steps.columns_per_radian - steps.first_column;
        work.row[i] = work.colatitude[i] * steps.rows_per_radian - steps.first_row;
    }
}

void findPatches(Work& work, const Interpolator& heights) {
    for (std::size_t i = 0; i < work.count; ++i) {
        const BilinearPatch patch = heights.patchAt(work.column[i], work.row[i]);
        work.nw[i] = patch.nw, work.ne[i] = patch.ne, work.sw[i] = patch.sw, work.se[i] = patch.se;
        work.east[i] = patch.east, work.south[i] = patch.south, work.rows_inverse[i] = patch.rows_inverse;
    }
}

// See findDisplacedRoot() and what it calls.
FOR_SIMD void stepOnPatches(Work& work, double base, double scale, const MapSteps& steps) {
    for (std::size_t i = 0; i < work.count; ++i) {
        const double east = work.east[i], south = work.south[i], nw = work.nw[i], sw = work.sw[i];
        const double north_rise = work.ne[i] - nw, south_rise = work.se[i] - sw, rows_inverse = work.rows_inverse[i];
        const double north_edge = nw + east * north_rise, south_edge = sw + east * south_rise;
        const double per_row = rows_inverse * steps.rows_per_radian;
        const double per_longitude = ((1.0 - south) * north_rise + south * south_rise) * steps.columns_per_radian;
        const double per_colatitude = (south_edge - north_edge) * per_row;
        const double mixed = (south_rise - north_rise) * per_row * steps.columns_per_radian;
        const double stored = north_edge + south * (south_edge - north_edge);
        const double x = work.px[i], y = work.py[i], z = work.pz[i], dx = work.dx[i], dy = work.dy[i], dz = work.dz[i];
        const double rho2 = x * x + z * z, r2 = rho2 + y * y, rho = std::sqrt(rho2), r = std::sqrt(r2);
        const double inverse_rho = 1.0 / rho, inverse_r2 = 1.0 / r2;
        const double longitude_rate = (z * dx - x * dz) * inverse_rho * inverse_rho;
        const double colatitude_rate = (y * ((x * dx + z * dz) * inverse_rho) - rho * dy) * inverse_r2;
        const double excess = r - (base + scale * stored);
        const double rate = (x * dx + y * dy + z * dz) * r * inverse_r2 -
                            scale * (per_longitude * longitude_rate + per_colatitude * colatitude_rate);
        const double slope_east = scale * per_longitude * inverse_rho, slope_south = scale * per_colatitude;
        const double steepness2 = 1.0 + slope_east * slope_east + slope_south * slope_south * inverse_r2;
        const double full = -excess / rate, along = full * rate;
        const bool stays =
            std::abs(excess) <= kGoodEnough || !(along * along <= kFarthestMove * kFarthestMove * steepness2);
        const double step = stays ? 0.0 : full;
        const double to_east = longitude_rate * step, to_south = colatitude_rate * step;
        const double new_east = east + to_east * steps.columns_per_radian, new_south = south + to_south * per_row;
        const double twist = mixed * to_east * to_south;
        const bool near = step * step * work.square[i] < kShortMove * kShortMove * rho2;
        const bool on_patch = (new_east >= 0.0) & (new_east < 1.0) & (new_south >= 0.0) & (new_south < 1.0);
        const bool done = (work.left[i] == 0.0) & (stays | (near & on_patch & (std::abs(twist * scale) < kGoodEnough)));
        work.left[i] = done ? 0.0 : 1.0;
        work.t[i] += step;
        work.px[i] = x + step * dx, work.py[i] = y + step * dy, work.pz[i] = z + step * dz;
        work.longitude[i] += to_east, work.colatitude[i] += to_south;
        work.stored[i] = stored + (per_longitude * to_east + per_colatitude * to_south + twist);
        work.per_longitude[i] = per_longitude, work.per_colatitude[i] = per_colatitude, work.mixed[i] = mixed;
    }
}

void takeIn(Work& work, std::span<const FoundHit> hits) {
    work.count = (hits.size() + 7) / 8 * 8;
    for (std::size_t i = 0; i < work.count; ++i) {
        const FoundHit& hit = hits[std::min(i, hits.size() - 1)];
        const auto &o = hit.ray->origin, &d = hit.ray->direction;
        work.ox[i] = o[0], work.oy[i] = o[1], work.oz[i] = o[2];
        work.dx[i] = d[0], work.dy[i] = d[1], work.dz[i] = d[2];
        work.px[i] = hit.position.x, work.py[i] = hit.position.y, work.pz[i] = hit.position.z;
    }
}

}  // namespace

void findRoots(std::span<Place> places, const ShapeFrame& shape, std::span<const FoundHit> hits) {
    const bool bilinear = shape.heights && shape.heights->isBilinear();
    Work work;
    for (std::size_t first = 0; first < hits.size(); first += kLanes) {
        const std::span<const FoundHit> some = hits.subspan(first, std::min(kLanes, hits.size() - first));
        if (bilinear) {
            takeIn(work, some);
            lookBelow(work, shape.device_from_frame, shape.heights->steps());
            findPatches(work, *shape.heights);
            stepOnPatches(work, shape.base, shape.scale, shape.heights->steps());
        }
        for (std::size_t i = 0; i < some.size(); ++i) {
            Place& place = places[first + i];
            if (!bilinear || work.left[i] != 0.0) {
                findRoot(place, shape, *some[i].ray, some[i].position);
                continue;
            }
            place.t = work.t[i];
            place.position = {work.px[i], work.py[i], work.pz[i]};
            place.longitude = work.longitude[i];
            place.colatitude = work.colatitude[i];
            place.height.value = work.stored[i];
            place.height.per_longitude = work.per_longitude[i];
            place.height.per_colatitude = work.per_colatitude[i];
            place.height.mixed = work.mixed[i];
        }
    }
}

}  // namespace dsphere::query
