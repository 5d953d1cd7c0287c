#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>

#include "base/error.h"
#include "image/exrcheck.h"
#include "image/exrparts.h"
#include "image/exrstream.h"

namespace dsphere {

/// Opened again for each piece of work would be slow; a header alone takes no room for pixels.
struct ExrReader::State {
    Imf::MultiPartInputFile file;
    std::unique_ptr<Imf::InputPart> part;

    explicit State(const std::filesystem::path& path) : file(path.c_str(), 0) {}
};

ExrReader::ExrReader(const std::filesystem::path& path) : path_(path) {
    InputFile input(path);
    try {
        checkExrHeaders(input);
        state_ = std::make_unique<State>(path);
        const Imf::Header& header = state_->file.header(0);
        checkExrHeader(header, channelNames(header.channels()), std::filesystem::file_size(path));
        data_ = fromExr(header.dataWindow());
        display_ = fromExr(header.displayWindow());
        metadata_ = metadataOf(header);
        for (const std::string& name : channelNames(header.channels()))
            channels_.push_back({name, header.channels()[name].type != Imf::UINT});
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;
ExrReader& ExrReader::operator=(ExrReader&&) noexcept = default;

Image ExrReader::read(int y0, int y1) {
    Image rows{{data_.x0, y0, data_.x1, y1}, display_, {}};
    for (const ChannelKind& channel : channels_) {
        if (channel.is_float)
            rows.addFloat(channel.name);
        else
            rows.addUint(channel.name);
    }
    try {
        if (!state_->part) state_->part = std::make_unique<Imf::InputPart>(state_->file, 0);
        state_->part->setFrameBuffer(makeFrameBuffer(rows.data, channelsOf(rows)));
        state_->part->readPixels(y0, y1 - 1);
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path_.string(), error.what());
    }
    return rows;
}

}  // namespace dsphere
