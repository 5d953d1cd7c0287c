#include "verify/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace dsphere::verify {

namespace {

constexpr std::size_t kFaultsKept = 8;

double quantile(std::vector<float> values, double share) {
    if (values.empty()) return 0.0;
    std::size_t rank = std::min(std::size_t(std::ceil(share * double(values.size()))), values.size());
    auto place = values.begin() + std::ptrdiff_t(rank == 0 ? 0 : rank - 1);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void append(std::vector<float>& target, const std::vector<float>& source) {
    target.insert(target.end(), source.begin(), source.end());
}

}  // namespace

void Report::merge(Report&& other) {
    rays += other.rays;
    hits += other.hits;
    wrong_verdicts += other.wrong_verdicts;
    later_roots += other.later_roots;
    tangent += other.tangent;
    along_ray_faults += other.along_ray_faults;
    not_finite += other.not_finite;
    runaways += other.runaways;
    shadow_rays += other.shadow_rays;
    wrong_shadows += other.wrong_shadows;
    tangent_shadows += other.tangent_shadows;
    colours += other.colours;
    wrong_colours += other.wrong_colours;
    append(distances, other.distances);
    append(normal_degrees, other.normal_degrees);
    worst_along_ray = std::max(worst_along_ray, other.worst_along_ray);
    worst_colour = std::max(worst_colour, other.worst_colour);
    for (Fault& fault : other.faults) addFault(fault.ray, std::move(fault.what));
}

void Report::addFault(std::uint64_t ray, std::string what) {
    if (faults.size() < kFaultsKept) faults.push_back({ray, std::move(what)});
}

double Report::distanceQuantile(double share) const {
    return quantile(distances, share);
}

double Report::normalQuantile(double share) const {
    return quantile(normal_degrees, share);
}

std::vector<std::string> Report::violations() const {
    std::vector<std::string> lines;
    auto none = [&](std::uint64_t count, const char* what) {
        if (count) lines.push_back(fmt::format("{} {}, none allowed", count, what));
    };
    auto atMost = [&](double value, double bound, const char* what) {
        if (!(value <= bound)) lines.push_back(fmt::format("{} {:.3g}, at most {:.3g} allowed", what, value, bound));
    };
    if (rays == 0) lines.push_back("no ray was compared");
    none(wrong_verdicts, "wrong hit-or-miss verdicts");
    none(later_roots, "later roots taken for the first");
    none(along_ray_faults, "hits too far off along the ray");
    none(not_finite, "values that are not finite");
    none(runaways, "rays stopped by the step limit");
    none(wrong_shadows, "wrong shadow verdicts");
    none(wrong_colours, "wrong colours");
    double tangent_bound = contract::kTangentShare * double(rays) + contract::kTangentFree;
    atMost(double(tangent), tangent_bound, "rays excused as tangent");
    double shadow_bound = contract::kTangentShare * double(shadow_rays) + contract::kTangentFree;
    atMost(double(tangent_shadows), shadow_bound, "shadow rays excused as tangent");
    atMost(distanceQuantile(0.999), contract::kDistance999, "distance to the surface, 99.9 %, in R:");
    atMost(distanceQuantile(1.0), contract::kDistanceAll, "distance to the surface, greatest, in R:");
    atMost(normalQuantile(contract::kNormalShare), contract::kNormalDegrees,
           "angle between normals, 99 %, in degrees:");
    return lines;
}

std::string Report::table() const {
    std::string text;
    auto row = [&](const char* name, const std::string& value, const std::string& bound) {
        text += fmt::format("{:<38} {:>14}   {}\n", name, value, bound);
    };
    auto count = [](std::uint64_t n) { return fmt::format("{}", n); };
    auto real = [](double x) { return fmt::format("{:.3g}", x); };
    row("", "measured", "contract");
    row("rays", count(rays), "");
    row("hits", count(hits), "");
    row("wrong verdicts", count(wrong_verdicts), "0");
    row("later roots", count(later_roots), "0");
    row("tangent rays, excused", count(tangent), real(contract::kTangentShare * double(rays) + contract::kTangentFree));
    row("not finite", count(not_finite), "0");
    row("stopped by the step limit", count(runaways), "0");
    row("distance to surface / R, median", real(distanceQuantile(0.5)), "");
    row("distance to surface / R, 99.9 %", real(distanceQuantile(0.999)), real(contract::kDistance999));
    row("distance to surface / R, greatest", real(distanceQuantile(1.0)), real(contract::kDistanceAll));
    row("error along the ray / its bound", real(worst_along_ray), "1");
    row("normals, 99 %, degrees", real(normalQuantile(contract::kNormalShare)), real(contract::kNormalDegrees));
    row("shadow rays", count(shadow_rays), "");
    row("wrong shadows", count(wrong_shadows), "0");
    row("tangent shadow rays, excused", count(tangent_shadows),
        real(contract::kTangentShare * double(shadow_rays) + contract::kTangentFree));
    row("colours", count(colours), "");
    row("wrong colours", count(wrong_colours), "0");
    row("error of colours / its bound", real(worst_colour), "1");
    return text;
}

nlohmann::ordered_json Report::json() const {
    nlohmann::ordered_json json = {{"passed", passed()},
                                   {"rays", rays},
                                   {"hits", hits},
                                   {"wrong_verdicts", wrong_verdicts},
                                   {"later_roots", later_roots},
                                   {"tangent", tangent},
                                   {"along_ray_faults", along_ray_faults},
                                   {"not_finite", not_finite},
                                   {"runaways", runaways},
                                   {"distance_median", distanceQuantile(0.5)},
                                   {"distance_999", distanceQuantile(0.999)},
                                   {"distance_greatest", distanceQuantile(1.0)},
                                   {"along_ray_share_of_bound", worst_along_ray},
                                   {"normal_degrees_99", normalQuantile(contract::kNormalShare)},
                                   {"shadow_rays", shadow_rays},
                                   {"wrong_shadows", wrong_shadows},
                                   {"tangent_shadows", tangent_shadows},
                                   {"colours", colours},
                                   {"wrong_colours", wrong_colours},
                                   {"colour_share_of_bound", worst_colour},
                                   {"violations", violations()}};
    json["faults"] = nlohmann::ordered_json::array();
    for (const Fault& fault : faults) json["faults"].push_back({{"ray", fault.ray}, {"what", fault.what}});
    return json;
}

}  // namespace dsphere::verify
