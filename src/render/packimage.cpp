#include "render/packimage.h"

#include <bit>
#include <cmath>

namespace dsphere {

namespace {

layout::vec4 split(double sine, double cosine) {
    float s = float(sine), c = float(cosine);
    return {s, c, float(sine - double(s)), float(cosine - double(c))};
}

layout::vec4 splitAngle(double angle) {
    return split(std::sin(angle), std::cos(angle));
}

std::uint32_t bits(double value) {
    return std::bit_cast<std::uint32_t>(float(value));
}

}  // namespace

int imageKind(const ColourMap& image) {
    return image.raw().srgb.empty() ? IMAGE_FLOATS : IMAGE_CODES;
}

PackedCentres packImage(layout::ObjectData& object, const ColourMap& image, double longitude_origin, double inner) {
    object.image = imageKind(image);
    object.image_width = image.width();
    object.image_height = image.height();
    object.image_north = layout::vec4(glm::vec3(image.north()), 1.0f);
    object.image_south = layout::vec4(glm::vec3(image.south()), 1.0f);
    double shift = 0.5;  // pbrt's u begins half a turn from where a displaced sphere's longitude is 0
    if (object.kind == KIND_DISPLACED) shift -= (longitude_origin + 180.0) / 360.0;
    object.image_shift = float(shift);
    PackedCentres centres;
    for (int i = 0; i < image.width(); ++i)
        centres.columns.push_back(splitAngle(2.0 * kPi * ((i + 0.5) / image.width() - shift)));
    for (int j = 0; j < image.height(); ++j) {
        double share = (j + 0.5) / image.height();
        bool disk = object.kind == KIND_DISK;
        centres.rows.push_back(disk ? split(inner + share * (1.0 - inner), 0.0) : splitAngle(kPi * share));
    }
    return centres;
}

void ImageWords::appendRow(int j, std::vector<std::uint32_t>& words) const {
    const std::size_t columns = std::size_t(image_->width());
    if (codes()) {
        const std::uint8_t* code = &image_->raw().srgb[3 * columns * std::size_t(j)];
        for (std::size_t i = 0; i < columns; ++i, code += 3)
            words.push_back(std::uint32_t(code[0]) | std::uint32_t(code[1]) << 8 | std::uint32_t(code[2]) << 16);
        return;
    }
    const std::size_t channel = std::size_t(j / image_->height()), row = std::size_t(j % image_->height());
    const float* value = &image_->raw().linear[3 * columns * row + channel];
    for (std::size_t i = 0; i < columns; ++i, value += 3) words.push_back(std::bit_cast<std::uint32_t>(*value));
}

std::vector<std::uint32_t> codeWords() {
    std::vector<std::uint32_t> words;
    for (int code = 0; code < 256; ++code) words.push_back(bits(linearFromCode(std::uint8_t(code))));
    return words;
}

}  // namespace dsphere
