// Pixels of one tile, or of the list of pixels to retry: their rays, the nearest hits, the film's planes. Expects what
// render.comp declares: the film, the list and the parameters that are pushed.

const uint kColourPlanes = 7u << PLANE_R;
const bool kWantsColour = (kPlanes & kColourPlanes) != 0u;
const bool kWantsLight = (kPlanes & (kColourPlanes | 7u << PLANE_ALBEDO_R | 1u << PLANE_LIT)) != 0u;

#include "uniforms.glsl"
#include "sample.glsl"
#include "shade.glsl"
#include "lighting.glsl"
#include "retry.glsl"

bool wants(const int plane) {
    return (kPlanes & (1u << plane)) != 0u;
}

// Layers hold the planes of the mask in order. Images keep bits as they are, so floats travel as bits.
void put(const ivec2 pixel, const int plane, const uint bits) {
    if (wants(plane)) imageStore(film, ivec3(pixel, bitCount(kPlanes & ((1u << plane) - 1u))), uvec4(bits));
}

void put(const ivec2 pixel, const int plane, const real value) {
    put(pixel, plane, floatBitsToUint(value));
}

void put(const ivec2 pixel, const int plane, const vec3 value) {
    put(pixel, plane, value.x);
    put(pixel, plane + 1, value.y);
    put(pixel, plane + 2, value.z);
}

// What the samples before have added up to; films that accumulate hold R, G and B, and perhaps A.
real storedSum(const ivec2 pixel, const int plane) {
    return uintBitsToFloat(imageLoad(film, ivec3(pixel, plane)).x);
}

vec3 storedColour(const ivec2 pixel) {
    return vec3(storedSum(pixel, PLANE_R), storedSum(pixel, PLANE_G), storedSum(pixel, PLANE_B));
}

void putAlpha(const ivec2 pixel, const real alpha, const int sample_index) {
    if (!wants(PLANE_A)) return;
    put(pixel, PLANE_A, sample_index > 0 ? storedSum(pixel, PLANE_A) + alpha : alpha);
}

void putGeometry(const ivec2 pixel, const SurfacePoint point) {
    vec3 nothing = vec3(real(0));
    vec3 p = point.hit ? point.object_position : nothing;
    put(pixel, PLANE_T, point.hit ? point.t : uintBitsToFloat(0x7f800000u));
    put(pixel, PLANE_PX, point.hit ? point.position : nothing);
    put(pixel, PLANE_NX, point.hit ? point.normal : nothing);
    put(pixel, PLANE_NSX, point.hit ? shadingNormal(point) : nothing);
    if (wants(PLANE_U) || wants(PLANE_V)) {
        vec2 uv = point.hit ? pointUv(point, kKinds) : vec2(real(0));
        put(pixel, PLANE_U, uv.x);
        put(pixel, PLANE_V, uv.y);
    }
    put(pixel, PLANE_ID, uint(point.object + 1));
    put(pixel, PLANE_STEPS, point.hit ? uint(point.steps) : 0u);
    put(pixel, PLANE_RESIDUAL, point.hit ? point.residual : real(0));
    put(pixel, PLANE_OBJECT_PX, p);
    put(pixel, PLANE_START_X, point.hit ? point.start : nothing);
    put(pixel, PLANE_FLAGS, (point.inside ? 1u : 0u) | (point.exhausted ? 2u : 0u));
}

// A pixel of the film that an invocation is to do, if it `exists`.
struct Task {
    ivec2 pixel;
    real safe_s;  // RetryPixel::safe_s
    bool exists;
};

Task findRetryTask() {
    Task task;
    RetryPixel found = findRetry(task.exists);
    task.pixel = ivec2(found.pixel & 0xffffu, found.pixel >> 16);
    task.safe_s = found.safe_s;
    return task;
}

// An invocation's n-th. A group's lie side by side, and eight lanes in a row have 4 x 2 pixels, whose rays differ less than
// those of 8 x 1 (rule L10).
Task findTask(const int n) {
    if (kIsRetry) return findRetryTask();
    ivec2 lane = ivec2(XY(gl_LocalInvocationID));
    ivec2 within = ivec2((lane.x & 3) | (lane.y & 1) << 2, (lane.y & 6) | lane.x >> 2);
    ivec2 block = ivec2(int(gl_WorkGroupID.x) * kTasks + n, int(gl_WorkGroupID.y * gl_NumWorkGroups.z + gl_WorkGroupID.z));
    Task task;
    task.pixel = ivec2(params.tile_x, params.tile_y) + block * ivec2(GROUP_SIZE_X, GROUP_SIZE_Y) + within;
    task.safe_s = -kInfinity;
    task.exists = all(lessThan(task.pixel, ivec2(params.tile_x1, params.tile_y1)));
    if (kTiles != 0) {
        bool in_list;
        uint pixel = findListed(in_list);
        bool listed = takesListed();
        task.pixel = listed ? ivec2(pixel & 0xffffu, pixel >> 16) : task.pixel;
        task.exists = listed ? in_list && n == 0 : task.exists;
    }
    return task;
}

uint pixelBits(const ivec2 pixel) {
    return uint(pixel.x) | uint(pixel.y) << 16;
}

void leaveForRetry(const ivec2 pixel, const real safe_s) {
    leaveForRetry(pixelBits(pixel), safe_s);
}

// Film planes of a pixel whose ray, or another that it needs, is in doubt are left to the retry, which has 48 bits.
void finish(const Task task, const Gathered gathered, const int sample_index) {
    if (missesTile()) {
        leaveForTile(pixelBits(task.pixel));
        absent_tile = -1;  // the invocation's next pixel may have all of its own
        given_up = false;
        return;
    }
    countGivenUp();
    if (gathered.searches.doubtful) {
        leaveForRetry(task.pixel, gathered.point.safe_s);
        return;
    }
    putGeometry(task.pixel, gathered.point);
    putAlpha(task.pixel, gathered.point.hit ? gathered.weight : real(0), sample_index);
    put(task.pixel, PLANE_ALBEDO_R, gathered.albedo);
    put(task.pixel, PLANE_LIT, gathered.lit);
    if (kWantsColour)
        put(task.pixel, PLANE_R, sample_index > 0 ? storedColour(task.pixel) + gathered.colour : gathered.colour);
}

// Chosen by pixel, although it is the same for all: see uniforms.glsl.
int sampleOf(const Task task) {
    return task.pixel.x >= 0 ? params.sample_index : 0;
}

ivec2 rasterOf(const Task task) {
    return task.pixel + ivec2(params.film_x, params.film_y);
}

#include "main.glsl"
