#include "base/image.h"

#include <cassert>

namespace dsphere {

const Channel* Image::find(const std::string& name) const {
    for (const Channel& channel : channels)
        if (channel.name == name) return &channel;
    return nullptr;
}

const Channel& Image::at(const std::string& name) const {
    const Channel* channel = find(name);
    assert(channel && "the image lacks a channel that its maker promised");
    return *channel;
}

Channel& Image::addFloat(const std::string& name) {
    channels.push_back({name, std::vector<float>(pixelCount())});
    return channels.back();
}

Channel& Image::addUint(const std::string& name) {
    channels.push_back({name, std::vector<std::uint32_t>(pixelCount())});
    return channels.back();
}

}  // namespace dsphere
