// Maps by way of GDAL: the content decides the format. A file is its own label as well, so that labels find their
// samples: "map.img" stands beside "map.lbl" and "map.hdr" with the same bytes.

#include "geo/largemap.h"
#include "geo/readmap.h"
#include "tests/fuzz/scratch.h"

using namespace dsphere;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Scratch scratch;
    const std::string_view bytes = fuzz::textOf(data, size);
    const std::filesystem::path file = scratch.write("map.img", bytes);
    for (const char* label : {"map.lbl", "map.hdr"}) scratch.write(label, bytes);
    fuzz::expectHandled([&] { geo::readMap(file); });
    fuzz::expectHandled([&] { geo::openLargeMap(file, {}, 1); });
    return 0;
}
