// Light along paths, from all kinds of lights, off all kinds of material: docs/light.md.
#include "basis.glsl"
#include "microfacet.glsl"
#include "material.glsl"
#include "light.glsl"
#include "path.glsl"

// Of one of a list's rays, with the direct light of the sample numbers that its `key` gives.
Gathered gatherListed(const Segment segment, const uint key) {
    Numbers numbers;
    numbers.key = key;
    numbers.index = 0;
    Rules rules;
    rules.centre = true;
    rules.shadowed = true;
    rules.weighed = false;
    Path path = startPath(segment, numbers, true);
    extendPath(path, rules);
    return resultOf(path, rules);
}
