#include "cli/commands.h"

#include "base/error.h"

#include <fmt/ranges.h>

namespace dsphere::cli {

void addCommonOptions(CLI::App& command, CommonOptions& options, Devices devices) {
    const bool host = devices == Devices::AndHost;
    command
        .add_option("--device", options.device,
                    std::string("Vulkan device: its index, a part of its name, or cpu") +
                        (host ? "; or the CPU without Vulkan: host, or in double precision host-double" : ""))
        ->type_name(host ? "INDEX|NAME|cpu|host|host-double" : "INDEX|NAME|cpu");
    command.add_flag("--validation", options.validation, "Run under the Vulkan validation layers; any message fails");
    command.add_flag("--json", options.json, "Print the result as JSON on standard output");
    command.add_flag("--quiet", options.quiet, "Print errors only");
    command.add_flag("--verbose", options.verbose, "Print more about maps, memory and timing");
    addProgressOption(command, options.progress);
}

void addProgressOption(CLI::App& command, ProgressMode& progress) {
    addChoice<ProgressMode>(
        command, "--progress", progress,
        {{"auto", ProgressMode::Auto},
         {"always", ProgressMode::Always},
         {"never", ProgressMode::Never},
         {"lines", ProgressMode::Lines}},
        "Progress line: on a terminal (auto, the default), always or never; lines: \"Progress: 42%\" at each percent, "
        "for programs that watch",
        "auto|always|never|lines");
}

void addToneOptions(CLI::App& command, std::optional<double>& exposure, ToneCurve& curve) {
    command.add_option("--exposure", exposure, "Stops to brighten a .png by")->type_name("STOPS");
    addChoice<ToneCurve>(
        command, "--tone", curve,
        {{"linear", ToneCurve::Linear}, {"aces", ToneCurve::Aces}, {"reinhard", ToneCurve::Reinhard}},
        "Curve of a .png's light, after --exposure: linear (the default) cuts at 1; aces: Narkowicz 2015; reinhard: x "
        "/ (1 + x)",
        "linear|aces|reinhard");
}

const char* hostName(host::Precision precision) {
    return precision == host::Precision::Float ? "host" : "host-double";
}

std::optional<host::Precision> hostPrecision(const std::string& device) {
    for (const host::Precision precision : {host::Precision::Float, host::Precision::Double})
        if (CLI::detail::to_lower(device) == hostName(precision)) return precision;
    return {};
}

void requireVulkan(const std::string& device) {
    if (hostPrecision(device))
        throwUsage("--device {}: this command needs a Vulkan device; render, verify and selftest know the host",
                   device);
}

gpu::Device openDevice(const CommonOptions& options, bool caches) {
    requireVulkan(options.device);
    return namingTheHost(
        [&] { return gpu::Device({.selector = options.device, .validation = options.validation, .caches = caches}); });
}

void checkValidation(const gpu::Device& device) {
    const auto& messages = device.validationMessages();
    if (!messages.empty()) throwFailure("the validation layers object:\n{}", fmt::join(messages, "\n"));
}

}  // namespace dsphere::cli
