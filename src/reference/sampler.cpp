#include "reference/sampler.h"

#include <array>

namespace dsphere::reference {
namespace {

using Word = std::uint32_t;

// lowbias32: Wellons 2018, "Prospecting for hash functions".
Word hash(Word x) {
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

Word reversed(Word x) {
    Word result = 0;
    for (int bit = 0; bit < 32; ++bit) result |= (x >> bit & 1u) << (31 - bit);
    return result;
}

// A hash in which no bit depends on a higher one: Laine and Karras 2011, with the constants of Vegdahl 2021, "Building
// a better LK hash".
Word permuted(Word x, Word seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Owen's nested uniform scrambling: the bits of a fraction, each flipped by what stands before it.
Word scrambled(Word x, Word seed) {
    return reversed(permuted(reversed(x), seed));
}

// The direction numbers of Sobol's second dimension, of the polynomial x + 1: v = m 2^-k with m_1 = 1 and
// m_k = 2 m_(k-1) xor m_(k-1) (Joe and Kuo 2008).
std::array<Word, 32> directionNumbers() {
    std::array<Word, 32> numbers{};
    Word m = 1;
    for (int k = 0; k < 32; ++k) {
        numbers[std::size_t(k)] = m << (31 - k);
        m ^= m << 1;
    }
    return numbers;
}

Word sobolSecond(Word index) {
    static const std::array<Word, 32> numbers = directionNumbers();
    Word result = 0;
    for (std::size_t k = 0; k < 32; ++k)
        if (index >> k & 1u) result ^= numbers[k];
    return result;
}

}  // namespace

dvec2 SampleSource::pair(Word number) const {
    const Word key = hash(hash(x + hash(y + hash(seed))) + hash(number));
    const Word i = scrambled(index, key);
    const Word first = scrambled(reversed(i), hash(key + 1)), second = scrambled(sobolSecond(i), hash(key + 2));
    return dvec2(double(first >> 8), double(second >> 8)) / double(1 << 24);
}

}  // namespace dsphere::reference
