// makemap NAME WIDTH HEIGHT FILE.pgm: writes one of the tests' generated maps as a 16-bit PGM.

#include "base/error.h"
#include "tests/support/testmaps.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: makemap fractal|spikes|checkerboard|random|terraces WIDTH HEIGHT FILE.pgm\n");
        return 2;
    }
    try {
        dsphere::test::writePgm16(argv[4], dsphere::test::namedMap(argv[1], std::atoi(argv[2]), std::atoi(argv[3])));
    } catch (const dsphere::Error& error) {
        std::fprintf(stderr, "makemap: %s\n", error.what());
        return int(error.code());
    }
    return 0;
}
