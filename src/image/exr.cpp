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

#include <algorithm>

#include "base/error.h"
#include "image/atomicfile.h"
#include "image/codecs.h"
#include "image/picture.h"

namespace dsphere {
namespace {

// No codec of OpenEXR packs pixels of FLOAT or UINT more than deflate's 1032 : 1; with room for HALF and run lengths.
constexpr std::uint64_t kMaxPacking = 4096;

Imath::Box2i toExr(const Box& box) {
    return {{box.x0, box.y0}, {box.x1 - 1, box.y1 - 1}};
}

Box fromExr(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
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

/// Throws unless the header's sizes are sane and the file can hold what it promises.
void checkHeader(const Imf::Header& header, std::uint64_t file_bytes) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
        throwInvalid("the size is {}x{}, expected sides of 1 to {} and at most {} pixels", width, height, kMaxSide,
                     kMaxTexels);
    std::uint64_t channels = 0;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++channels)
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            throwInvalid("the channel {} is subsampled, expected a value for every pixel", c.name());
    const std::uint64_t bytes = 4 * channels * std::uint64_t(width * height);
    if (bytes / kMaxPacking > file_bytes)
        throwInvalid("{} channels of {}x{} pixels cannot lie in a file of {} bytes", channels, width, height,
                     file_bytes);
}

Image readPixels(const std::filesystem::path& path) {
    // A multi-part file reads the header alone; the part makes room for pixels, so it comes after the check.
    Imf::MultiPartInputFile file(path.c_str());
    const Imf::Header& header = file.header(0);
    checkHeader(header, std::filesystem::file_size(path));
    Imf::InputPart part(file, 0);
    Image image;
    image.data = fromExr(header.dataWindow());
    image.display = fromExr(header.displayWindow());
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
        c.channel().type == Imf::UINT ? image.addUint(c.name()) : image.addFloat(c.name());
    part.setFrameBuffer(makeFrameBuffer(image));
    part.readPixels(image.data.y0, image.data.y1 - 1);
    return image;
}

}  // namespace

void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    AtomicFile file(path);
    try {
        ExrStream stream(file, path.string());
        Imf::OutputFile out(stream, makeHeader(image, metadata));
        out.setFrameBuffer(makeFrameBuffer(image));
        out.writePixels(image.data.height());
        // The destructors complete the file; a failure in them is kept by it.
    } catch (const std::exception& error) {
        throwFailure("{}: cannot be written: {}", path.string(), error.what());
    }
    file.commit();
}

Image readExr(const std::filesystem::path& path) {
    try {
        return readPixels(path);
    } catch (const std::exception& error) {
        throwInvalid("{}: cannot be read as EXR: {}", path.string(), error.what());
    }
}

}  // namespace dsphere
