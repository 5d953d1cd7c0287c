// Sample positions inside a pixel: the R2 sequence (Roberts 2018, additive recurrence by the plastic number), shifted by
// a hash of pixel and seed, so that neighbouring pixels do not share a pattern.

uint hashWord(uint x) {  // lowbias32, Wellons 2018
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// In [-0.5, 0.5) about the pixel's centre. Words wrap, so the sequence stays exact at any index.
vec2 samplePosition(int pixel_x, int pixel_y, int index, uint seed) {
    uint shift_x = hashWord(uint(pixel_x) + hashWord(uint(pixel_y) + hashWord(seed)));
    uint shift_y = hashWord(shift_x);
    uint x = shift_x + uint(index) * 3242174889u;
    uint y = shift_y + uint(index) * 2447445414u;
    return vec2(real(x >> 8), real(y >> 8)) * real(1.0 / 16777216.0) - vec2(real(0.5));
}
