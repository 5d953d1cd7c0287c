#include "report/format.h"

#include <fmt/format.h>

namespace dsphere::report {

namespace {

// Three leading digits: "0.123", "12.3", "1234".
std::string threeDigits(double value) {
    int decimals = value < 1.0 ? 3 : value < 10.0 ? 2 : value < 100.0 ? 1 : 0;
    return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace

std::string caseName(const ViewResult& view) {
    return fmt::format("{}, {:.3g} %", view.map, view.percent);
}

std::string megaRays(const Spread& rate) {
    if (!rate.measured()) return "-";
    return fmt::format("{} ({}..{})", threeDigits(rate.median * 1e-6), threeDigits(rate.least * 1e-6),
                       threeDigits(rate.greatest * 1e-6));
}

std::string megaRaysMedian(const Spread& rate) {
    return rate.measured() ? threeDigits(rate.median * 1e-6) : "-";
}

std::string seconds(const Spread& spread) {
    return spread.measured() ? threeDigits(spread.median) : "-";
}

std::string mebibytes(std::uint64_t bytes) {
    return threeDigits(double(bytes) / 1048576.0);
}

std::string wrongOfAMillion(const MethodResult& method) {
    if (!method.accuracy || method.accuracy->rays == 0) return "-";
    const Accuracy& of = *method.accuracy;
    return fmt::format("{:.0f}", 1e6 * double(of.wrong_verdicts + of.later_roots) / double(of.rays));
}

std::string fetches(const MethodResult& method) {
    return method.fetches_per_hit > 0.0 ? fmt::format("{:.1f}", method.fetches_per_hit) : "-";
}

}  // namespace dsphere::report
