#include "image/coloursink.h"

#include "base/srgb.h"

namespace dsphere {

ColourSink::ColourSink(int width, int height, ColourCode code, std::string type) : code_(code) {
    image_.width = width;
    image_.height = height;
    image_.type = std::move(type);
    const std::size_t values = 3 * std::size_t(width) * std::size_t(height);
    const bool bytes = code.srgb && code.full_scale == 255.0;
    bytes ? image_.srgb.resize(values) : image_.linear.resize(values);
}

void ColourSink::put(std::size_t first, std::size_t count, const float* values, int channels) {
    const int green = channels == 3 ? 1 : 0, blue = channels == 3 ? 2 : 0;
    const auto store = [&](auto* out, auto decode) {
        for (; count > 0; --count, values += channels, out += 3) {
            out[0] = decode(values[0]);
            out[1] = decode(values[green]);
            out[2] = decode(values[blue]);
        }
    };
    if (!image_.srgb.empty())
        store(&image_.srgb[3 * first], [](float value) { return std::uint8_t(value); });
    else if (code_.srgb)
        store(&image_.linear[3 * first],
              [&](float value) { return float(linearFromSrgb(double(value) / code_.full_scale)); });
    else
        store(&image_.linear[3 * first], [](float value) { return value; });
}

}  // namespace dsphere
