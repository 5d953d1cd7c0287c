#include "report/baseline.h"

#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>

namespace dsphere::report {

namespace {

const MethodResult* find(const Results& results, const ViewResult& view, const std::string& method) {
    for (const ViewResult& other : results.views) {
        bool same = other.map == view.map && other.percent == view.percent && other.view == view.view &&
                    other.width == view.width && other.height == view.height;
        if (!same) continue;
        auto found = std::ranges::find(other.methods, method, &MethodResult::method);
        if (found != other.methods.end() && found->skipped.empty()) return &*found;
    }
    return nullptr;
}

std::string percent(double now, double before) {
    return before > 0.0 ? fmt::format("{:+.1f} %", 100.0 * (now / before - 1.0)) : std::string("-");
}

// A star where the two ranges do not even touch: more than noise.
std::string change(const Spread& now, const Spread& before) {
    if (!now.measured() || !before.measured()) return "-";
    bool apart = now.least > before.greatest || now.greatest < before.least;
    return percent(now.median, before.median) + (apart ? " *" : "  ");
}

std::string errorChange(const MethodResult& now, const MethodResult& before) {
    if (!now.accuracy || !before.accuracy) return "-";
    return fmt::format("{:.2g} -> {:.2g}", before.accuracy->distance_999, now.accuracy->distance_999);
}

std::uint64_t wrongs(const MethodResult& method) {
    return method.accuracy ? method.accuracy->wrong_verdicts + method.accuracy->later_roots : 0;
}

constexpr const char* kChangeRow = "  {:<14} {:>11} {:>11} {:>11} {:>9} {:>20} {:>12}\n";

std::string row(const MethodResult& now, const MethodResult& before) {
    return fmt::format(fmt::runtime(kChangeRow), now.method, change(now.primary.device, before.primary.device),
                       change(now.shadow.device, before.shadow.device), change(now.setup_seconds, before.setup_seconds),
                       percent(double(now.memory_bytes), double(before.memory_bytes)), errorChange(now, before),
                       fmt::format("{} -> {}", wrongs(before), wrongs(now)));
}

}  // namespace

std::string changes(const Results& now, const Results& before) {
    std::string text = fmt::format("Change since {} (commit {}); * beyond the spread of both\n",
                                   before.environment.date, before.environment.commit);
    auto warn = [&](const char* what, const std::string& a, const std::string& b) {
        if (a != b) text += fmt::format("another {}: {} then, {} now\n", what, b, a);
    };
    warn("CPU", now.environment.cpu, before.environment.cpu);
    warn("device", now.environment.device, before.environment.device);
    warn("driver", now.environment.driver, before.environment.driver);
    bool any = false;
    for (const ViewResult& view : now.views) {
        std::string rows;
        for (const MethodResult& method : view.methods)
            if (const MethodResult* old = find(before, view, method.method); old && method.skipped.empty())
                rows += row(method, *old);
        if (rows.empty()) continue;
        any = true;
        text += fmt::format("{}, {}\n", caseName(view), view.view);
        text += fmt::format(fmt::runtime(kChangeRow), "", "primary", "shadow", "set-up", "memory",
                            "99.9 % distance / R", "wrong hits");
        text += rows;
    }
    return any ? text : text + "no view and method in common\n";
}

}  // namespace dsphere::report
