// Everything up to the hit of a ray with one object, and its colour there.
#include "lookups.glsl"
#include "numeric.glsl"
#include "surface.glsl"
#ifdef WITH_CURVED
#include "curved.glsl"
#endif
#include "ray.glsl"
#include "frame.glsl"
#include "walk.glsl"
#include "march.glsl"
#include "filter.glsl"
#ifdef WITH_CURVED
#include "curvedstroll.glsl"
#endif
#include "hit.glsl"
#include "naive.glsl"
#include "objects.glsl"
#include "colour.glsl"
