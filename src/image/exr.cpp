#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <thread>

#include "base/error.h"
#include "image/atomicfile.h"
#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/picture.h"

namespace dsphere {
namespace {

// No codec of OpenEXR packs pixels of FLOAT or UINT more than deflate's 1032 : 1; with room for HALF and run lengths.
constexpr std::uint64_t kMaxPacking = 4096;
// A tile may be larger than the picture, and is made room for as a whole; this much needs no proof.
constexpr std::uint64_t kFreeTileBytes = 1 << 26;

using Names = std::vector<std::string>;

constexpr auto kAllChannels = [](const Imf::ChannelList& channels) {
    Names names;
    for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
    return names;
};

Imath::Box2i toExr(const Box& box) {
    return {{box.x0, box.y0}, {box.x1 - 1, box.y1 - 1}};
}

Box fromExr(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

/// Of OpenEXR, to pack what is written: on one core that takes longer than many a picture. Each has room for some rows,
/// so not too many; none where there is one core, or no thread to be had. Files are read without: what a hostile header
/// makes room for would be that many times as large.
int packingThreads() {
    static const int threads = [] {
        const int cores = int(std::min(std::thread::hardware_concurrency(), 8u));
        if (cores < 2) return 0;
        try {
            Imf::setGlobalThreadCount(cores);
        } catch (const std::exception&) {
            return 0;
        }
        return cores;
    }();
    return threads;
}

/// OpenEXR's way into an AtomicFile.
class ExrStream : public Imf::OStream {
  public:
    ExrStream(AtomicFile& file, const std::string& name) : OStream(name.c_str()), file_(file) {}
    void write(const char bytes[], int count) override { file_.write(bytes, std::size_t(count)); }
    std::uint64_t tellp() override { return file_.tell(); }
    void seekp(std::uint64_t position) override { file_.seek(position); }

  private:
    AtomicFile& file_;
};

struct AddAttribute {
    Imf::Header& header;
    const std::string& name;

    void operator()(const std::string& text) const { header.insert(name, Imf::StringAttribute(text)); }
    void operator()(int number) const { header.insert(name, Imf::IntAttribute(number)); }
    void operator()(float number) const { header.insert(name, Imf::FloatAttribute(number)); }
    void operator()(const std::array<float, 16>& m) const {
        Imath::M44f matrix;
        std::ranges::copy(m, &matrix[0][0]);
        header.insert(name, Imf::M44fAttribute(matrix));
    }
};

Imf::Header makeHeader(const Image& image, const Metadata& metadata) {
    Imf::Header header(toExr(image.display), toExr(image.data));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.lineOrder() = Imf::INCREASING_Y;
    for (const Channel& channel : image.channels)
        header.channels().insert(channel.name, Imf::Channel(channel.isFloat() ? Imf::FLOAT : Imf::UINT));
    for (const auto& [name, value] : metadata) std::visit(AddAttribute{header, name}, value);
    return header;
}

/// OpenEXR's view of the planes; they must outlive it. It only reads through the view when it writes a file.
Imf::FrameBuffer makeFrameBuffer(const Image& image) {
    Imf::FrameBuffer buffer;
    for (const Channel& channel : image.channels) {
        const void* pixels = channel.isFloat() ? static_cast<const void*>(channel.floats().data())
                                               : static_cast<const void*>(channel.uints().data());
        const Imf::PixelType type = channel.isFloat() ? Imf::FLOAT : Imf::UINT;
        buffer.insert(channel.name, Imf::Slice::Make(type, pixels, toExr(image.data)));
    }
    return buffer;
}

void checkTiles(const Imf::TileDescription& tiles, std::uint64_t channels, std::uint64_t file_bytes) {
    const std::uint64_t bytes = 4 * channels * tiles.xSize * tiles.ySize;
    const bool sane = std::min(tiles.xSize, tiles.ySize) >= 1 && std::max(tiles.xSize, tiles.ySize) <= kMaxSide;
    if (!sane || (bytes > kFreeTileBytes && bytes / kMaxPacking > file_bytes))
        throwInvalid("tiles of {}x{} pixels in a file of {} bytes", tiles.xSize, tiles.ySize, file_bytes);
}

/// Throws unless the header's sizes are sane and the file can hold what it promises.
void checkHeader(const Imf::Header& header, const Names& wanted, std::uint64_t file_bytes) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
        throwInvalid("the size is {}x{}, expected sides of 1 to {} and at most {} pixels", width, height, kMaxSide,
                     kMaxTexels);
    for (const std::string& name : wanted)
        if (const Imf::Channel& channel = header.channels()[name]; channel.xSampling != 1 || channel.ySampling != 1)
            throwInvalid("the channel {} is subsampled, expected a value for every pixel", name);
    const std::uint64_t channels = kAllChannels(header.channels()).size();
    const std::uint64_t bytes = 4 * wanted.size() * std::uint64_t(width * height);
    if (bytes / kMaxPacking > file_bytes)
        throwInvalid("{} channels of {}x{} pixels cannot lie in a file of {} bytes", wanted.size(), width, height,
                     file_bytes);
    if (header.hasTileDescription()) checkTiles(header.tileDescription(), channels, file_bytes);
}

/// Reads the channels that `choose` names of a header's list: uint ones as they are if `keep_uints`, all others widened
/// or rounded to float.
template <typename Choose>
Image readPixels(const std::filesystem::path& path, bool keep_uints, Choose&& choose) {
    // A multi-part file reads the header alone; the part makes room for pixels, so it comes after the check.
    Imf::MultiPartInputFile file(path.c_str(), 0);
    const Imf::Header& header = file.header(0);
    const Names wanted = choose(header.channels());
    checkHeader(header, wanted, std::filesystem::file_size(path));
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
    part.setFrameBuffer(makeFrameBuffer(image));
    part.readPixels(image.data.y0, image.data.y1 - 1);
    return image;
}

/// The channels that are heights.
Names heightChannels(const Imf::ChannelList& channels) {
    if (channels.findChannel("Y")) return {"Y"};
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B")) return {"R", "G", "B"};
    Names all = kAllChannels(channels);
    if (all.size() != 1)
        throwInvalid("it has the channels {}; a heightmap has Y, or R, G and B, or a single one", fmt::join(all, ", "));
    return all;
}

/// The channels that are a colour.
Names colourChannels(const Imf::ChannelList& channels) {
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B")) return {"R", "G", "B"};
    if (channels.findChannel("Y")) return {"Y"};
    throwInvalid("it has the channels {}; a colour image has R, G and B, or Y",
                 fmt::join(kAllChannels(channels), ", "));
}

}  // namespace

void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    AtomicFile file(path);
    try {
        ExrStream stream(file, path.string());
        Imf::OutputFile out(stream, makeHeader(image, metadata), packingThreads());
        out.setFrameBuffer(makeFrameBuffer(image));
        out.writePixels(image.data.height());
        // The destructors complete the file; a failure in them is kept by it.
    } catch (const std::exception& error) {
        throwFailure("{}: cannot be written: {}", path.string(), error.what());
    }
    file.commit();
}

Metadata readExrMetadata(const std::filesystem::path& path) {
    try {
        Imf::MultiPartInputFile file(path.c_str(), 0);
        const Imf::Header& header = file.header(0);
        Metadata metadata;
        for (auto i = header.begin(); i != header.end(); ++i) {
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute()))
                metadata[i.name()] = text->value();
            if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&i.attribute()))
                metadata[i.name()] = integer->value();
            if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&i.attribute()))
                metadata[i.name()] = number->value();
        }
        return metadata;
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

Image readExr(const std::filesystem::path& path) {
    try {
        return readPixels(path, true, kAllChannels);
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

RawMap readExrMap(InputFile& file) {
    try {
        Image image = readPixels(file.name(), false, heightChannels);
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
        const Image image = readPixels(file.name(), false, colourChannels);
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
