// The scene has any objects.
layout(constant_id = SPEC_OBJECT_COUNT) const int kObjectCount = 1;
layout(constant_id = SPEC_ONLY_DISPLACED) const int kOnlyDisplaced = -1;
layout(constant_id = SPEC_ONLY_PLAIN) const int kOnlyPlain = -1;
layout(constant_id = SPEC_KINDS) const int kKinds = 1;
