#pragma once

#include "image/inputfile.h"

namespace dsphere {

/// Throws Error (InvalidInput), which does not name the file, unless the headers of an EXR file (from its first byte)
/// lie within the file, with sizes that are sane and a table of chunks that fits: OpenEXR makes room for the table
/// before it looks at the file's length. What is no EXR header at all is left to OpenEXR's own complaint.
void checkExrHeaders(InputFile& file);

}  // namespace dsphere
