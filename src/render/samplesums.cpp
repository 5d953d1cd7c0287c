#include "render/samplesums.h"

#include "base/error.h"
#include "render/devicefilm.h"

#include <bit>

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
