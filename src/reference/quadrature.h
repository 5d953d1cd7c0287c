#pragma once

#include <vector>

namespace dsphere::reference {

/// Gauss and Legendre's rule with `count` nodes on [0, 1]: the weights sum to 1.
struct GaussLegendre {
    std::vector<double> nodes, weights;

    explicit GaussLegendre(int count);

    template <typename F>
    double integral(double from, double to, F f) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < nodes.size(); ++k) sum += weights[k] * f(from + (to - from) * nodes[k]);
        return (to - from) * sum;
    }
};

}  // namespace dsphere::reference
