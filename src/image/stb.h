#pragma once

// stb_image as this program uses it: PNG from memory only.

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS (1 << 20)
#include <stb/stb_image.h>

/// stbi_failure_reason gives the reason of an earlier failure where the last one has none.
void forgetStbFailure();
