// The entries of retrylist.glsl and absentlist.glsl.

// How many a workgroup does.
const uint kRetryGroup = uint(GROUP_SIZE_X * GROUP_SIZE_Y) / kRetryStride;

// The invocation's entry, if it `exists`.
RetryPixel findRetry(OUT(bool) exists) {
    uint group = gl_WorkGroupID.y * RETRY_ROW + gl_WorkGroupID.x;
    uint index = group * kRetryGroup + gl_LocalInvocationIndex / kRetryStride;
    exists = gl_LocalInvocationIndex % kRetryStride == 0u && index < retry.count;
    RetryPixel found;
    found.pixel = 0u;
    found.safe_s = real(0);
    if (exists) found = retry_pixels[index];
    return found;
}

void leaveForRetry(const uint pixel, const real safe_s) {
    uint place = atomicAdd(retry.count, 1u);
    retry_pixels[place].pixel = pixel;
    retry_pixels[place].safe_s = safe_s;
    uint group = place / kRetryGroup;
    bool opens_group = place % kRetryGroup == 0u;
    bool in_first_row = group < RETRY_ROW;
    if (opens_group && (in_first_row || group % RETRY_ROW == 0u)) atomicAdd(retry.groups[in_first_row ? 0 : 1], 1u);
}

// Whether invocations are for those that are to be done again now that their tile is there.
bool takesListed() {
    return absent.listed > 0u;
}

// The invocation's entry among those, if it `exists`.
uint findListed(OUT(bool) exists) {
    uint group = gl_WorkGroupID.y * RETRY_ROW + gl_WorkGroupID.x;
    uint index = group * uint(GROUP_SIZE_X * GROUP_SIZE_Y) + gl_LocalInvocationIndex;
    exists = index < absent.listed;
    return exists ? absent_pixels[absent.capacity + index].pixel : 0u;
}

// Of a pixel or ray whose search missed a tile: it is done again from the start.
void leaveForTile(const uint pixel) {
    uint place = atomicAdd(absent.count, 1u);
    absent_pixels[place].pixel = pixel;
    absent_pixels[place].tile = uint(absent_tile);
}

// Of a pixel that is done: tells the host whether one of its searches was given up.
void countGivenUp() {
    if (given_up) atomicAdd(retry.given_up, 1u);
    given_up = false;
}
