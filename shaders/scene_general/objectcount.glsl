// The scene has any objects. A single one is met by the loops over several: scene_planet has code of its own for most of these,
// and it would make these shaders half as large again.
const bool kOneObject = false;
layout(constant_id = SPEC_OBJECT_COUNT) const int kObjectCount = 1;
layout(constant_id = SPEC_ONLY_DISPLACED) const int kOnlyDisplaced = -1;
layout(constant_id = SPEC_ONLY_PLAIN) const int kOnlyPlain = -1;
layout(constant_id = SPEC_KINDS) const int kKinds = 1;
