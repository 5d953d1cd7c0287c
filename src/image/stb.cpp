// The one place where stb's code is compiled; the functions are called through its headers.
#define STB_IMAGE_IMPLEMENTATION
#include "image/stb.h"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

void forgetStbFailure() {
    stbi__g_failure_reason = nullptr;
}
