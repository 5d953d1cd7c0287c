// First rays of a list: the host has put each into the space of every object, in double.
layout(std430, binding = BINDING_FILM) readonly buffer Rays { QueryRay rays[]; };

Segment listedSegment(const uint index, const float safe_s) {
    Segment segment = firstSegment(safe_s);
    segment.index = index;
    return segment;
}

QueryRay listedRay(const Segment segment, const int k) {
    return rays[segment.index * uint(kObjectCount) + uint(k)];
}

// The filter as a whole needs no more than a float's bits.
Pair listedValue(const real value, const real value_lo) {
    return makePair(value, kSingleFloats ? real(0) : value_lo);
}

Ray firstRay(const Segment segment, const int k, const ObjectData object) {
    QueryRay listed = listedRay(segment, k);
    Line line;
    line.x = listedValue(listed.point.x, listed.point_lo.x);
    line.y = listedValue(listed.point.y, listed.point_lo.y);
    line.z = listedValue(listed.point.z, listed.point_lo.z);
    line.dx = listedValue(listed.direction.x, listed.direction_lo.x);
    line.dy = listedValue(listed.direction.y, listed.direction_lo.y);
    line.dz = listedValue(listed.direction.z, listed.direction_lo.z);
    Ray ray = makeRay(line, real(0), kInfinity, listed.direction.w == 0.0);
    ray.s_min = ray.s_point + listed.point.w;
    ray.s_max = ray.s_point + listed.point_lo.w;
    return ray;
}

vec3 listedStart(const QueryRay listed) {
    return listed.point.xyz + listed.point.w * listed.direction.xyz;
}

// World, from the ray's start to a point of the object's space.
vec3 firstTowards(const Segment segment, const int k, const ObjectData object, const vec3 p) {
    return fromCentre(object, p - listedStart(listedRay(segment, k)));
}

// World, unit.
vec3 firstDirection(const Segment segment) {
    return normalize(fromCentre(first_object, listedRay(segment, 0).direction.xyz));
}

// World, from object 0's centre.
vec3 firstStart(const Segment segment) {
    return fromCentre(first_object, listedStart(listedRay(segment, 0)));
}
