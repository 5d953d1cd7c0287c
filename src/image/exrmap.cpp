#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfPartType.h>

#include <limits>

#include "base/error.h"
#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/exrlayers.h"
#include "image/exrparts.h"

namespace dsphere {
namespace {

std::vector<ExrChannel> channelsOf(const Imf::Header& header) {
    std::vector<ExrChannel> channels;
    const Imf::ChannelList& list = header.channels();
    for (auto c = list.begin(); c != list.end(); ++c) channels.push_back({c.name(), c.channel().type == Imf::UINT});
    return channels;
}

/// The chosen channels of the first part, and what else the file holds.
struct Pixels {
    ExrChoice choice;
    std::vector<std::string> other_parts;
    Image image;  ///< the values, then alpha where there is one

    const std::vector<float>& plane(std::size_t k) const { return image.channels[k].floats(); }
    std::size_t colours() const { return choice.values.size(); }
    /// "colour EXR with alpha, layer View.Combined, part 1 of 2"
    std::string type() const {
        std::string text = colours() == 3 ? "colour EXR" : "EXR";
        if (!choice.alpha.empty()) text += " with alpha";
        if (!choice.layer.empty()) text += ", layer " + choice.layer;
        if (!other_parts.empty()) text += fmt::format(", part 1 of {}", other_parts.size() + 1);
        return text;
    }
};

Pixels readPart(InputFile& file, ExrChoice (*choose)(const std::vector<ExrChannel>&), bool with_alpha) {
    Pixels pixels;
    try {
        pixels.image = readExrPixels(file.name(), false, [&](const Imf::MultiPartInputFile& parts) {
            const Imf::Header& header = parts.header(0);
            if (header.hasType() && Imf::isDeepData(header.type()))
                throwInvalid("its first part holds deep data, expected one value for every pixel");
            for (int k = 1; k < parts.parts(); ++k)
                pixels.other_parts.push_back(parts.header(k).hasName() ? parts.header(k).name()
                                                                       : std::to_string(k + 1));
            pixels.choice = choose(channelsOf(header));
            std::vector<std::string> wanted = pixels.choice.values;
            if (with_alpha && !pixels.choice.alpha.empty()) wanted.push_back(pixels.choice.alpha);
            return wanted;
        });
    } catch (const std::exception& error) {
        file.invalid("cannot be read as EXR: {}", error.what());
    }
    return pixels;
}

/// Notes of what the file holds besides the heights.
Notices noticesOf(const InputFile& file, const Pixels& pixels) {
    Notices notices;
    const auto say = [&](Notice::Kind kind, const std::string& text) {
        notices.push_back({kind, fmt::format("{}: {}", file.name(), text)});
    };
    if (!pixels.choice.others.empty())
        say(Notice::Kind::Note,
            fmt::format("heights are its channels {}; not read: {}", fmt::join(pixels.choice.values, ", "),
                        fmt::join(pixels.choice.others, ", ")));
    if (!pixels.other_parts.empty())
        say(Notice::Kind::Note, fmt::format("only the first of its {} parts is read; the others are {}",
                                            pixels.other_parts.size() + 1, fmt::join(pixels.other_parts, ", ")));
    const Box& data = pixels.image.data;
    const Box& display = pixels.image.display;
    if (data.width() != display.width() || data.height() != display.height())
        say(Notice::Kind::Warning,
            fmt::format("its pixels are {}x{} of a picture of {}x{}: they are taken for the whole map", data.width(),
                        data.height(), display.width(), display.height()));
    return notices;
}

}  // namespace

RawMap readExrMap(InputFile& file) {
    const Pixels pixels = readPart(file, chooseHeights, true);
    RawMap map;
    map.width = pixels.image.data.width();
    map.height = pixels.image.data.height();
    map.type = pixels.type();
    map.notices = noticesOf(file, pixels);
    map.samples = pixels.plane(0);
    ColourCensus colours;
    AlphaCensus alpha(1.0);
    const bool transparent = !pixels.choice.alpha.empty();
    for (std::size_t k = 0; k < map.samples.size(); ++k) {
        if (k % std::size_t(map.width) == 0) colours.startRow();
        if (transparent && !alpha.isKnown(pixels.plane(pixels.colours())[k]))
            map.samples[k] = std::numeric_limits<float>::quiet_NaN();
        else if (pixels.colours() == 3)
            map.samples[k] = colours.grey(pixels.plane(0)[k], pixels.plane(1)[k], pixels.plane(2)[k]);
    }
    colours.report(map, file.name());
    alpha.report(map, file.name());
    return map;
}

RawColour readExrColour(InputFile& file) {
    const Pixels pixels = readPart(file, chooseColours, false);
    const std::size_t width = std::size_t(pixels.image.data.width());
    ColourSink sink(pixels.image.data.width(), pixels.image.data.height(), {1.0, false}, pixels.type());
    std::vector<float> row(3 * width);
    for (std::size_t first = 0; first < pixels.image.pixelCount(); first += width) {
        for (std::size_t k = 0; k < row.size(); ++k)
            row[k] = pixels.plane(pixels.colours() == 3 ? k % 3 : 0)[first + k / 3];
        sink.put(first, width, row.data(), 3);
    }
    return sink.take();
}

}  // namespace dsphere
