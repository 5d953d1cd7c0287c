#include "reference/firsthit.h"

#include "reference/search.h"
#include "reference/shellclip.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

namespace {

FirstHit insideHit(const Line& line, const Ray& ray) {
    return {.verdict = Verdict::Hit,
            .hit = true,
            .inside = true,
            .t_low = ray.t_min,
            .t_high = ray.t_min,
            .t_root = ray.t_min,
            .position = line.at(line.s_begin)};
}

FirstHit rootHit(const Line& line, const Ray& ray, const Crossing& root) {
    return {.verdict = Verdict::Hit,
            .hit = true,
            .t_low = std::clamp(line.tBelow(root.low), ray.t_min, ray.t_max),
            .t_high = std::clamp(line.tAbove(root.high), ray.t_min, ray.t_max),
            .t_root = std::clamp(line.tAt(root.root), ray.t_min, ray.t_max),
            .position = line.at(root.root)};
}

}  // namespace

FirstHit firstHit(const Surface& surface, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line)) return {};
    double s0 = line.s_begin, s1 = line.s_end;
    if (!clipToBall(line, surface.greatestRadius(), s0, s1)) return {};
    const Chord chord(surface, line);
    const double radius = surface.greatestRadius();
    if (s0 == line.s_begin && chord.f(s0) <= 0.0) {
        if (ray.may_start_inside) return insideHit(line, ray);
        // A hair ahead, so that on a crease the patch ahead decides.
        const double slope = glm::dot(surface.gradient(line.at(s0 + 1e-12 * radius)), line.d);
        if (!(slope > 0.0)) return insideHit(line, ray);
        const Crossing exit = firstCrossing(chord, Side::Inside, s0, s1);
        if (!exit.found) return insideHit(line, ray);
        s0 = exit.high;
    }
    // No ray passes below the least radius without a hit. The margin makes f there negative beyond rounding.
    const double core = surface.leastRadius() - 1e-12 * radius - 8.0 * surface.evaluationError();
    double core0 = s0, core1 = s1;
    if (clipToBall(line, core, core0, core1) && core0 > s0) s1 = core0;
    const Crossing root = firstCrossing(chord, Side::Outside, s0, s1);
    return root.found ? rootHit(line, ray, root) : FirstHit{};
}

}  // namespace dsphere::reference
