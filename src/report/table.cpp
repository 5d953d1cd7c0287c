#include "report/table.h"

#include "report/format.h"

#include <fmt/format.h>

namespace dsphere::report {

namespace {

constexpr const char* kRow = "{:<15} {:>23} {:>23} {:>9} {:>9} {:>8} {:>6} {:>6} {:>9} {:>6} {:>9} {:>9} {:>9}\n";

std::string row(const MethodResult& method) {
    if (!method.skipped.empty()) return fmt::format("{:<15} not run: {}\n", method.method, method.skipped);
    auto count = [&](std::uint64_t Accuracy::*member) {
        return method.accuracy ? fmt::format("{}", (*method.accuracy).*member) : std::string("-");
    };
    auto real = [&](double Accuracy::*member) {
        return method.accuracy ? fmt::format("{:.2g}", (*method.accuracy).*member) : std::string("-");
    };
    const std::string shadows =
        method.accuracy && method.accuracy->shadow_rays > 0 ? count(&Accuracy::wrong_shadows) : "-";
    return fmt::format(fmt::runtime(kRow), method.method, megaRays(method.primary.device),
                       megaRays(method.shadow.device), seconds(method.setup_seconds), mebibytes(method.memory_bytes),
                       fetches(method), count(&Accuracy::wrong_verdicts), count(&Accuracy::later_roots),
                       wrongOfAMillion(method), shadows, real(&Accuracy::distance_median),
                       real(&Accuracy::distance_999), real(&Accuracy::pixels_999));
}

}  // namespace

std::string table(const Results& results) {
    std::string text;
    for (const ViewResult& view : results.views) {
        text += fmt::format("{}, {}: {}x{} pixels, {:.0f} % hit\n", caseName(view), view.view, view.width, view.height,
                            100.0 * view.hit_share);
        text += fmt::format(fmt::runtime(kRow), "", "primary", "shadow", "set-up", "memory", "fetches", "wrong",
                            "later", "wrong a", "wrong", "distance", "to surface", "99.9 %");
        text += fmt::format(fmt::runtime(kRow), "", "Mrays/s (min..max)", "Mrays/s (min..max)", "s", "MiB", "a hit",
                            "hits", "roots", "million", "shadow", "median /R", "99.9 % /R", "pixels");
        for (const MethodResult& method : view.methods) text += row(method);
        text += "\n";
    }
    return text;
}

}  // namespace dsphere::report
