#pragma once

// What the writer and the readers of EXR files share.

#include "base/image.h"
#include "image/picture.h"

#include <ImfFrameBuffer.h>
#include <ImfMultiPartInputFile.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dsphere {

Imath::Box2i toExr(const Box& box);
Box fromExr(const Imath::Box2i& box);

using Channels = std::vector<const Channel*>;
Channels channelsOf(const Image& image);

/// OpenEXR's view of the channels' pixels, those of `data`; they must outlive it. It only reads through the view when
/// it writes a file.
Imf::FrameBuffer makeFrameBuffer(const Box& data, const Channels& channels);

/// Names the channels of the first part that are wanted.
using ChooseChannels = std::function<std::vector<std::string>(const Imf::MultiPartInputFile& file)>;

/// Throws Error, which does not name the file, unless the header's sizes are sane and a file of as many bytes can hold
/// what it promises.
void checkExrHeader(const Imf::Header& header, const std::vector<std::string>& wanted, std::uint64_t file_bytes);

/// The attributes of the types that Metadata knows.
Metadata metadataOf(const Imf::Header& header);

std::vector<std::string> channelNames(const Imf::ChannelList& channels);

/// Reads the channels that `choose` names of the file's first part: UINT ones as they are if `keep_uints`, all others
/// widened or rounded to float. Throws exceptions of OpenEXR's and Error, neither of which names the file.
Image readExrPixels(const std::filesystem::path& path, bool keep_uints, const ChooseChannels& choose);

}  // namespace dsphere
