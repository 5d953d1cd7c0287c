#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/partrows.h"

#include <algorithm>
#include <cmath>
#include <functional>
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
