#pragma once

#include "base/image.h"
#include "render/pack.h"

#include <vector>

namespace dsphere {

/// Pixels [x0, x1) of one row; empty if x0 >= x1.
struct Span {
    int x0 = 0, x1 = 0;

    bool empty() const { return x0 >= x1; }
};

/// For each row of `box` (raster pixels) the span that holds every ray, up to `reach` pixels from a pixel's centre (0.5
/// or more), that can come near an object on its way; x counts from the box's left edge. All other pixels miss. On SIMD
/// devices a group that misses costs almost what one that hits does, since loops run their body once under an empty
/// mask.
std::vector<Span> objectSpans(const std::vector<PackedObject>& objects, const Box& box, double reach = 0.5);

/// The pixels of a picture that may not be black: those spans, or all pixels under an infinite light that shows.
std::vector<Span> shownSpans(const SceneTraits& traits, const std::vector<PackedObject>& objects, const Box& crop);

}  // namespace dsphere
