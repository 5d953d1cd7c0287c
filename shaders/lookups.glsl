// What the kernel asks of the scene and looks up in its images, behind the names that the other functions expect.

bool sceneHasLight(const int kind) {
    return (kLightKinds & (1 << kind)) != 0;
}

bool isLight(const LightData light, const int kind) {
    return kLightKinds == 1 << kind || (sceneHasLight(kind) && light.kind == kind);
}

// Storage images, not textures: filtering may snap weights to 8 bits, and on lavapipe a load costs half a texelFetch.
real heightAt(const MapData map, const int column, const int row) {
    // Only levels of detail do not start at the image's left edge.
    int x = kDetail > real(0) ? map.heights_x + column : column;
    return imageLoad(heights, ivec3(x, map.heights_y + row, map.layer)).x;
}

#ifdef WITH_CURVED
vec4 nodeAt(const MapData map, const int column, const int row) {
    return imageLoad(nodes, ivec3(column, map.nodes_y + row, map.nodes_layer));
}
#endif

// Levels above the finest lie side by side below it, each face in 1.5 side rows.
int faceRow(const MapData map, const int axis, const real sign_of_face) {
    int face = axis * 2 + (sign_of_face < real(0) ? 1 : 0);
    return map.bounds_y + face * (map.bounds_side + (map.bounds_side >> 1));
}

real boundAt(const MapData map, const int face_row, const int side, const int i, const int j) {
    bool finest = side == map.bounds_side;
    int x = i + (finest ? 0 : map.bounds_side - 2 * side);
    int y = face_row + j + (finest ? 0 : map.bounds_side);
    return imageLoad(bounds, ivec3(x, y, map.bounds_layer)).x;
}

vec4 edgesAt(const int x, const int y) {
    return imageLoad(edges, ivec3(x, y, 0));
}

uint imageWord(const int x, const int y, const int layer) {
    return imageLoad(images, ivec3(x, y, layer)).x;
}

real imageFloat(const int x, const int y, const int layer) {
    return uintBitsToFloat(imageWord(x, y, layer));
}

// The light of a texel at (x, y) of a layer: the only place that knows how images of `height` rows lie on the device.
vec3 placedTexel(const int image, const int x, const int y, const int layer, const int height) {
    if (image == IMAGE_CODES) {
        uint codes = imageWord(x, y, layer);
        return vec3(imageFloat(int(codes & 255u), 0, 0), imageFloat(int(codes >> 8 & 255u), 0, 0),
                    imageFloat(int(codes >> 16), 0, 0));
    }
    return vec3(imageFloat(x, y, layer), imageFloat(x, y + height, layer), imageFloat(x, y + 2 * height, layer));
}

vec3 imageTexel(const ObjectData o, const int column, const int row) {
    return placedTexel(o.image, column, o.image_y + row, o.image_layer, o.image_height);
}

// The leading 12 bits of x; a product of two such values is exact.
real leadingBits(const real x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}
