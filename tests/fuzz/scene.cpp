// The scene language. A text that includes "self.pbrt" includes itself, so that nesting, loops and the limits of a
// whole scene are met.

#include "scene/parser.h"
#include "tests/fuzz/scratch.h"

using namespace dsphere;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::Scratch scratch;
    const std::string_view text = fuzz::textOf(data, size);
    if (text.find("self.pbrt") != std::string_view::npos) scratch.write("self.pbrt", text);
    fuzz::expectHandled([&] { parseScene(text, "scene.pbrt", scratch.path()); });
    return 0;
}
