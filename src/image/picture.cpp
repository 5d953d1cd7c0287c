#include "image/picture.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace dsphere {

void writePicture(const std::filesystem::path& path, const Image& image, const Metadata& metadata, double exposure) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".exr") return writeExr(path, image, metadata);
    if (extension == ".png") return writePng(path, image, exposure);
    throw Error(ExitCode::Usage,
                fmt::format("{}: the extension is {:?}, expected .exr or .png", path.string(), extension));
}

}  // namespace dsphere
