#include "cli/commands.h"

#include "base/error.h"

#include <fmt/ranges.h>

#include <map>

namespace dsphere::cli {

void addCommonOptions(CLI::App& command, CommonOptions& options) {
    static const std::map<std::string, ProgressMode> modes = {
        {"auto", ProgressMode::Auto}, {"always", ProgressMode::Always}, {"never", ProgressMode::Never}};
    command.add_option("--device", options.device, "Vulkan device: its index, a part of its name, or cpu")
        ->type_name("INDEX|NAME|cpu");
    command.add_flag("--validation", options.validation, "Run under the Vulkan validation layers; any message fails");
    command.add_flag("--json", options.json, "Print the result as JSON on standard output");
    command.add_flag("--quiet", options.quiet, "Print errors only");
    command.add_flag("--verbose", options.verbose, "Print more about maps, memory and timing");
    command.add_option("--progress", options.progress, "Progress line: auto (on a terminal), always or never")
        ->transform(CLI::CheckedTransformer(modes, CLI::ignore_case))
        ->type_name("auto|always|never");
}

gpu::Device openDevice(const CommonOptions& options) {
    return gpu::Device({options.device, options.validation});
}

void checkValidation(const gpu::Device& device) {
    const auto& messages = device.validationMessages();
    if (!messages.empty()) throwFailure("the validation layers object:\n{}", fmt::join(messages, "\n"));
}

}  // namespace dsphere::cli
