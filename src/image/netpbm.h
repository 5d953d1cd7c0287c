#pragma once

// The text of PNM and PFM headers (and of plain rasters): words apart by white space, '#' comments to the line's end.

#include "image/inputfile.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace dsphere {

/// The next word; takes with it the one white-space byte (or whole comment) that ends it, as netpbm does, so that
/// binary data may follow. Throws at the end of the file and on a word longer than any number; `what` is what was
/// expected, for the message: "PGM: the width". Comments on the way are added to `comments`, a line each.
std::string readWord(InputFile& file, std::string_view what, std::string* comments = nullptr);

/// The next word as a whole number of 0 or more; throws, saying `what` was expected, when it is none.
std::int64_t readNumber(InputFile& file, std::string_view what, std::string* comments = nullptr);

}  // namespace dsphere
