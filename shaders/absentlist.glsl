// The list of what waits for a tile, and of what is to be done again now that its tile is there.
layout(std430, binding = BINDING_ABSENT) buffer Absent {
    AbsentHead absent;
    AbsentPixel absent_pixels[];
};
