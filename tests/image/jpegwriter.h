#pragma once

// JPEG files as libjpeg writes them, for tests.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

namespace dsphere::test {

struct JpegForm {
    int channels = 3;  ///< 1 grey, 3 RGB, 4 CMYK
    bool progressive = false, arithmetic = false;
};

/// Best quality, colours not subsampled. `samples` row-major, a texel's together.
inline std::string jpegFile(int width, int height, std::vector<std::uint8_t> samples, const JpegForm& form) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long count = 0;
    jpeg_mem_dest(&jpeg, &bytes, &count);
    jpeg.image_width = JDIMENSION(width);
    jpeg.image_height = JDIMENSION(height);
    jpeg.input_components = form.channels;
    jpeg.in_color_space = form.channels == 1 ? JCS_GRAYSCALE : form.channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
    jpeg.arith_code = form.arithmetic ? TRUE : FALSE;
    if (form.progressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    for (int j = 0; j < height; ++j) {
        std::uint8_t* row = &samples[std::size_t(j * width * form.channels)];
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string file(reinterpret_cast<const char*>(bytes), count);
    std::free(bytes);
    return file;
}

}  // namespace dsphere::test
