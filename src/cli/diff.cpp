#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/picture.h"
#include "scene/ramps.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>

namespace dsphere::cli {

namespace {

enum class Metric { Mae, Rmse, Flip, Max };

struct DiffOptions {
    std::string a, b, outfile;
    std::vector<std::string> channels;
    std::optional<double> threshold;
    Metric metric = Metric::Mae;
    bool json = false;
};

struct Result {
    Comparison comparison;
    std::optional<std::vector<float>> flip_map;  ///< of R, G, B only
    std::optional<double> flip;                  ///< its mean
};

// Wrong options must not cost a comparison first.
void checkOptions(const DiffOptions& options) {
    bool flips = options.channels.empty();
    if (options.threshold && !(*options.threshold >= 0.0))
        throwUsage("--threshold: {} is not 0 or more", *options.threshold);
    if (options.metric == Metric::Flip && !flips) throwUsage("--metric flip is of R, G, B, not of a --channel");
    if (options.outfile.empty()) return;
    const std::string extension = extensionOf(options.outfile);
    if (extension != ".png" && extension != ".exr")
        throwUsage("{}: unknown picture format '{}'; .png and .exr are supported", options.outfile, extension);
    if (extension == ".png" && !flips)
        throwUsage("{}: a PNG shows FLIP, which is of R, G, B, not of a --channel; write .exr", options.outfile);
    checkOutputs({{options.outfile, "--outfile"}}, {{options.a, "picture A"}, {options.b, "picture B"}});
}

std::string sizeOf(const Box& box) {
    std::string size = fmt::format("{}x{}", box.width(), box.height());
    return box.x0 == 0 && box.y0 == 0 ? size : fmt::format("{} at ({}, {})", size, box.x0, box.y0);
}

void requireChannels(const std::string& name, const Image& image, const std::vector<std::string>& channels) {
    for (const std::string& channel : channels) {
        if (image.find(channel)) continue;
        std::string there;
        for (const Channel& other : image.channels) there += (there.empty() ? "" : ", ") + other.name;
        throwInvalid("{}: has no channel {}; it has {}", name, channel, there);
    }
}

// A PNG knows no place on a film: a crop's window counts only between two EXR files.
void requireSameWindow(const DiffOptions& options, const Image& a, const Image& b) {
    bool sizes = a.data.width() == b.data.width() && a.data.height() == b.data.height();
    auto exr = [](const std::string& name) { return extensionOf(name) != ".png"; };
    if (sizes && (a.data == b.data || !exr(options.a) || !exr(options.b))) return;
    throwInvalid("the sizes differ: {} is {}, {} is {}", options.a, sizeOf(a.data), options.b, sizeOf(b.data));
}

// FLIP is blind beyond [0, 1] and takes NaN for black; what is infinitely different must not look equal.
void markInfinite(std::vector<float>& flip_map, const Image& difference) {
    for (const Channel& channel : difference.channels)
        for (std::size_t k = 0; k < flip_map.size(); ++k)
            if (!std::isfinite(channel.floats()[k])) flip_map[k] = 1.0f;
}

Result compare(const DiffOptions& options, const Image& a, const Image& b, const std::vector<std::string>& channels) {
    Result result{comparePictures(a, b, channels), {}, {}};
    if (!options.channels.empty()) return result;
    result.flip_map = flip(a, b);
    if (result.comparison.non_finite > 0) markInfinite(*result.flip_map, differencePicture(a, b, channels));
    double sum = std::accumulate(result.flip_map->begin(), result.flip_map->end(), 0.0);
    result.flip = sum / double(result.flip_map->size());
    return result;
}

Image flipPicture(const Image& a, const std::vector<float>& flip_map) {
    const Ramp& ramp = ramps()[std::size_t(findRamp("viridis"))];
    Image picture{a.data, a.data, {}};
    for (const char* name : {"R", "G", "B"}) picture.addFloat(name);
    for (std::size_t k = 0; k < flip_map.size(); ++k) {
        dvec3 colour = rampColour(ramp, double(flip_map[k]));
        for (int c = 0; c < 3; ++c) picture.channels[std::size_t(c)].floats()[k] = float(colour[c]);
    }
    return picture;
}

// JSON has no infinity: null stands for it.
nlohmann::ordered_json finite(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

void printJson(const DiffOptions& options, const Result& result, bool beyond) {
    const Comparison& c = result.comparison;
    nlohmann::ordered_json json = {{"a", options.a},         {"b", options.b},         {"mae", finite(c.mae)},
                                   {"rmse", finite(c.rmse)}, {"psnr", finite(c.psnr)}, {"max", finite(c.max)}};
    json["flip"] = result.flip ? finite(*result.flip) : nullptr;
    json["non_finite"] = c.non_finite;
    json["worst"] = nullptr;
    if (c.worst)
        json["worst"] = {{"x", c.worst->x},
                         {"y", c.worst->y},
                         {"channel", c.worst->channel},
                         {"a", finite(c.worst->a)},
                         {"b", finite(c.worst->b)}};
    if (options.threshold) json["within_threshold"] = !beyond;
    printText(jsonText(json));
}

void printTable(const Result& result) {
    const Comparison& c = result.comparison;
    print("MAE    {:.6g}\nRMSE   {:.6g}\nPSNR   {:.4g} dB\n", c.mae, c.rmse, c.psnr);
    if (result.flip) print("FLIP   {:.6g}\n", *result.flip);
    if (!c.worst)
        print("worst  none: the pictures are equal\n");
    else
        print("worst  {:.6g} at pixel {}, {} in {}: {:.9g} against {:.9g}\n", c.max, c.worst->x, c.worst->y,
              c.worst->channel, c.worst->a, c.worst->b);
    if (c.non_finite > 0) print("{} values are NaN or infinite in one picture only\n", c.non_finite);
}

double metricOf(const Result& result, Metric metric) {
    switch (metric) {
        case Metric::Mae:
            return result.comparison.mae;
        case Metric::Rmse:
            return result.comparison.rmse;
        case Metric::Flip:
            return *result.flip;
        case Metric::Max:
            return result.comparison.max;
    }
    return 0.0;
}

int runDiff(const DiffOptions& options) {
    checkOptions(options);
    Image a = readPicture(options.a), b = readPicture(options.b);
    std::vector<std::string> channels = options.channels;
    if (channels.empty()) channels = {"R", "G", "B"};
    requireSameWindow(options, a, b);
    requireChannels(options.a, a, channels);
    requireChannels(options.b, b, channels);
    Result result = compare(options, a, b, channels);
    if (!options.outfile.empty()) {
        bool png = extensionOf(options.outfile) == ".png";
        writePicture(options.outfile, png ? flipPicture(a, *result.flip_map) : differencePicture(a, b, channels), {});
    }
    bool beyond = options.threshold && metricOf(result, options.metric) > *options.threshold;
    options.json ? printJson(options, result, beyond) : printTable(result);
    return int(beyond ? ExitCode::ComparisonFailed : ExitCode::Ok);
}

}  // namespace

void addDiff(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "diff", "Compare two pictures, .exr or .png, in linear light: MAE, RMSE, PSNR, FLIP, worst pixel");
    auto options = std::make_shared<DiffOptions>();
    command->add_option("a", options->a, "Reference picture")->type_name("FILE")->required();
    command->add_option("b", options->b, "Picture to compare with it")->type_name("FILE")->required();
    command->add_option("--channel", options->channels, "Compare this channel of two .exr, not R, G, B; repeatable")
        ->type_name("NAME")
        ->expected(1);
    command->add_option("--threshold", options->threshold, "Exit with 5 when the metric is greater")->type_name("X");
    addChoice<Metric>(*command, "--metric", options->metric,
                      {{"mae", Metric::Mae}, {"rmse", Metric::Rmse}, {"flip", Metric::Flip}, {"max", Metric::Max}},
                      "The metric of --threshold; default: mae", "mae|rmse|flip|max");
    command
        ->add_option("-o,--outfile", options->outfile,
                     "Difference picture to write: .png, FLIP from dark (0) to yellow (1); or .exr, B minus A")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Print the result as JSON; null is infinity");
    command->callback([options, &action] { action = [options] { return runDiff(*options); }; });
}

}  // namespace dsphere::cli
