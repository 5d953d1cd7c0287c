// What the viewer and display.comp share.
#ifndef DSPHERE_DISPLAYLAYOUT_H
#define DSPHERE_DISPLAYLAYOUT_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace dsphere::layout {
using uint = std::uint32_t;
using vec4 = glm::vec4;
#endif

#define DISPLAY_GROUP 8

#define SHOW_COLOUR 0
#define SHOW_HEIGHTS 1
#define SHOW_SLOPE 2
#define SHOW_GRATICULE 3
#define SHOW_DISTANCE 4
#define SHOW_NORMAL 5
#define SHOW_UV 6
#define SHOW_ALBEDO 7
#define SHOW_STEPS 8
#define SHOW_RESIDUAL 9

#define DISPLAY_OBJECTS 64

struct DisplayParams {
    int width, height;     // of the picture, from the film's first pixel
    uint layer, id_layer;  // of the film: where the values begin, and the shapes' (not of SHOW_COLOUR)
    uint place_layer;      // where world positions begin, of SHOW_s that need them
    float gain;            // of the stored sums of light
    float low, high;       // the values that the scale of colours begins and ends at; of SHOW_RESIDUAL their log2
    float spacing;         // of lines: degrees (SHOW_GRATICULE), heights (SHOW_HEIGHTS)
    float gain_ahead;  // instead of gain, where a sample that is half done is in the sums already: left of ahead_x0,
    int ahead_x0, ahead_x1, ahead_y0, ahead_y1, ahead_x;  // and left of ahead_x1 before (ahead_x, ahead_y0 to ahead_y1)
};

// What is known of an object beyond the film. Displaced spheres alone have heights.
struct DisplayObject {
    vec4 centre;       // xyz: world; w: the mean radius of a displaced sphere, object units; 0: another shape
    vec4 to_object_x;  // rows of world -> object, without the shift. w: the radius of the stored value 0
    vec4 to_object_y;  // w: units of height per unit of length
    vec4 to_object_z;  // w: the height that the stored value 0 means
};

#ifdef __cplusplus
static_assert(sizeof(DisplayParams) == 60);
struct DisplayWorld {
    DisplayObject objects[DISPLAY_OBJECTS];
};
static_assert(sizeof(DisplayWorld) == 64 * DISPLAY_OBJECTS);
}  // namespace dsphere::layout
#endif
#endif
