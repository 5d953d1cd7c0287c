#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "base/atomicfile.h"
#include "base/error.h"
#include "image/exrparts.h"
#include "image/exrstream.h"
#include "image/picture.h"

namespace dsphere {
namespace {

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

/// The channel with its integers as floats, where those can hold every one.
std::optional<Channel> asFloats(const Channel& channel) {
    const auto held = [](std::uint32_t value) { return std::uint64_t(float(value)) == value; };
    if (channel.isFloat() || !std::ranges::all_of(channel.uints(), held)) return {};
    return Channel{channel.name, std::vector<float>(channel.uints().begin(), channel.uints().end())};
}

Imf::Header makeHeader(const Box& data, const Box& display, const std::vector<ChannelKind>& channels,
                       const Metadata& metadata) {
    Imf::Header header(toExr(display), toExr(data));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.lineOrder() = Imf::INCREASING_Y;
    for (const ChannelKind& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(channel.is_float ? Imf::FLOAT : Imf::UINT));
    for (const auto& [name, value] : metadata) std::visit(AddAttribute{header, name}, value);
    return header;
}

/// Threads that pack rows of that width: each has room for two blocks of them.
int threadsFor(const Box& data, std::size_t channels) {
    constexpr std::uint64_t kMostBytes = 1 << 27;
    const std::uint64_t block = 4 * std::uint64_t(data.width()) * channels * 16;
    return std::min(packingThreads(), int(std::max<std::uint64_t>(1, kMostBytes / (2 * block))));
}

}  // namespace

Imath::Box2i toExr(const Box& box) {
    return {{box.x0, box.y0}, {box.x1 - 1, box.y1 - 1}};
}

Box fromExr(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

Channels channelsOf(const Image& image) {
    Channels channels;
    for (const Channel& channel : image.channels) channels.push_back(&channel);
    return channels;
}

Imf::FrameBuffer makeFrameBuffer(const Box& data, const Channels& channels) {
    Imf::FrameBuffer buffer;
    for (const Channel* channel : channels) {
        const void* pixels = channel->isFloat() ? static_cast<const void*>(channel->floats().data())
                                                : static_cast<const void*>(channel->uints().data());
        const Imf::PixelType type = channel->isFloat() ? Imf::FLOAT : Imf::UINT;
        buffer.insert(channel->name, Imf::Slice::Make(type, pixels, toExr(data)));
    }
    return buffer;
}

struct ExrWriter::State {
    AtomicFile file;
    ExrStream stream;
    std::optional<Imf::OutputFile> out;

    explicit State(const std::filesystem::path& path) : file(path), stream(file, path.string()) {}
};

ExrWriter::ExrWriter(const std::filesystem::path& path, const Box& data, const Box& display,
                     const std::vector<ChannelKind>& channels, const Metadata& metadata)
    : path_(path), state_(std::make_unique<State>(path)) {
    try {
        state_->out.emplace(state_->stream, makeHeader(data, display, channels, metadata),
                            threadsFor(data, channels.size()));
    } catch (const std::exception& error) {
        throwFailure("{}: cannot be written: {}", path_.string(), error.what());
    }
}

ExrWriter::~ExrWriter() = default;

void ExrWriter::write(const Image& rows) {
    write(rows.data, channelsOf(rows));
}

void ExrWriter::write(const Box& rows, const std::vector<const Channel*>& channels) {
    try {
        state_->out->setFrameBuffer(makeFrameBuffer(rows, channels));
        state_->out->writePixels(rows.height());
    } catch (const std::exception& error) {
        throwFailure("{}: cannot be written: {}", path_.string(), error.what());
    }
}

void ExrWriter::commit() {
    state_->out.reset();  // its destructor completes the file; a failure in it is kept by the file
    state_->file.commit();
}

void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    std::vector<ChannelKind> kinds;
    Channels channels = channelsOf(image);
    std::vector<Channel> converted;
    converted.reserve(channels.size());
    for (const Channel*& channel : channels)
        if (std::optional<Channel> floats = asFloats(*channel)) channel = &converted.emplace_back(std::move(*floats));
    for (const Channel* channel : channels) kinds.push_back({channel->name, channel->isFloat()});
    ExrWriter writer(path, image.data, image.display, kinds, metadata);
    writer.write(image.data, channels);
    writer.commit();
}

}  // namespace dsphere
