#pragma once

// The shaders' kernel compiled as C++ (kernel.cpp), once for each shader variant and precision.

#include "host/hostscene.h"
#include "host/precision.h"
#include "render/specialization.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dsphere::host {

/// A film as the device has it: planes of 32-bit words, in layers.
struct HostFilm {
    int width = 0, height = 0;
    std::vector<std::uint32_t> words;

    std::uint32_t& at(int x, int y, int layer) {
        return words[(std::size_t(layer) * std::size_t(height) + std::size_t(y)) * std::size_t(width) + std::size_t(x)];
    }
};

/// Fills the planes of a tile's pixels; tiles that share no pixel may be filled at once. A kernel of search_filter
/// leaves pixels in `retry`, which one of search_full takes; that takes nothing of the tile but the sample. Returned:
/// RenderStats::given_up_pixels of the tile.
using FillFunction = std::uint32_t(const HostScene& scene, const Specialization& specialization,
                                   const layout::RenderParams& tile, HostFilm& film,
                                   std::vector<layout::RetryPixel>& retry);
using FillTile = FillFunction*;

/// What fills a scene's pictures: `first`, then `full` (null: there is none) what it left.
struct Kernels {
    FillTile first = nullptr, full = nullptr;
};

/// Traces rays against object 0, each into the hit of its place.
using ProbeFunction = void(const HostScene& scene, const Specialization& specialization,
                           std::span<const layout::ProbeRay> rays, std::span<layout::ProbeHit> hits);
using ProbeRays = ProbeFunction*;

ProbeRays probeFor(const SceneTraits& traits, Precision precision);
Kernels kernelsFor(const SceneTraits& traits, const MarchMethod& method, Precision precision);

}  // namespace dsphere::host
