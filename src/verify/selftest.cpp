#include "verify/selftest.h"

#include "reference/camera.h"
#include "reference/tracer.h"
#include "render/raster.h"
#include "verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dsphere::verify {

namespace {

constexpr int kPathSamples = 4;
// Paths with equal numbers part where a rounding decides; of a right device few do. Measured, float against double and
// lavapipe against float: 0.33 % at most, on the checkerboard map.
constexpr double kPathsOff = 0.02;
// So many pixels of a plane may differ between two right devices: at silhouettes and creases. Measured likewise: none;
// drivers that fuse products and sums round otherwise.
constexpr std::size_t kPixelsOff = 20;

/// The planes that tell what is wrong, by the channels that they have.
struct PlaneGroup {
    const char* name;
    std::array<const char*, 3> channels;
};
constexpr PlaneGroup kGroups[] = {{"distance t", {"t"}},
                                  {"position P", {"P.X", "P.Y", "P.Z"}},
                                  {"normal N", {"N.X", "N.Y", "N.Z"}},
                                  {"shading normal Ns", {"Ns.X", "Ns.Y", "Ns.Z"}},
                                  {"texture Albedo", {"Albedo.R", "Albedo.G", "Albedo.B"}},
                                  {"shadow lit", {"lit"}},
                                  {"colour", {"R", "G", "B"}}};

bool areClose(const Channel& a, const Channel& b, std::size_t i) {
    if (!a.isFloat()) return a.uints()[i] == b.uints()[i];
    const float x = a.floats()[i], y = b.floats()[i];
    return x == y || std::abs(x - y) <= 1e-4f + 2e-3f * std::max(std::abs(x), std::abs(y));
}

std::size_t pixelsOff(const PlaneGroup& group, const Image& a, const Image& b) {
    std::size_t off = 0;
    for (std::size_t i = 0; i < a.pixelCount(); ++i)
        off += std::ranges::any_of(group.channels,
                                   [&](const char* name) { return name && !areClose(a.at(name), b.at(name), i); });
    return off;
}

std::vector<std::string> differences(const Image& image, const Image& before, const std::string& name) {
    std::vector<std::string> lines;
    for (const PlaneGroup& group : kGroups)
        if (const std::size_t off = pixelsOff(group, image, before); off > kPixelsOff)
            lines.push_back(fmt::format("{} differs from {} in {} pixels", group.name, name, off));
    return lines;
}

// Of two pictures of as many samples.
double pathsOff(const Image& image, const Image& before) {
    const PlaneGroup colour = {"colour", {"R", "G", "B"}};
    return double(pixelsOff(colour, image, before)) / double(image.pixelCount());
}

/// A result and what the next device is held against.
struct Made {
    SceneResult result;
    Image planes, paths;
};

Made resultOf(const Candidate& candidate, const PackedScene& packed, const TestScene& test, const Made* before) {
    const auto renderer = candidate.makeRenderer(packed, test.scene);
    Outcome outcome = verifyScene(*renderer, test.scene, test.maps, 0, {});
    Made made{{candidate.name, std::move(outcome.report), 0.0, {}}, std::move(outcome.device), {}};
    SceneResult& result = made.result;
    result.faults = result.report.violations();
    if (packed.traits.paths.diffuse_paths) made.paths = renderer->renderSums({}, 0, kPathSamples, 1, {}).total();
    if (!before) return made;
    std::ranges::move(differences(made.planes, before->planes, before->result.device),
                      std::back_inserter(result.faults));
    if (!packed.traits.paths.diffuse_paths) return made;
    result.paths_off = pathsOff(made.paths, before->paths);
    if (!(result.paths_off <= kPathsOff))
        result.faults.push_back(fmt::format("{:.1f} % of the traced pixels differ from {}", 100.0 * result.paths_off,
                                            before->result.device));
    return made;
}

/// f along a ray before its hit (or to the end of the shell) by plain evaluation: it must not be negative, and 0 at the
/// hit. Shares nothing with the search.
std::string referenceFault(const reference::Surface& surface, const reference::Ray& ray,
                           const reference::FirstHit& hit) {
    constexpr int kPlaces = 500;
    const double slack = 1e-9 * surface.greatestRadius();
    const double nearest = -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    const double end = hit.hit ? hit.t() : 2.0 * std::max(nearest, 0.0) + surface.greatestRadius();
    const double first = std::max(0.0, nearest - 1.1 * surface.greatestRadius() / glm::length(ray.direction));
    for (int k = 0; k < kPlaces; ++k) {
        const double t = first + (end - first) * k / kPlaces;
        if (t < end && surface.f(ray.origin + t * ray.direction) < -slack)
            return fmt::format("the reference passes through the surface at t = {}", t);
    }
    if (hit.hit && !(std::abs(surface.f(ray.origin + end * ray.direction)) <= slack))
        return fmt::format("the reference's hit at t = {} is not on the surface", end);
    return {};
}

std::vector<std::string> referenceFaults(const TestScene& test) {
    constexpr int kStride = 8;  // pixels from one that is tried to the next
    const Film& film = test.scene.film;
    const reference::Tracer tracer(test.scene, test.maps.perShape(), test.maps.reliefs, test.maps.imagePerShape(),
                                   test.maps.lightImage());
    std::vector<std::string> faults;
    for (int y = 0; y < film.height; y += kStride)
        for (int x = 0; x < film.width; x += kStride) {
            const reference::CameraRay camera = reference::cameraRay(test.scene.camera, film, x + 0.5, y + 0.5);
            for (int k = 0; k < int(test.scene.shapes.size()); ++k) {
                if (!tracer.surface(k)) continue;
                const reference::Ray ray = tracer.objectRay(k, camera.origin, camera.direction);
                std::string fault = referenceFault(*tracer.surface(k), ray, tracer.hitShape(k, ray));
                if (!fault.empty()) faults.push_back(fmt::format("pixel {}, {}: {}", x, y, fault));
            }
        }
    return faults;
}

Step stepOf(const SelftestRow& row) {
    constexpr Step kSteps[] = {Step::Algorithm, Step::Precision, Step::Driver};
    if (!row.reference_faults.empty()) return Step::Reference;
    for (std::size_t k = 0; k < row.results.size(); ++k)
        if (!row.results[k].faults.empty()) return kSteps[k];
    return Step::None;
}

}  // namespace

const char* stepName(Step step) {
    constexpr const char* kNames[] = {"ok", "reference", "algorithm", "precision", "driver"};
    return kNames[std::size_t(step)];
}

SelftestRow selftestScene(int i, const Candidate& in_double, const Candidate& in_float, const Candidate* device) {
    const TestScene test = makeTestScene(i);
    const PackedScene packed = packScene(test.scene, test.maps);
    SelftestRow row{test.scene.name, referenceFaults(test), {}, Step::None};
    Made made = resultOf(in_double, packed, test, nullptr);
    row.results.push_back(made.result);
    made = resultOf(in_float, packed, test, &made);
    row.results.push_back(made.result);
    if (device) row.results.push_back(resultOf(*device, packed, test, &made).result);
    row.step = stepOf(row);
    return row;
}

}  // namespace dsphere::verify
