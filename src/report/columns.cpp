#include "report/columns.h"

#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>

namespace dsphere::report {

namespace {

std::string times(double value, double other) {
    return other > 0.0 && value > 0.0 ? fmt::format("{:.2g}x", value / other) : "-";
}

const MethodResult* find(const ViewResult& view, const char* name) {
    auto found = std::ranges::find(view.methods, name, &MethodResult::method);
    return found != view.methods.end() && found->skipped.empty() ? &*found : nullptr;
}

}  // namespace

const Cells& columnNames() {
    static const Cells kNames = {"method",          "primary Mrays/s", "shadow Mrays/s", "wall primary", "wall shadow",
                                 "set-up s",        "memory MiB",      "fetches a hit",  "wrong hits",   "later roots",
                                 "wrong a million", "wrong shadows",   "tangent",        "median /R",    "99.9 % /R",
                                 "greatest /R",     "99.9 % pixels"};
    return kNames;
}

Cells cellsOf(const MethodResult& method) {
    if (!method.skipped.empty()) {
        Cells cells(columnNames().size(), "-");
        cells[0] = fmt::format("{} (not run: {})", method.method, method.skipped);
        return cells;
    }
    Cells cells = {method.method,
                   megaRays(method.primary.device),
                   megaRays(method.shadow.device),
                   megaRaysMedian(method.primary.wall),
                   megaRaysMedian(method.shadow.wall),
                   seconds(method.setup_seconds),
                   mebibytes(method.memory_bytes),
                   fetches(method)};
    if (!method.accuracy) {
        cells.resize(columnNames().size(), "-");
        return cells;
    }
    const Accuracy& of = *method.accuracy;
    for (std::uint64_t count : {of.wrong_verdicts, of.later_roots}) cells.push_back(fmt::format("{}", count));
    cells.push_back(wrongOfAMillion(method));
    cells.push_back(of.shadow_rays > 0 ? fmt::format("{}", of.wrong_shadows) : "-");
    cells.push_back(fmt::format("{}", of.tangent + of.tangent_shadows));
    for (double value : {of.distance_median, of.distance_999, of.distance_greatest, of.pixels_999})
        cells.push_back(fmt::format("{:.2g}", value));
    return cells;
}

const Cells& peerColumnNames() {
    static const Cells kNames = {"map", "view", "primary rays/s", "shadow rays/s", "set-up time", "memory", "error"};
    return kNames;
}

std::vector<Cells> peerRows(const Results& results) {
    std::vector<Cells> rows;
    for (const ViewResult& view : results.views) {
        const MethodResult *exact = find(view, "exact"), *grid = find(view, "grid");
        if (!exact || !grid) continue;
        bool judged = exact->accuracy && grid->accuracy;
        rows.push_back({caseName(view), view.view, times(exact->primary.device.median, grid->primary.device.median),
                        times(exact->shadow.device.median, grid->shadow.device.median),
                        times(exact->setup_seconds.median, grid->setup_seconds.median),
                        times(double(exact->memory_bytes), double(grid->memory_bytes)),
                        judged ? times(exact->accuracy->distance_999, grid->accuracy->distance_999) : "-"});
    }
    return rows;
}

std::vector<std::pair<std::string, std::string>> facts(const Results& results) {
    const Environment& of = results.environment;
    std::string peers = of.embree.empty()
                            ? "none: this build is without Embree"
                            : fmt::format("Embree {}, robust mode, packets of 16 rays, all cores", of.embree);
    return {{"date", of.date},
            {"version", fmt::format("dsphere {}, commit {}", of.version, of.commit)},
            {"host", fmt::format("{}, {} cores, load {:.1f} before the run", of.cpu, of.cores, of.load)},
            {"device", fmt::format("{} ({}); opened in {:.2f} s", of.device, of.driver, of.device_open_seconds)},
            {"meshes", peers},
            {"repeats", fmt::format("up to {} of each method, in turns, after one that warms it{}", results.repeats,
                                    results.quick ? " (a quick run)" : "")},
            {"compared", fmt::format("{} pixels a view, drawn with a fixed seed", results.samples)}};
}

const Cells& explanations() {
    static const Cells kTexts = {
        "Speed is the median of the repeats, with the least and the greatest. All pixels count as primary rays, those "
        "that miss too; only t is written. Shadow rays leave each method's own hits where they face the sun; on the "
        "device their time is that of t and lit together less that of t alone. Device times are timestamps; a mesh is "
        "traced on the host, where both clocks are one.",
        "Set-up runs from the map in memory to the first image on the host: nodes, bounds, upload, pipelines and a "
        "frame, or vertices, hierarchy and a frame. The device is open before. Memory is what lies on the device (maps "
        "and bounds), or Embree's greatest while it builds, and the film of t.",
        "Errors are against the certified reference. A wrong hit is a hit for a miss, a miss for a hit, or a root "
        "before "
        "the first; a later root is one taken for the first; a wrong shadow is a pixel whose light differs from what "
        "the "
        "reference says at the true hit. \"Wrong a million\" are wrong hits and later roots together, of a million "
        "camera rays of the view. Rays whose answer changes when they move sideways by 1e-6 R are tangent: "
        "counted apart, either answer is right. Distances are from a hit to the true surface, in units of the greatest "
        "radius R, and as seen, in pixels.",
        "exact is this program's marcher; detail the same on the coarsest level of the map that is off by so many "
        "pixels at most. naive steps by |p| - r until that is under its threshold, in units of R. "
        "lipschitz divides that step by a proven bound of the slope, and stops at 3e-6. grid and triangles are meshes "
        "of the map's nodes, of every second (1/2) or fourth (1/4) node, or of the map's bilinear surface at lines "
        "twice (2x) "
        "or four times (4x) as dense. iterated is photogrammetry's iteration: from "
        "the hit with "
        "a sphere to that with the sphere of the radius found there, until a hundredth of a pixel or 100 turns; "
        "iterated "
        "secant takes the secant's zero instead. smooth is a sphere without a map: no method "
        "can "
        "be "
        "faster."};
    return kTexts;
}

}  // namespace dsphere::report
