#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>

#include <algorithm>

#include "base/error.h"
#include "image/codecs.h"
#include "image/exrcheck.h"
#include "image/exrparts.h"
#include "image/picture.h"

namespace dsphere {
namespace {

// No codec of OpenEXR packs pixels of FLOAT or UINT more than deflate's 1032 : 1; with room for HALF and run lengths.
constexpr std::uint64_t kMaxPacking = 4096;
// A tile may be larger than the picture, and is made room for as a whole; this much needs no proof.
constexpr std::uint64_t kFreeTileBytes = 1 << 26;

void checkTiles(const Imf::TileDescription& tiles, std::uint64_t channels, std::uint64_t file_bytes) {
    const std::uint64_t bytes = 4 * channels * tiles.xSize * tiles.ySize;
    const bool sane = std::min(tiles.xSize, tiles.ySize) >= 1 && std::max(tiles.xSize, tiles.ySize) <= kMaxSide;
    if (!sane || (bytes > kFreeTileBytes && bytes / kMaxPacking > file_bytes))
        throwInvalid("tiles of {}x{} pixels in a file of {} bytes", tiles.xSize, tiles.ySize, file_bytes);
}

}  // namespace

void checkExrHeader(const Imf::Header& header, const std::vector<std::string>& wanted, std::uint64_t file_bytes) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
        throwInvalid("the size is {}x{}, expected sides of 1 to {} and at most {} pixels", width, height, kMaxSide,
                     kMaxTexels);
    for (const std::string& name : wanted)
        if (const Imf::Channel& channel = header.channels()[name]; channel.xSampling != 1 || channel.ySampling != 1)
            throwInvalid("the channel {} is subsampled, expected a value for every pixel", name);
    const std::uint64_t channels = channelNames(header.channels()).size();
    const std::uint64_t bytes = 4 * wanted.size() * std::uint64_t(width * height);
    if (bytes / kMaxPacking > file_bytes)
        throwInvalid("{} channels of {}x{} pixels cannot lie in a file of {} bytes", wanted.size(), width, height,
                     file_bytes);
    if (header.hasTileDescription()) checkTiles(header.tileDescription(), channels, file_bytes);
}

std::vector<std::string> channelNames(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
    return names;
}

Image readExrPixels(const std::filesystem::path& path, bool keep_uints, const ChooseChannels& choose) {
    InputFile input(path);
    checkExrHeaders(input);
    // A multi-part file reads the header alone; the part makes room for pixels, so it comes after the check.
    Imf::MultiPartInputFile file(path.c_str(), 0);
    const Imf::Header& header = file.header(0);
    const std::vector<std::string> wanted = choose(file);
    checkExrHeader(header, wanted, std::filesystem::file_size(path));
    Imf::InputPart part(file, 0);
    Image image;
    image.data = fromExr(header.dataWindow());
    image.display = fromExr(header.displayWindow());
    for (const std::string& name : wanted) {
        if (keep_uints && header.channels()[name].type == Imf::UINT)
            image.addUint(name);
        else
            image.addFloat(name);
    }
    part.setFrameBuffer(makeFrameBuffer(image.data, channelsOf(image)));
    part.readPixels(image.data.y0, image.data.y1 - 1);
    return image;
}

Metadata metadataOf(const Imf::Header& header) {
    Metadata metadata;
    for (auto i = header.begin(); i != header.end(); ++i) {
        // How the file is laid out; the library adds them as it reads.
        if (i.name() == std::string_view("type") || i.name() == std::string_view("chunkCount")) continue;
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute()))
            metadata[i.name()] = text->value();
        if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&i.attribute()))
            metadata[i.name()] = integer->value();
        if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&i.attribute()))
            metadata[i.name()] = number->value();
        if (const auto* matrix = dynamic_cast<const Imf::M44fAttribute*>(&i.attribute())) {
            std::array<float, 16> values;
            std::copy_n(&matrix->value()[0][0], 16, values.begin());
            metadata[i.name()] = values;
        }
    }
    return metadata;
}

Metadata readExrMetadata(const std::filesystem::path& path) {
    InputFile input(path);
    try {
        checkExrHeaders(input);
        return metadataOf(Imf::MultiPartInputFile(path.c_str(), 0).header(0));
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

Image readExr(const std::filesystem::path& path) {
    const InputFile readable(path);  // its error names the file
    try {
        return readExrPixels(
            path, true, [](const Imf::MultiPartInputFile& file) { return channelNames(file.header(0).channels()); });
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

}  // namespace dsphere
