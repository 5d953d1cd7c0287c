// The scene is a displaced sphere alone.
const bool kOneObject = true;
const int kObjectCount = 1;
const int kOnlyDisplaced = 0;
const int kOnlyPlain = -1;
const int kKinds = 1 << KIND_DISPLACED;
