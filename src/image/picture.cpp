#include "image/picture.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace dsphere {

namespace {

[[noreturn]] void throwUnknown(const std::filesystem::path& path) {
    throw Error(ExitCode::Usage,
                fmt::format("{}: the extension is {:?}, expected .exr or .png", path.string(), extensionOf(path)));
}

}  // namespace

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

void writePicture(const std::filesystem::path& path, const Image& image, const Metadata& metadata, const Tone& tone) {
    const std::string extension = extensionOf(path);
    if (extension == ".exr") return writeExr(path, image, metadata);
    if (extension == ".png") return writePng(path, image, tone);
    throwUnknown(path);
}

Image readPicture(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".exr") return readExr(path);
    if (extension == ".png") return readPngPicture(path);
    throwUnknown(path);
}

}  // namespace dsphere
