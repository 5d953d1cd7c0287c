#include "cli/target.h"

#include "base/error.h"
#include "cli/outputs.h"
#include "render/raster.h"

#include <unistd.h>

#include <cmath>

namespace dsphere::cli {

namespace {

Format formatOf(const RenderOptions& options, const std::filesystem::path& path) {
    if (path == kStandardOutput) return options.format.value_or(Format::Png);
    if (options.format) throwUsage("--format is for -o -; the name of a file says its format");
    const std::string extension = extensionOf(path);
    if (extension != ".png" && extension != ".exr")
        throwUsage("{}: unknown picture format '{}'; .png and .exr are supported", path.string(),
                   path.extension().string());
    return extension == ".png" ? Format::Png : Format::Exr;
}

void checkSampling(const RenderOptions& options, int samples, std::uint32_t aovs) {
    if (samples < 0 || samples > 65536) throwUsage("--spp: {} is outside 0 to 65536", samples);
    if (!(options.clamp >= 0.0 && std::isfinite(options.clamp)))
        throwUsage("--clamp: {} is not a number of 0 or more", options.clamp);
    if (samples == 0 && !options.resume.empty()) throwUsage("--resume needs --spp above 0");
    if (samples == 0 && !aovs) throwUsage("--spp 0 renders no colour, so it needs --aov");
    if (options.detail > 0.0f && options.scene.marcher != Marcher::Exact)
        throwUsage("--detail is of the exact marcher; the baselines march the map itself");
}

void checkFormat(const RenderOptions& options, const Target& target) {
    const std::string name = target.name();
    if (options.exposure && !std::isfinite(*options.exposure))
        throwUsage("--exposure: {} is not a finite number of stops", *options.exposure);
    if (target.format == Format::Png && target.aovs)
        throwUsage("{}: a PNG cannot hold --aov outputs; write .exr", name);
    if (target.format == Format::Png && options.shard.wanted())
        throwUsage("{}: a part of a picture must be an .exr", name);
    if (target.format == Format::Png) return;
    if (options.tone != ToneCurve::Linear) throwUsage("{}: an EXR holds light as it is; --tone is for .png", name);
    if (options.exposure) throwUsage("{}: an EXR holds light as it is; --exposure is for .png", name);
}

}  // namespace

Target checkTarget(const RenderOptions& options, const Scene& scene, const std::filesystem::path& path) {
    Target target{.path = path};
    target.aovs = parseAovs(options.aov);
    target.format = formatOf(options, target.path);
    if (target.format == Format::Exr || options.alpha) target.colours |= kAlphaPlane;
    checkFormat(options, target);
    if (const Box box = cropBox(scene.film); target.format == Format::Png)
        checkPngSize(target.name(), box.width(), box.height(), options.alpha ? 4 : 3);
    checkSampling(options, scene.sampler.pixel_samples, target.aovs);
    if (target.isOutput() && options.common.json) throwUsage("-o - and --json both write to standard output");
    if (target.isOutput() && isatty(STDOUT_FILENO))
        throwUsage("-o -: standard output is a terminal, which shows no pictures; redirect it");
    std::vector<NamedFile> inputs = inputsOf(scene);
    checkOutputs({{target.path, options.outfile.empty() ? "the scene's Film" : "--outfile"}}, inputs);
    return target;
}

void writeTarget(const Target& target, const Image& picture, const Metadata& metadata, const RenderOptions& options) {
    if (target.format == Format::Exr)
        writeExr(target.path, picture, metadata);
    else
        writePng(target.path, picture, {options.exposure.value_or(0.0), options.tone});
}

}  // namespace dsphere::cli
