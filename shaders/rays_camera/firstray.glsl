// First rays of the camera, see objects.glsl.

Segment cameraSegment(const vec2 raster, const vec2 jitter, const real safe_s) {
    Segment segment = firstSegment(safe_s);
    segment.raster = raster;
    segment.jitter = jitter;
    return segment;
}

// Pixels from the object's anchor.
vec2 fromAnchor(const Segment segment, const ObjectData object) {
    return segment.raster - vec2(object.anchor_x, object.anchor_y);
}

Ray firstRay(const Segment segment, const int k, const ObjectData object) {
    return cameraRay(object, fromAnchor(segment, object), segment.jitter);
}

// World, from the ray's start to a point of the object's space.
vec3 firstTowards(const Segment segment, const int k, const ObjectData object, const vec3 p) {
    return fromRayStart(object, p, fromAnchor(segment, object) + segment.jitter);
}

// World, unit.
vec3 firstDirection(const Segment segment) {
    Ray ray = firstRay(segment, 0, first_object);
    return normalize(fromCentre(first_object, ray.d));
}

// World, from object 0's centre.
vec3 firstStart(const Segment segment) {
    ObjectData object = first_object;
    vec2 pixel = segment.raster + segment.jitter - vec2(object.anchor_x, object.anchor_y);
    return pixel.x * XYZ(object.start_x) + pixel.y * XYZ(object.start_y) - XYZ(object.from_start);
}
