#include <vector>

#include "base/srgb.h"
#include "image/picture.h"
#include "image/pngpixels.h"

namespace dsphere {

Image readPngPicture(const std::filesystem::path& path) {
    InputFile file(path);
    const PngPixels pixels = readPngPixels(file);
    Image image;
    image.data = image.display = {0, 0, pixels.width, pixels.height};
    const char* const names[] = {"R", "G", "B"};
    const std::size_t alpha = std::size_t(pixels.channels) - 1;
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<float>& plane = image.addFloat(names[c]).floats();
        for (std::size_t k = 0; k < plane.size(); ++k) {
            const int code = pixels.code(k, pixels.colours() == 3 ? c : 0);
            plane[k] = float(linearFromSrgb(code / pixels.fullScale()));
            if (pixels.hasAlpha()) plane[k] *= float(pixels.code(k, alpha) / pixels.fullScale());
        }
    }
    return image;
}

}  // namespace dsphere
