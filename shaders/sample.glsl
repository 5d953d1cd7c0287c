// The sample numbers of a pixel: Owen-scrambled Sobol points, one two-dimensional sequence a decision (Burley 2020,
// "Practical hash-based Owen scrambling"); docs/light.md has them word by word. Words wrap, so all is exact everywhere.

uint hashWord(uint x) {  // lowbias32, Wellons 2018
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// A nested uniform scramble of the bits, lowest first (Laine and Karras 2011; the constants are Vegdahl's, 2021).
uint permuteWord(uint x, const uint key) {
    x ^= x * 0x3d20adeau;
    x += key;
    x *= (key >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Sobol's second dimension, lowest bit first. Its k-th direction number is the polynomial (1 + x)^k over GF(2), so the
// index, as a polynomial, is shifted by 1: half by half, since (1 + x)^m = 1 + x^m where m is a power of 2.
uint sobolWord(uint index) {
    index ^= (index >> 16) & 0x0000ffffu;
    index ^= (index >> 8) & 0x00ff00ffu;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 1) & 0x55555555u;
    return index;
}

real unitReal(const uint word) {
    return real(word >> 8) * real(1.0 / 16777216.0);
}

uint pixelKey(const int pixel_x, const int pixel_y, const uint seed) {
    return hashWord(uint(pixel_x) + hashWord(uint(pixel_y) + hashWord(seed)));
}

// In [0, 1)^2; `pair` numbers the decisions.
vec2 samplePoint(const uint pixel_key, const int index, const uint pair) {
    uint key = hashWord(pixel_key + hashWord(pair));
    uint shuffled = bitfieldReverse(permuteWord(bitfieldReverse(uint(index)), key));
    uint first = bitfieldReverse(permuteWord(shuffled, hashWord(key + 1u)));
    uint second = bitfieldReverse(permuteWord(sobolWord(shuffled), hashWord(key + 2u)));
    return vec2(unitReal(first), unitReal(second));
}

// The place in the pixel, in [-0.5, 0.5) about its centre.
vec2 samplePosition(const int pixel_x, const int pixel_y, const int index, const uint seed) {
    return samplePoint(pixelKey(pixel_x, pixel_y, seed), index, 0u) - vec2(real(0.5));
}
