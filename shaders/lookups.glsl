// What the kernel asks of the scene and looks up in its images, behind the names that the other functions expect.

bool isLight(const LightData light, const int kind) {
    return isAmong(light.kind, kind, kLightKinds);
}

// Storage images, not textures (rule L5): filters may round weights to 8 bits, and on lavapipe a load costs half a texelFetch.
real heightAt(const MapData map, const int column, const int row) {
    // Only levels of detail do not start at the image's left edge.
    int x = kDetail > real(0) ? map.heights_x + column : column;
    return imageLoad(heights, ivec3(x, map.heights_y + row, map.layer)).x;
}

// The first tile that a search missed, -1: none. What follows from its heights, which are NaN, means nothing.
int absent_tile = -1;

bool missesTile() {
    return kTiles != 0 && absent_tile >= 0;
}

// Whether MAX_STEPS has ended a search for the invocation's pixel.
bool given_up = false;

void giveUp() {
    given_up = true;
}

// The sample at a column of a tile's row, which begins at `start` (x in words).
real tileSample(const MapData map, const ivec3 start, const int column) {
    bool wide = map.samples == SAMPLES_FLOAT;
    uint word = imageLoad(tiles, start + ivec3(wide ? column : column >> 1, 0, 0)).x;
    uint code = (column & 1) == 0 ? word & 0xffffu : word >> 16;
    int signed_code = int(code) - (map.samples == SAMPLES_INT16 && code > 0x7fffu ? 0x10000 : 0);
    return wide ? uintBitsToFloat(word) : real(signed_code);
}

const int kTileMargin = kTiles == 2 ? TILE_MARGIN : 0;

// Where a cell's north-west node lies in the tiles image: its row's tile begins at the column, in words, that x is. Of an
// absent tile, which is noted: somewhere.
ivec3 tilePlace(const MapData map, const ivec2 cell, OUT(bool) present) {
    int side = 1 << map.tile_shift;
    ivec2 tile = ivec2(cell.x >> map.tile_shift, cell.y >> map.tile_shift);
    uint place = imageLoad(tiles, ivec3(tile.x, map.table_y + tile.y, 0)).x;
    present = place != NO_TILE;
    if (!present && absent_tile < 0) absent_tile = map.first_tile + tile.y * ((map.width + side - 1) >> map.tile_shift) + tile.x;
    place = present ? place : 0u;
    int rows_above = int(place >> 8 & 255u) * (side + 1 + 2 * kTileMargin) + kTileMargin;
    return ivec3(int(place & 255u) * map.tile_words, map.tiles_y + rows_above + (cell.y & (side - 1)), int(place >> 16));
}

// A cell's column in its tile's rows.
int columnInTile(const MapData map, const ivec2 cell) {
    return (cell.x & ((1 << map.tile_shift) - 1)) + kTileMargin;
}

// cornersAt() of a map in tiles.
vec4 tileCorners(const MapData map, const ivec2 cell) {
    bool present;
    ivec3 north = tilePlace(map, cell, present);
    ivec3 south = north + ivec3(0, 1, 0);
    int column = columnInTile(map, cell);
    vec4 corners = vec4(tileSample(map, north, column), tileSample(map, north, column + 1),
                        tileSample(map, south, column), tileSample(map, south, column + 1));
    if (cell.y == 0) corners = vec4(map.north_pole, map.north_pole, corners.z, corners.w);
    if (cell.y == map.rows - 1) corners = vec4(corners.x, corners.y, map.south_pole, map.south_pole);
    return present ? corners : vec4(uintBitsToFloat(0x7fc00000u));
}

// Stored values of the nodes about a cell: the rows above it, of its north and south corners, and below, from one column
// before it to one behind.
struct Controls {
    vec4 above, north, south, below;
};

vec4 tileControls(const MapData map, const ivec3 row, const int column) {
    return vec4(tileSample(map, row, column - 1), tileSample(map, row, column), tileSample(map, row, column + 1),
                tileSample(map, row, column + 2));
}

// Of a map in tiles, as a spline has them: beyond the first and last row of texels they repeat (so does the file, as read);
// beyond a pole of a gridline map, whose row holds the pole's value, they are mirrored through it.
Controls controlsAt(const MapData map, const ivec2 cell) {
    bool present;
    ivec3 row = tilePlace(map, cell, present);
    int column = columnInTile(map, cell);
    Controls of;
    of.above = tileControls(map, row - ivec3(0, 1, 0), column);
    of.north = tileControls(map, row, column);
    of.south = tileControls(map, row + ivec3(0, 1, 0), column);
    of.below = tileControls(map, row + ivec3(0, 2, 0), column);
    vec4 north_pole = vec4(real(map.north_pole));
    vec4 south_pole = vec4(real(map.south_pole));
    bool gridline = map.caps == 0;
    if (gridline && cell.y == 0) {
        of.north = north_pole;
        of.above = real(2) * north_pole - of.south;
    }
    if (gridline && cell.y == 1) of.above = north_pole;
    if (gridline && cell.y == map.rows - 1) {
        of.south = south_pole;
        of.below = real(2) * south_pole - of.north;
    }
    if (gridline && cell.y == map.rows - 2) of.below = south_pole;
    if (!present) of.north = vec4(uintBitsToFloat(0x7fc00000u));
    return of;
}

// Stored values at the corners of a cell: north-west, north-east, south-west, south-east.
vec4 cornersAt(const MapData map, const ivec2 cell) {
    if (kTiles != 0 && map.tile_shift != 0) return tileCorners(map, cell);
    int next = cell.x + 1 == map.width ? 0 : cell.x + 1;
    return vec4(heightAt(map, cell.x, cell.y), heightAt(map, next, cell.y), heightAt(map, cell.x, cell.y + 1),
                heightAt(map, next, cell.y + 1));
}

vec4 nodeAt(const MapData map, const int column, const int row) {
    return imageLoad(nodes, ivec3(column, map.nodes_y + row, map.nodes_layer));
}

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

// Squared tangent of the angle above which a ray that starts in a cell of the horizons meets nothing, and the squared least
// radius that it has to start at. They lie beside the coarser levels (Bounds, src/surface/bounds.h).
vec2 horizonAt(const MapData map, const int face_row, const int i, const int j) {
    int quarter = map.bounds_side >> 2;
    ivec3 place = ivec3(2 * quarter + i, face_row + map.bounds_side + quarter + j, map.bounds_layer);
    return vec2(imageLoad(bounds, place).x, imageLoad(bounds, place + ivec3(quarter, 0, 0)).x);
}

vec4 edgesAt(const int x, const int y) {
    if (kTiles == 0) return imageLoad(edges, ivec3(x, y, 0));
    // Rows longer than an image may be go on EDGE_ROWS below.
    return imageLoad(edges, ivec3(x % EDGE_COLUMNS, y + x / EDGE_COLUMNS * EDGE_ROWS, 0));
}

uint imageWord(const int x, const int y, const int layer) {
    return imageLoad(images, ivec3(x, y, layer)).x;
}

real imageFloat(const int x, const int y, const int layer) {
    return uintBitsToFloat(imageWord(x, y, layer));
}

// The light of a texel at (x, y) of a layer: the only place that knows how images of `height` rows lie on the device.
vec3 placedTexel(const int image, const int x, const int y, const int layer, const int height) {
    // No branch: lavapipe would run both sides of it.
    uint word = imageWord(x, y, layer);
    bool coded = image == IMAGE_CODES;
    ivec3 red = coded ? ivec3(int(word & 255u), 0, 0) : ivec3(x, y, layer);
    int green = coded ? int(word >> 8 & 255u) : x;
    int blue = coded ? int(word >> 16) : x;
    int rows = coded ? 0 : height;
    return vec3(imageFloat(red.x, red.y, red.z), imageFloat(green, red.y + rows, red.z), imageFloat(blue, red.y + 2 * rows, red.z));
}

vec3 imageTexel(const ObjectData o, const int column, const int row) {
    return placedTexel(o.image, column, o.image_y + row, o.image_layer, o.image_height);
}

// The leading 12 bits of x; a product of two such values is exact.
real leadingBits(const real x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}
