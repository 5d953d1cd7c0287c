// The fields of every struct of shaders/layout.h, in order, once for the host and the shader: V a vec4, F a float, I an
// int, U a uint.

#define OBJECT_FIELDS(V, F, I) \
    V(point_0)                 \
    V(point_0_lo)              \
    V(point_x)                 \
    V(point_x_lo)              \
    V(point_y)                 \
    V(point_y_lo)              \
    V(direction_0)             \
    V(direction_0_lo)          \
    V(direction_x)             \
    V(direction_x_lo)          \
    V(direction_y)             \
    V(direction_y_lo)          \
    V(to_object_x)             \
    V(to_object_y)             \
    V(to_object_z)             \
    V(to_world_x)              \
    V(to_world_y)              \
    V(to_world_z)              \
    V(from_start)              \
    V(start_x)                 \
    V(start_y)                 \
    V(from_first)              \
    V(albedo)                  \
    F(anchor_x)                \
    F(anchor_y)                \
    F(base)                    \
    F(base_lo)                 \
    F(scale)                   \
    F(ramp_offset)             \
    F(ramp_scale)              \
    F(shell_squared)           \
    F(inner_squared)           \
    F(offset)                  \
    I(kind)                    \
    I(ramp)                    \
    V(image_north)             \
    V(image_south)             \
    I(image)                   \
    I(image_width)             \
    I(image_height)            \
    I(image_y)                 \
    I(image_layer)             \
    I(image_centres_y)         \
    F(image_shift) F(pixel_size) F(pixel_growth) I(first_triangle) I(triangle_count) F(mean_radius) V(texture_scale)

#define LIGHT_FIELDS(V, F, I) \
    V(position)               \
    V(radiance)               \
    V(x_axis)                 \
    V(y_axis)                 \
    V(z_axis)                 \
    I(kind)                   \
    I(object)                 \
    F(share)                  \
    F(shares)                 \
    F(inner_squared)          \
    F(measure) I(two_sided) I(width) I(height) I(image_y) I(image_layer) I(image) I(table) I(pad0) I(pad1) I(pad2)

#define MATERIAL_FIELDS(V, F, I) \
    V(odd)                       \
    V(specular)                  \
    V(eta)                       \
    V(k)                         \
    V(bounced)                   \
    I(kind)                      \
    I(checkerboard) F(u_scale) F(v_scale) F(alpha) F(rough_a) F(rough_b) I(table) I(light) I(pad0) I(pad1) I(pad2)

#define TRIANGLE_FIELDS(V) V(a) V(b) V(c) V(v)

#define MAP_FIELDS(F, I)  \
    I(width)              \
    I(rows)               \
    I(heights_x)          \
    I(heights_y)          \
    I(layer)              \
    I(bounds_y)           \
    I(bounds_layer)       \
    I(bounds_side)        \
    I(start_side)         \
    I(edges_y)            \
    I(caps)               \
    F(columns_per_turn)   \
    F(first_column)       \
    F(cells_per_radian_u) \
    F(cells_per_radian_v) \
    F(cap_shift)          \
    F(tan_width)          \
    F(tan_height)         \
    F(sin_width)          \
    F(versin_width)       \
    F(sin_height)         \
    F(versin_height)      \
    F(sin_cap)            \
    F(versin_cap)         \
    F(least_pixel)        \
    I(surface)            \
    I(cap_rows)           \
    I(nodes_y)            \
    I(nodes_layer)        \
    I(smooth_normals)     \
    F(phase_u)            \
    F(phase_v)            \
    I(tile_shift)         \
    I(table_y)            \
    I(tiles_y)            \
    I(first_tile)         \
    I(tile_words)         \
    I(samples)            \
    F(north_pole)         \
    F(south_pole)

#define PROBE_RAY_FIELDS(V, U) V(point) V(point_lo) V(direction) V(direction_lo) U(flags) U(pad0) U(pad1) U(pad2)

#define PROBE_HIT_FIELDS(V, U) V(position) V(normal) U(flags) U(steps) U(pad0) U(pad1)

#define PARAMS_FIELDS(I, U) I(tile_x) I(tile_y) I(tile_x1) I(tile_y1) I(film_x) I(film_y) I(sample_index) U(seed)
