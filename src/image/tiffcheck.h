#pragma once

#include "image/inputfile.h"

#include <string>

namespace dsphere {

/// Throws unless the header and the first directory of a TIFF file (classic or BigTIFF, from its first byte) lie
/// within the file, with every value that the directory's entries point to. libtiff itself reads on with a warning
/// when some of them are cut off. Leaves the file at any position.
void checkTiffDirectory(InputFile& file);

/// What the first directory says that readTiff would ignore or cannot read: "its tag 33922 says where it lies on the
/// planet", "its samples have 12 bits in format 1"; empty where readTiff takes in all there is. Throws as
/// checkTiffDirectory does.
std::string whatPlainTiffLacks(InputFile& file);

/// What the first directory says of its page.
struct TiffPage {
    std::uint64_t width = 0, height = 0;  ///< 0: it does not say
    bool plain_grey = false;              ///< one grey sample a texel, the first row on top
};

/// Throws as checkTiffDirectory does.
TiffPage tiffPageOf(InputFile& file);

/// Throws unless each strip or tile that was ever written lies within the file.
void checkTiffBlocks(InputFile& file);

}  // namespace dsphere
