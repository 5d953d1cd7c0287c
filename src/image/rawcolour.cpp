#include "image/rawcolour.h"

#include <algorithm>
#include <array>

#include "image/codecs.h"

namespace dsphere {

RawColour readRawColour(const std::filesystem::path& path) {
    InputFile file(path);
    switch (formatOf(file)) {
        case MapFormat::Png:
            return readPngColour(file);
        case MapFormat::Jpeg:
            return readJpegColour(file);
        case MapFormat::Pnm:
            return readPnmColour(file);
        case MapFormat::Pfm:
            return readPfmColour(file);
        case MapFormat::Tiff:
            return readTiffColour(file);
        case MapFormat::Exr:
            return readExrColour(file);
        case MapFormat::Empty:
            file.invalid("is empty, expected a JPEG, PNG, PGM, PPM, PFM, TIFF or EXR image");
        case MapFormat::Unknown:
            break;
    }
    file.invalid(
        "unknown format: it begins with the bytes {}, expected a JPEG, PNG, PGM, PPM (P2 P3 P5 P6), PFM, TIFF or EXR "
        "image",
        firstBytes(file));
}

}  // namespace dsphere
