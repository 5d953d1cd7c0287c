#include "render/devicefilm.h"

#include "base/error.h"
#include "gpu/device.h"
#include "render/planes.h"

#include <algorithm>
#include <bit>

namespace dsphere {

namespace {

void requireSize(const gpu::Device& device, int width, int height, int planes) {
    constexpr const char* kInParts = "render it in parts: --tile I/N and dsphere merge, or --cropwindow";
    const std::uint32_t limit = device.limits().max_image_dimension_2d;
    if (std::uint32_t(std::max(width, height)) > limit)
        throwFailure("the picture is {}x{} pixels, but images of {} end at {}x{}; {}", width, height,
                     device.info().name, limit, limit, kInParts);
    const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(planes) * 4;
    const std::uint64_t most = device.limits().max_allocation_size;
    if (bytes > most)
        throwFailure("the picture of {}x{} pixels takes {} MiB, but images of {} end at {} MiB; {}", width, height,
                     bytes >> 20, device.info().name, most >> 20, kInParts);
}

template <typename Use>
void forEachLayer(std::uint32_t mask, const Use& use) {
    std::uint32_t layer = 0;
    for (const PlaneInfo& info : planeInfos())
        if (mask & planeBit(info.plane)) use(layer++, info);
}

std::size_t firstPixel(const Image& image, const Box& rows) {
    return std::size_t(rows.y0 - image.data.y0) * std::size_t(rows.width());
}

}  // namespace

DeviceFilm::DeviceFilm(gpu::Device& device, int width, int height, std::uint32_t mask)
    : image_((requireSize(device, width, height, std::popcount(mask)), device), gpu::Format::R32Uint,
             std::uint32_t(width), std::uint32_t(height), std::uint32_t(std::popcount(mask)), "film"),
      mask_(mask) {
    image_.clear();
}

Image DeviceFilm::blank(const Box& data, const Box& display) const {
    Image image{data, display, {}};
    forEachLayer(mask_, [&](std::uint32_t, const PlaneInfo& info) {
        info.is_uint ? image.addUint(info.channel) : image.addFloat(info.channel);
    });
    return image;
}

void DeviceFilm::write(const Image& image, const Box& rows) {
    forEachLayer(mask_, [&](std::uint32_t layer, const PlaneInfo& info) {
        image_.upload(layer, 0, 0, std::uint32_t(rows.width()), std::uint32_t(rows.height()),
                      image.at(info.channel).floats().data() + firstPixel(image, rows));
    });
}

void DeviceFilm::read(Image& image, const Box& rows) const {
    const auto first = [&](auto& pixels) -> void* { return pixels.data() + firstPixel(image, rows); };
    forEachLayer(mask_, [&](std::uint32_t layer, const PlaneInfo& info) {
        Channel& channel = *std::ranges::find(image.channels, info.channel, &Channel::name);
        image_.download(layer, 0, 0, std::uint32_t(rows.width()), std::uint32_t(rows.height()),
                        std::visit(first, channel.pixels));
    });
}

Image DeviceFilm::read(const Box& data, const Box& display) const {
    Image image = blank(data, display);
    read(image, data);
    return image;
}

void takeMean(Image& sums, int samples) {
    if (samples == 1) return;
    for (Channel& channel : sums.channels)
        for (float& value : channel.floats()) value /= float(samples);
}

}  // namespace dsphere
