#pragma once

// TIFF files as libtiff writes them, for tests.

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/tempfolder.h"

namespace dsphere::test {

struct TiffForm {
    std::string mode = "w";  ///< "wl", "wb" little and big endian, "w8" BigTIFF
    int samples = 1;         ///< a texel
    int photometric = PHOTOMETRIC_MINISBLACK, planar = PLANARCONFIG_CONTIG, compression = COMPRESSION_NONE;
    int predictor = PREDICTOR_NONE, orientation = ORIENTATION_TOPLEFT;
    int tile_width = 0, tile_height = 0;  ///< 0: strips
    int rows_per_strip = 3;
    int format = 0;  ///< 0: what the sample's type says
    std::vector<std::uint16_t> red = {},
                               grey = {};  ///< of a palette's entries; grey is green and blue, and red if unset
};

template <typename Sample>
void setTiffFields(TIFF* tiff, const TiffForm& form, int width, int height) {
    const int own = std::is_floating_point_v<Sample> ? SAMPLEFORMAT_IEEEFP
                    : std::is_signed_v<Sample>       ? SAMPLEFORMAT_INT
                                                     : SAMPLEFORMAT_UINT;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, int(8 * sizeof(Sample)));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.samples);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.format ? form.format : own);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, form.planar);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, form.orientation);
    if (form.photometric == PHOTOMETRIC_PALETTE) {
        std::vector<std::uint16_t> grey = form.grey, red = form.red.empty() ? form.grey : form.red;
        for (auto* entries : {&grey, &red})
            entries->resize(std::size_t(1) << 8 * std::min<std::size_t>(2, sizeof(Sample)));
        TIFFSetField(tiff, TIFFTAG_COLORMAP, red.data(), grey.data(), grey.data());
    }
    if (form.samples % 2 == 0) {
        const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
    }
    if (form.predictor != PREDICTOR_NONE) TIFFSetField(tiff, TIFFTAG_PREDICTOR, form.predictor);
    if (form.tile_width) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, form.tile_width);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, form.tile_height);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, form.rows_per_strip);
    }
}

/// `samples` row-major, a texel's together. Blocks are written one by one, so that planes may lie apart.
template <typename Sample>
std::string tiffFile(const TiffForm& form, int width, int height, const std::vector<Sample>& samples) {
    const TempFolder folder;
    const std::filesystem::path path = folder.path() / "made.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), form.mode.c_str());
    if (!tiff) throw std::runtime_error("cannot make a TIFF file");
    setTiffFields<Sample>(tiff, form, width, height);
    const bool tiled = form.tile_width > 0, separate = form.planar == PLANARCONFIG_SEPARATE;
    const int block_width = tiled ? form.tile_width : width;
    const int block_height = tiled ? form.tile_height : form.rows_per_strip;
    const int planes = separate ? form.samples : 1, chunk = separate ? 1 : form.samples;
    std::uint32_t index = 0;
    bool good = true;
    for (int plane = 0; plane < planes; ++plane)
        for (int top = 0; top < height; top += block_height)
            for (int left = 0; left < width; left += block_width, ++index) {
                const int rows = tiled ? block_height : std::min(block_height, height - top);
                std::vector<Sample> block(std::size_t(rows * block_width * chunk));
                for (int j = 0; j < std::min(rows, height - top); ++j)
                    for (int i = 0; i < std::min(block_width, width - left); ++i)
                        for (int c = 0; c < chunk; ++c)
                            block[std::size_t((j * block_width + i) * chunk + c)] =
                                samples[std::size_t(((top + j) * width + left + i) * form.samples + plane + c)];
                const auto bytes = tmsize_t(block.size() * sizeof(Sample));
                good = good && (tiled ? TIFFWriteEncodedTile(tiff, index, block.data(), bytes)
                                      : TIFFWriteEncodedStrip(tiff, index, block.data(), bytes)) == bytes;
            }
    TIFFClose(tiff);
    if (!good) throw std::runtime_error("cannot write a TIFF file");
    return readBytes(path);
}

/// A map of square tiles of which only those in `tiles` are written, by their number; the others have no bytes in the
/// file.
template <typename Sample>
std::string sparseTiffFile(int width, int height, int tile, std::map<std::uint32_t, std::vector<Sample>> tiles) {
    const TempFolder folder;
    const std::filesystem::path path = folder.path() / "made.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w8");
    if (!tiff) throw std::runtime_error("cannot make a TIFF file");
    const TiffForm form{.compression = COMPRESSION_ADOBE_DEFLATE, .tile_width = tile, .tile_height = tile};
    setTiffFields<Sample>(tiff, form, width, height);
    bool good = true;
    for (auto& [index, samples] : tiles) {
        const auto bytes = tmsize_t(samples.size() * sizeof(Sample));
        good = good && TIFFWriteEncodedTile(tiff, index, samples.data(), bytes) == bytes;
    }
    TIFFClose(tiff);
    if (!good) throw std::runtime_error("cannot write a TIFF file");
    return readBytes(path);
}

}  // namespace dsphere::test
