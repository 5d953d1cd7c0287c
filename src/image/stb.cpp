// The one place where stb's code is compiled; its functions are called through its header.
#define STB_IMAGE_IMPLEMENTATION
#include "image/stb.h"

void forgetStbFailure() {
    stbi__g_failure_reason = nullptr;
}
