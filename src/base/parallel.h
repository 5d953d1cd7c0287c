#pragma once

#include <cstddef>
#include <functional>

namespace dsphere {

/// Runs `body(i)` once for each i in [0, count) on all cores; the order is free. Chunks are handed out dynamically.
/// An exception thrown by a body is rethrown here after all threads have stopped.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace dsphere
