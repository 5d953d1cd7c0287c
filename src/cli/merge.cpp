#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/parts.h"
#include "render/samplesums.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace dsphere::cli {

namespace {

// Rows are merged in strips of whole blocks of OpenEXR's, as many as this much memory holds.
constexpr std::uint64_t kStripBytes = 1 << 27;
constexpr int kBlockRows = 16;

struct MergeOptions {
    CommonOptions common;
    std::string outfile;
    std::vector<std::string> parts;
    std::optional<double> exposure;
    ToneCurve tone = ToneCurve::Linear;
    bool alpha = false, reproducible = false;
};

/// The parts of a picture, read strip by strip from top to bottom.
class PartRows {
  public:
    explicit PartRows(std::vector<Part> ordered) : parts_(std::move(ordered)), readers_(parts_.size()) {}

    const Part& front() const { return parts_.front(); }
    const std::vector<Part>& parts() const { return parts_; }

    /// Rows y0 to y1 - 1 of the picture, with the channels of an undivided render.
    Image read(int y0, int y1);
    std::vector<ChannelKind> channels() const;

  private:
    /// Of the parts [begin, end), which are of one tile.
    Image readTile(std::size_t begin, std::size_t end, int y0, int y1);

    std::vector<Part> parts_;
    std::vector<std::unique_ptr<ExrReader>> readers_;  ///< open while their rows are read
};

bool isColour(const std::string& name) {
    return name == "R" || name == "G" || name == "B" || name == "A";
}

bool isSum(const std::string& name) {
    return name.starts_with("sum.");
}

/// The rest of a picture is outputs that have no samples.
Image outputsOf(Image image) {
    std::erase_if(image.channels, [](const Channel& channel) { return isColour(channel.name) || isSum(channel.name); });
    return image;
}

Image PartRows::readTile(std::size_t begin, std::size_t end, int y0, int y1) {
    SampleSums sums;
    Image outputs;
    for (std::size_t i = begin; i < end; ++i) {
        const Part& part = parts_[i];
        if (!readers_[i]) readers_[i] = std::make_unique<ExrReader>(part.path);
        Image rows = readers_[i]->read(y0, y1);
        if (y1 >= part.data.y1) readers_[i].reset();
        try {
            if (part.last > part.first) sums.append(sumsOf(rows, part.first, part.last));
        } catch (const Error& error) {
            throw Error(error.code(), fmt::format("{}: {}", part.path.string(), error.what()));
        }
        if (i == begin) outputs = outputsOf(std::move(rows));
    }
    Image picture = sums.samples() > 0 ? pictureOf(sums) : Image{outputs.data, outputs.display, {}};
    std::ranges::move(outputs.channels, std::back_inserter(picture.channels));
    return picture;
}

/// Puts the pixels of `from` into `to`, which holds them and has its channels; numbers may become floats or integers.
void place(Image& to, const Image& from) {
    for (const Channel& channel : from.channels) {
        auto target = std::ranges::find(to.channels, channel.name, &Channel::name);
        for (int y = from.data.y0; y < from.data.y1; ++y) {
            const auto row = std::size_t(y - from.data.y0) * std::size_t(from.data.width());
            const auto at =
                std::size_t(y - to.data.y0) * std::size_t(to.data.width()) + std::size_t(from.data.x0 - to.data.x0);
            std::visit(
                [&](auto& pixels, const auto& source) {
                    std::copy_n(source.begin() + std::ptrdiff_t(row), from.data.width(),
                                pixels.begin() + std::ptrdiff_t(at));
                },
                target->pixels, channel.pixels);
        }
    }
}

Image emptyImage(const Box& data, const Box& display, const std::vector<ChannelKind>& channels) {
    Image image{data, display, {}};
    for (const ChannelKind& channel : channels)
        channel.is_float ? image.addFloat(channel.name) : image.addUint(channel.name);
    return image;
}

// An integer output is one where any part has it so: the others had none that a float cannot hold.
std::vector<ChannelKind> PartRows::channels() const {
    const int samples = front().of.samples;
    std::vector<ChannelKind> channels;
    std::vector<std::string> colours;
    for (const ChannelKind& channel : front().channels) {
        if (isSum(channel.name)) continue;
        if (isColour(channel.name)) colours.push_back(channel.name);
        channels.push_back(channel);
    }
    for (ChannelKind& channel : channels)
        for (const Part& part : parts_)
            for (const ChannelKind& other : part.channels)
                if (other.name == channel.name) channel.is_float = channel.is_float && other.is_float;
    if (samples == 0) return channels;
    SampleSums sums;  // of one pixel, for the names of the sums
    for (int first = 0; first < samples; first += kSumBlock) {
        Image pixel{{0, 0, 1, 1}, {0, 0, 1, 1}, {}};
        for (const std::string& name : colours) pixel.addFloat(name);
        sums.append({first, std::min(first + kSumBlock, samples), std::move(pixel)});
    }
    for (const Channel& channel : pictureOf(sums).channels)
        if (isSum(channel.name)) channels.push_back({channel.name, true});
    return channels;
}

Image PartRows::read(int y0, int y1) {
    const Box& picture = front().of.picture;
    Image rows = emptyImage({picture.x0, y0, picture.x1, y1}, front().display, channels());
    for (std::size_t begin = 0; begin < parts_.size();) {
        const Box& tile = parts_[begin].data;
        std::size_t end = begin + 1;
        while (end < parts_.size() && parts_[end].data == tile) ++end;
        const int top = std::max(y0, tile.y0), bottom = std::min(y1, tile.y1);
        if (top < bottom) place(rows, readTile(begin, end, top, bottom));
        begin = end;
    }
    return rows;
}

// The header of an undivided render: the time is that of all parts.
Metadata mergedMetadata(const std::vector<Part>& parts, bool reproducible) {
    Metadata metadata = parts.front().metadata;
    forgetPart(metadata);
    metadata["samplesPerPixel"] = parts.front().of.samples;
    double seconds = 0.0;
    bool timed = !reproducible;
    for (const Part& part : parts) {
        const auto found = part.metadata.find("renderTimeSeconds");
        const float* value = found == part.metadata.end() ? nullptr : std::get_if<float>(&found->second);
        timed = timed && value;
        if (value) seconds += double(*value);
    }
    metadata.erase("renderTimeSeconds");
    if (timed) metadata["renderTimeSeconds"] = float(seconds);
    if (reproducible)
        for (const char* name : {"device", "driver"}) metadata.erase(name);
    return metadata;
}

int stripRows(const Box& picture, std::size_t channels, std::size_t ranges) {
    const std::uint64_t row = 4 * std::uint64_t(picture.width()) * channels * (ranges + 2);
    const std::uint64_t blocks = std::max<std::uint64_t>(1, kStripBytes / (row * kBlockRows));
    return kBlockRows * int(std::min<std::uint64_t>(blocks, std::uint64_t(picture.height()) / kBlockRows + 1));
}

void eachStrip(PartRows& rows, const MergeOptions& options, const std::function<void(const Image&)>& take) {
    ProgressLine line(options.common.progress, options.common.quiet, "merge");
    const Box& picture = rows.front().of.picture;
    const auto same =
        std::ranges::count_if(rows.parts(), [&](const Part& part) { return part.data == rows.front().data; });
    const int step = stripRows(picture, rows.channels().size(), std::size_t(same));
    for (int y = picture.y0; y < picture.y1; y += step) {
        if (!line.update(double(y - picture.y0) / picture.height()))
            throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
        take(rows.read(y, std::min(y + step, picture.y1)));
    }
}

void mergeExr(PartRows& rows, const MergeOptions& options) {
    ExrWriter writer(options.outfile, rows.front().of.picture, rows.front().display, rows.channels(),
                     mergedMetadata(rows.parts(), options.reproducible));
    eachStrip(rows, options, [&](const Image& strip) { writer.write(strip); });
    writer.commit();
}

void mergePng(PartRows& rows, const MergeOptions& options) {
    const Part& front = rows.front();
    std::vector<ChannelKind> colours;
    for (const ChannelKind& channel : front.channels)
        if (isColour(channel.name) && (options.alpha || channel.name != "A")) colours.push_back(channel);
    if (colours.empty()) throwInvalid("the parts have no colour, which a .png holds alone");
    checkPngSize(options.outfile, front.of.picture.width(), front.of.picture.height(), int(colours.size()));
    Image picture = emptyImage(front.of.picture, front.display, colours);
    eachStrip(rows, options, [&](Image strip) {
        std::erase_if(strip.channels, [&](const Channel& channel) { return !picture.find(channel.name); });
        place(picture, strip);
    });
    writePng(options.outfile, picture, {options.exposure.value_or(0.0), options.tone});
}

int runMerge(const MergeOptions& options) {
    const std::string extension = extensionOf(options.outfile);
    if (extension != ".exr" && extension != ".png")
        throwUsage("{}: the extension is {:?}, expected .exr or .png", options.outfile, extension);
    if (options.exposure && !std::isfinite(*options.exposure))
        throwUsage("--exposure: {} is not a finite number of stops", *options.exposure);
    if (extension == ".exr" && (options.exposure || options.tone != ToneCurve::Linear || options.alpha))
        throwUsage("{}: an EXR holds light and alpha as they are; --exposure, --tone and --alpha are for .png",
                   options.outfile);
    std::vector<NamedFile> inputs;
    for (const std::string& path : options.parts) inputs.push_back({path, "a part"});
    checkOutputs({{options.outfile, "--outfile"}}, inputs);
    std::vector<Part> parts;
    for (const std::string& path : options.parts) parts.push_back(readPart(path));
    PartRows rows(orderedParts(std::move(parts)));
    if (!options.common.quiet) printNotices(noticesOf(rows.parts()));
    if (extension == ".exr")
        mergeExr(rows, options);
    else
        mergePng(rows, options);
    return int(ExitCode::Ok);
}

}  // namespace

void addMerge(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("merge", "Put the parts of a picture together that render --tile and --samples wrote");
    auto options = std::make_shared<MergeOptions>();
    command->add_option("-o,--outfile", options->outfile, "Picture to write, .exr or .png")
        ->required()
        ->type_name("FILE");
    command->add_option("parts", options->parts, "All parts, in any order")->required()->type_name("PART.exr...");
    addToneOptions(*command, options->exposure, options->tone);
    command->add_flag("--alpha", options->alpha, "Into a .png, write the alpha channel of the parts too");
    command->add_flag("--reproducible", options->reproducible,
                      "Leave the time, the device and its driver out of the .exr's header, as render does");
    command->add_flag("--quiet", options->common.quiet, "Print errors only");
    addProgressOption(*command, options->common.progress);
    command->callback([options, &action] { action = [options] { return runMerge(*options); }; });
}

}  // namespace dsphere::cli
