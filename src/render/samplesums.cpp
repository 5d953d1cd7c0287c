#include "render/samplesums.h"

#include "base/error.h"
#include "render/devicefilm.h"

#include <bit>

namespace dsphere {

namespace {

constexpr const char* kColours[] = {"R", "G", "B"};

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

SampleSums sumsOf(const Image& picture, int samples) {
    const bool exact = meansTellSums(samples);
    SampleSums result{samples, {picture.data, picture.display, {}}};
    for (const std::string colour : kColours) {
        const Channel* channel = picture.find(exact ? colour : "sum." + colour);
        if (!channel || !channel->isFloat())
            throwInvalid("it has no channel {}, which {} samples take to go on", exact ? colour : "sum." + colour,
                         samples);
        std::vector<float>& sums = result.sums.addFloat(colour).floats();
        sums = channel->floats();
        if (exact)
            for (float& value : sums) value *= float(samples);
    }
    return result;
}

}  // namespace dsphere
