#include "report/statistics.h"

#include <algorithm>

namespace dsphere::report {

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    std::size_t middle = values.size() / 2;
    double median = values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {median, values.front(), values.back(), int(values.size())};
}

Spread ratesOf(double work, const std::vector<double>& seconds) {
    std::vector<double> rates;
    for (double time : seconds)
        if (time > 0.0) rates.push_back(work / time);
    if (!rates.empty()) rates.resize(seconds.size(), std::ranges::max(rates));
    return spreadOf(std::move(rates));
}

}  // namespace dsphere::report
