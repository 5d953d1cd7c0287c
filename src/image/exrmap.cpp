#include <ImfChannelList.h>
#include <ImfHeader.h>

#include "base/error.h"
#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/exrparts.h"

namespace dsphere {
namespace {

using Names = std::vector<std::string>;

/// The channels that are heights.
Names heightChannels(const Imf::MultiPartInputFile& file) {
    const Imf::ChannelList& channels = file.header(0).channels();
    if (channels.findChannel("Y")) return {"Y"};
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B")) return {"R", "G", "B"};
    Names all = channelNames(channels);
    if (all.size() != 1)
        throwInvalid("it has the channels {}; a heightmap has Y, or R, G and B, or a single one", fmt::join(all, ", "));
    return all;
}

/// The channels that are a colour.
Names colourChannels(const Imf::MultiPartInputFile& file) {
    const Imf::ChannelList& channels = file.header(0).channels();
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B")) return {"R", "G", "B"};
    if (channels.findChannel("Y")) return {"Y"};
    throwInvalid("it has the channels {}; a colour image has R, G and B, or Y",
                 fmt::join(channelNames(channels), ", "));
}

}  // namespace

RawMap readExrMap(InputFile& file) {
    try {
        Image image = readExrPixels(file.name(), false, heightChannels);
        RawMap map;
        map.width = image.data.width();
        map.height = image.data.height();
        map.type = image.channels.size() == 3 ? "colour EXR" : "EXR";
        map.samples = std::move(image.channels[0].floats());
        if (image.channels.size() == 3)
            for (std::size_t k = 0; k < map.samples.size(); ++k)
                map.samples[k] = meanOf(map.samples[k], image.channels[1].floats()[k], image.channels[2].floats()[k]);
        return map;
    } catch (const std::exception& error) {
        file.invalid("cannot be read as EXR: {}", error.what());
    }
}

RawColour readExrColour(InputFile& file) {
    try {
        const Image image = readExrPixels(file.name(), false, colourChannels);
        const bool colour = image.channels.size() == 3;
        const std::size_t width = std::size_t(image.data.width());
        ColourSink sink(image.data.width(), image.data.height(), {1.0, false}, colour ? "colour EXR" : "EXR");
        std::vector<float> row(3 * width);
        for (std::size_t first = 0; first < image.pixelCount(); first += width) {
            for (std::size_t k = 0; k < row.size(); ++k)
                row[k] = image.channels[colour ? k % 3 : 0].floats()[first + k / 3];
            sink.put(first, width, row.data(), 3);
        }
        return sink.take();
    } catch (const std::exception& error) {
        file.invalid("cannot be read as EXR: {}", error.what());
    }
}

}  // namespace dsphere
