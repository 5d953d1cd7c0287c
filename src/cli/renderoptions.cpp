#include "cli/renderoptions.h"

#include "render/planes.h"

#include <cmath>

namespace dsphere::cli {

namespace {

void addDetail(CLI::App& command, float& detail) {
    const CLI::callback_t read = [&detail](const CLI::results_t& words) {
        detail = 0.0f;
        if (words[0] == "exact") return true;
        if (!CLI::detail::lexical_cast(words[0], detail) || !(detail > 0.0f) || !std::isfinite(detail))
            throw CLI::ValidationError("--detail", "expected exact or a number of pixels above 0, not " + words[0]);
        return true;
    };
    command
        .add_option("--detail", read,
                    "exact (the default), or how many pixels the surface may be off where texels are smaller than "
                    "pixels: faster, and without aliasing")
        ->type_name("exact|PIXELS");
}

void addPictureOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("-o,--outfile", options.outfile,
                    "Picture to write, .png or .exr; default: the scene's Film; - is standard output")
        ->type_name("FILE");
    addChoice<std::optional<Format>>(command, "--format", options.format, {{"png", Format::Png}, {"exr", Format::Exr}},
                                     "What -o - writes; default: png", "png|exr");
    command.add_option("--aov", options.aov, "Further outputs into the .exr: all, or " + aovNames(","))
        ->type_name("LIST");
    command.add_flag("--alpha", options.alpha,
                     "Transparent where nothing is hit, infinite lights behind the shapes too: a .png gets an alpha "
                     "channel, which an .exr always has");
    addToneOptions(command, options.exposure, options.tone);
    command.add_flag("--reproducible", options.reproducible,
                     "Leave the time, the device and its driver out of the .exr's header: runs then write the same "
                     "bytes, and --resume cannot go on from them");
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& options) {
    addSceneOptions(command, options.scene);
    command.add_option("--spp", options.scene.samples, "Samples a pixel; 0: only the --aov outputs");
    command.add_option("--seed", options.scene.seed, "Seed of the sample positions");
    addPictureOptions(command, options);
    command
        .add_option("--clamp", options.clamp,
                    "Scale down samples whose greatest channel is above X, to X: fewer bright specks, some light "
                    "lost; 0 (the default): none")
        ->type_name("X");
    command.add_flag("--write-partial", options.write_partial,
                     "When interrupted, complete the sample in progress and write the picture of those done");
    command
        .add_option("--resume", options.resume,
                    "An .exr that render wrote of the same scene and options with fewer samples: go on from it; the "
                    "picture is that of an uninterrupted render, bit for bit")
        ->type_name("FILE.exr");
    addDetail(command, options.detail);
    addFrameOptions(command, options.frames);
    addShardOptions(command, options.shard);
    addCommonOptions(command, options.common, Devices::AndHost);
}

}  // namespace dsphere::cli
