#pragma once

namespace dsphere {

struct Interval {
    double low, high;
};

}  // namespace dsphere
