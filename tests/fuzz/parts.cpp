// The parts of `merge`: one file, or two with the line "--part--" between them.

#include "bench/environment.h"
#include "cli/partrows.h"
#include "render/devicefilm.h"
#include "tests/fuzz/scratch.h"

#include <algorithm>

using namespace dsphere;

// In place of bench/environment.cpp and render/devicefilm.cpp, which need a device.
std::string bench::buildCommit() {
    return "fuzz";
}
void dsphere::takeMean(Image& sums, int samples) {
    for (Channel& channel : sums.channels)
        for (float& value : channel.floats()) value /= float(samples);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Scratch scratch;
    constexpr std::string_view kBetween = "--part--\n";
    const std::string_view bytes = fuzz::textOf(data, size);
    const std::size_t cut = bytes.find(kBetween);
    std::vector<std::filesystem::path> files = {scratch.write("a.exr", bytes.substr(0, cut))};
    if (cut != std::string_view::npos) files.push_back(scratch.write("b.exr", bytes.substr(cut + kBetween.size())));
    fuzz::expectHandled([&] {
        std::vector<cli::Part> parts;
        for (const std::filesystem::path& file : files) parts.push_back(cli::readPart(file));
        cli::PartRows rows(cli::orderedParts(std::move(parts)));
        cli::noticesOf(rows.parts());
        const Box& picture = rows.front().of.picture;
        for (int y = picture.y0; y < picture.y1; y += 16) rows.read(y, std::min(y + 16, picture.y1));
    });
    return 0;
}
