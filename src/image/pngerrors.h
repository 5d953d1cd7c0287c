#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

namespace dsphere {

/// What libpng says when it fails. It leaves its functions by longjmp then: no function that sets a jump holds objects
/// that need destruction.
struct PngErrors {
    std::array<char, 512> message{};

    void keep(const char* text) { std::strncpy(message.data(), text, message.size() - 1); }

    /// For libpng, whose error pointer must be a PngErrors*.
    [[noreturn]] static void onError(png_structp png, png_const_charp text) {
        static_cast<PngErrors*>(png_get_error_ptr(png))->keep(text);
        png_longjmp(png, 1);
    }
};

}  // namespace dsphere
