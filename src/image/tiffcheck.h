#pragma once

#include "image/inputfile.h"

namespace dsphere {

/// Throws unless the header and the first directory of a TIFF file (classic or BigTIFF, from its first byte) lie
/// within the file, with every value that the directory's entries point to. libtiff itself reads on with a warning
/// when some of them are cut off. Leaves the file at any position.
void checkTiffDirectory(InputFile& file);

}  // namespace dsphere
