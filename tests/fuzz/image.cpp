// Heightmaps, colour images and pictures in the formats that need no GDAL: the content decides which. GTX has no
// magic, and goes by the file's name.

#include "image/picture.h"
#include "image/rawcolour.h"
#include "image/rawmap.h"
#include "tests/fuzz/scratch.h"

using namespace dsphere;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Scratch scratch;
    const std::filesystem::path file = scratch.write("image.gtx", fuzz::textOf(data, size));
    fuzz::expectHandled([&] { readRawMap(file); });
    fuzz::expectHandled([&] { readRawColour(file); });
    if (size > 0 && data[0] == 0x89) fuzz::expectHandled([&] { readPngPicture(file); });
    if (size > 0 && data[0] == 0x76) {
        fuzz::expectHandled([&] { readExr(file); });
        fuzz::expectHandled([&] { readExrMetadata(file); });
    }
    return 0;
}
