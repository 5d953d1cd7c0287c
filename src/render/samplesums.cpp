#include "render/samplesums.h"

#include "base/error.h"
#include "render/devicefilm.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dsphere {

namespace {

bool meansTellSums(int samples) {
    return std::has_single_bit(unsigned(samples));
}

}  // namespace

Image pictureOf(SampleSums sums) {
    Image picture = sums.sums;
    takeMean(picture, sums.samples);
    if (!meansTellSums(sums.samples))
        for (Channel& channel : sums.sums.channels) {
            channel.name.insert(0, "sum.");
            picture.channels.push_back(std::move(channel));
        }
    return picture;
}

std::size_t nonFinitePixels(const SampleSums& sums) {
    std::size_t count = 0;
    const std::size_t pixels = sums.sums.channels.empty() ? 0 : sums.sums.channels[0].floats().size();
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto isFinite = [&](const Channel& channel) { return std::isfinite(channel.floats()[i]); };
        count += !std::ranges::all_of(sums.sums.channels, isFinite);
    }
    return count;
}

SampleSums sumsOf(const Image& picture, int samples) {
    const bool exact = meansTellSums(samples);
    SampleSums result{samples, {picture.data, picture.display, {}}};
    for (const std::string name : {"R", "G", "B", "A"}) {
        if (name == "A" && !picture.find("A")) continue;  // by a version that had no alpha
        const std::string from = exact ? name : "sum." + name;
        const Channel* channel = picture.find(from);
        if (!channel || !channel->isFloat())
            throwInvalid("it has no channel {}, which {} samples take to go on", from, samples);
        std::vector<float>& sums = result.sums.addFloat(name).floats();
        sums = channel->floats();
        if (exact)
            for (float& value : sums) value *= float(samples);
    }
    return result;
}

}  // namespace dsphere
