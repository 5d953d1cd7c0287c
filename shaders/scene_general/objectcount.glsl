// The scene has any objects. A single one is met by the loops over several, as the code for one alone, which scene_planet has
// for most such scenes, would double these shaders.
const bool kOneObject = false;
layout(constant_id = SPEC_OBJECT_COUNT) const int kObjectCount = 1;
layout(constant_id = SPEC_ONLY_DISPLACED) const int kOnlyDisplaced = -1;
layout(constant_id = SPEC_ONLY_PLAIN) const int kOnlyPlain = -1;
layout(constant_id = SPEC_KINDS) const int kKinds = 1;
