#include "cli/partrows.h"

#include "base/error.h"
#include "render/samplesums.h"

#include <algorithm>

namespace dsphere::cli {

namespace {

bool isSum(const std::string& name) {
    return name.starts_with("sum.");
}

/// The rest of a picture is outputs that have no samples.
Image outputsOf(Image image) {
    std::erase_if(image.channels, [](const Channel& channel) { return isColour(channel.name) || isSum(channel.name); });
    return image;
}

}  // namespace

bool isColour(const std::string& name) {
    return name == "R" || name == "G" || name == "B" || name == "A";
}

void place(Image& to, const Image& from) {
    for (const Channel& channel : from.channels) {
        auto target = std::ranges::find(to.channels, channel.name, &Channel::name);
        for (int y = from.data.y0; y < from.data.y1; ++y) {
            const auto row = std::size_t(y - from.data.y0) * std::size_t(from.data.width());
            const auto at =
                std::size_t(y - to.data.y0) * std::size_t(to.data.width()) + std::size_t(from.data.x0 - to.data.x0);
            std::visit(
                [&](auto& pixels, const auto& source) {
                    std::copy_n(source.begin() + std::ptrdiff_t(row), from.data.width(),
                                pixels.begin() + std::ptrdiff_t(at));
                },
                target->pixels, channel.pixels);
        }
    }
}

Image emptyImage(const Box& data, const Box& display, const std::vector<ChannelKind>& channels) {
    Image image{data, display, {}};
    for (const ChannelKind& channel : channels)
        channel.is_float ? image.addFloat(channel.name) : image.addUint(channel.name);
    return image;
}

Image PartRows::readTile(std::size_t begin, std::size_t end, int y0, int y1) {
    SampleSums sums;
    Image outputs;
    for (std::size_t i = begin; i < end; ++i) {
        const Part& part = parts_[i];
        if (!readers_[i]) readers_[i] = std::make_unique<ExrReader>(part.path);
        Image rows = readers_[i]->read(y0, y1);
        if (y1 >= part.data.y1) readers_[i].reset();
        try {
            if (part.last > part.first) sums.append(sumsOf(rows, part.first, part.last));
        } catch (const Error& error) {
            throw Error(error.code(), fmt::format("{}: {}", part.path.string(), error.what()));
        }
        if (i == begin) outputs = outputsOf(std::move(rows));
    }
    Image picture = sums.samples() > 0 ? pictureOf(std::move(sums)) : Image{outputs.data, outputs.display, {}};
    std::ranges::move(outputs.channels, std::back_inserter(picture.channels));
    return picture;
}

// An integer output is one where any part has it so: the others had none that a float cannot hold.
std::vector<ChannelKind> PartRows::channels() const {
    const int samples = front().of.samples;
    std::vector<ChannelKind> channels;
    std::vector<std::string> colours;
    for (const ChannelKind& channel : front().channels) {
        if (isSum(channel.name)) continue;
        if (isColour(channel.name)) colours.push_back(channel.name);
        channels.push_back(channel);
    }
    for (ChannelKind& channel : channels)
        for (const Part& part : parts_)
            for (const ChannelKind& other : part.channels)
                if (other.name == channel.name) channel.is_float = channel.is_float && other.is_float;
    if (samples == 0) return channels;
    SampleSums sums;  // of one pixel, for the names of the sums
    for (int first = 0; first < samples; first += kSumBlock) {
        Image pixel{{0, 0, 1, 1}, {0, 0, 1, 1}, {}};
        for (const std::string& name : colours) pixel.addFloat(name);
        sums.append({first, std::min(first + kSumBlock, samples), std::move(pixel)});
    }
    for (const Channel& channel : pictureOf(std::move(sums)).channels)
        if (isSum(channel.name)) channels.push_back({channel.name, true});
    return channels;
}

Image PartRows::read(int y0, int y1) {
    const Box& picture = front().of.picture;
    Image rows = emptyImage({picture.x0, y0, picture.x1, y1}, front().display, channels());
    for (std::size_t begin = 0; begin < parts_.size();) {
        const Box& tile = parts_[begin].data;
        std::size_t end = begin + 1;
        while (end < parts_.size() && parts_[end].data == tile) ++end;
        const int top = std::max(y0, tile.y0), bottom = std::min(y1, tile.y1);
        if (top < bottom) place(rows, readTile(begin, end, top, bottom));
        begin = end;
    }
    return rows;
}

}  // namespace dsphere::cli
