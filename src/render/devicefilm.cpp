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

}  // namespace

DeviceFilm::DeviceFilm(gpu::Device& device, int width, int height, std::uint32_t mask)
    : image_((requireSize(device, width, height, std::popcount(mask)), device), gpu::Format::R32Uint,
             std::uint32_t(width), std::uint32_t(height), std::uint32_t(std::popcount(mask)), "film"),
      mask_(mask) {
    image_.clear();
}

Image DeviceFilm::read(const Box& data, const Box& display) const {
    Image result{data, display, {}};
    std::uint32_t layer = 0;
    for (const PlaneInfo& info : planeInfos()) {
        if (!(mask_ & planeBit(info.plane))) continue;
        Channel& channel = info.is_uint ? result.addUint(info.channel) : result.addFloat(info.channel);
        void* target = info.is_uint ? static_cast<void*>(channel.uints().data()) : channel.floats().data();
        image_.download(layer++, 0, 0, std::uint32_t(data.width()), std::uint32_t(data.height()), target);
    }
    return result;
}

void DeviceFilm::write(const Image& image) {
    std::uint32_t layer = 0;
    for (const PlaneInfo& info : planeInfos()) {
        if (!(mask_ & planeBit(info.plane))) continue;
        image_.upload(layer++, 0, 0, std::uint32_t(image.data.width()), std::uint32_t(image.data.height()),
                      image.at(info.channel).floats().data());
    }
}

void takeMean(Image& sums, int samples) {
    for (Channel& channel : sums.channels)
        for (float& value : channel.floats()) value /= float(samples);
}

}  // namespace dsphere
