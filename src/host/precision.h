#pragma once

namespace dsphere::host {

/// `real` of the kernel.
enum class Precision { Float, Double };

}  // namespace dsphere::host
