#include "cli/commands.h"

#include "base/error.h"

#include <fmt/ranges.h>

namespace dsphere::cli {

void addCommonOptions(CLI::App& command, CommonOptions& options) {
    command
        .add_option("--device", options.device,
                    "Vulkan device: its index, a part of its name, or cpu; render and verify also know host and "
                    "host-double: the shaders compiled for the CPU, in float or double, without Vulkan")
        ->type_name("INDEX|NAME|cpu|host|host-double");
    command.add_flag("--validation", options.validation, "Run under the Vulkan validation layers; any message fails");
    command.add_flag("--json", options.json, "Print the result as JSON on standard output");
    command.add_flag("--quiet", options.quiet, "Print errors only");
    command.add_flag("--verbose", options.verbose, "Print more about maps, memory and timing");
    addProgressOption(command, options.progress);
}

void addProgressOption(CLI::App& command, ProgressMode& progress) {
    addChoice<ProgressMode>(
        command, "--progress", progress,
        {{"auto", ProgressMode::Auto}, {"always", ProgressMode::Always}, {"never", ProgressMode::Never}},
        "Progress line: on a terminal (auto, the default), always or never", "auto|always|never");
}

gpu::Device openDevice(const CommonOptions& options, bool caches) {
    return gpu::Device({.selector = options.device, .validation = options.validation, .caches = caches});
}

void checkValidation(const gpu::Device& device) {
    const auto& messages = device.validationMessages();
    if (!messages.empty()) throwFailure("the validation layers object:\n{}", fmt::join(messages, "\n"));
}

}  // namespace dsphere::cli
