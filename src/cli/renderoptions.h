#pragma once

// What the command line of render says.

#include "cli/commands.h"
#include "cli/frames.h"
#include "cli/sceneoptions.h"
#include "cli/shards.h"
#include "image/tone.h"

#include <optional>
#include <string>

namespace dsphere::cli {

enum class Format { Png, Exr };

struct RenderOptions {
    CommonOptions common;
    SceneOptions scene;
    std::string outfile, aov, resume;
    FrameOptions frames;
    ShardOptions shard;
    std::optional<Format> format;
    std::optional<double> exposure;
    ToneCurve tone = ToneCurve::Linear;
    double clamp = 0.0;   ///< Integrator::clamp
    float detail = 0.0f;  ///< pixels; 0: exact
    bool alpha = false, write_partial = false, reproducible = false;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);

}  // namespace dsphere::cli
