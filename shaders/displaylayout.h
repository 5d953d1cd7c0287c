// What the viewer and display.comp share.
#ifndef DSPHERE_DISPLAYLAYOUT_H
#define DSPHERE_DISPLAYLAYOUT_H

#ifdef __cplusplus
#include <cstdint>
namespace dsphere::layout {
using uint = std::uint32_t;
#endif

#define DISPLAY_GROUP 8

#define SHOW_COLOUR 0
#define SHOW_STEPS 1
#define SHOW_DISTANCE 2
#define SHOW_NORMAL 3
#define SHOW_UV 4
#define SHOW_ALBEDO 5
#define SHOW_RESIDUAL 6

struct DisplayParams {
    int width, height;     // of the picture, from the film's first pixel
    uint layer, id_layer;  // of the film: where the values begin, and the shapes' (not of SHOW_COLOUR)
    float gain;            // SHOW_COLOUR: of the stored sums
    float low, high;       // the values that the scale of colours begins and ends at; of SHOW_RESIDUAL their log2
};

#ifdef __cplusplus
static_assert(sizeof(DisplayParams) == 28);
}  // namespace dsphere::layout
#endif
#endif
