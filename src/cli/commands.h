#pragma once

#include "base/error.h"
#include "cli/terminal.h"
#include "gpu/device.h"
#include "host/precision.h"
#include "image/tone.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace dsphere::cli {

/// What every command that uses a device understands.
struct CommonOptions {
    std::string device;
    bool validation = false, json = false, quiet = false, verbose = false;
    ProgressMode progress = ProgressMode::Auto;
};

/// Set by the subcommand that the command line names; returns the exit code.
using Action = std::function<int()>;

/// The devices that a command knows: Vulkan's alone, or the host as well.
enum class Devices { Vulkan, AndHost };

void addCommonOptions(CLI::App& command, CommonOptions& options, Devices devices = Devices::Vulkan);
void addProgressOption(CLI::App& command, ProgressMode& progress);
/// --exposure and --tone.
void addToneOptions(CLI::App& command, std::optional<double>& exposure, ToneCurve& curve);

/// An option that takes one of a few words, in any case; the help shows them as `words`.
template <typename T>
CLI::Option* addChoice(CLI::App& command, const std::string& name, T& value, const std::map<std::string, T>& choices,
                       const std::string& help, const std::string& words) {
    auto choose = [&value, name, choices, words](const std::string& given) {
        auto found = choices.find(CLI::detail::to_lower(given));
        if (found == choices.end())
            throw CLI::ValidationError(name, fmt::format("'{}' is not one of {}", given, words));
        value = found->second;
    };
    return command.add_option_function<std::string>(name, choose, help)->type_name(words);
}

/// The host's name as a device: `host` or `host-double`.
const char* hostName(host::Precision precision);
/// Of `host` and `host-double` in any case; empty for other devices.
std::optional<host::Precision> hostPrecision(const std::string& device);
/// Error (Usage) when a command of Vulkan devices alone is given the host.
void requireVulkan(const std::string& device);
/// Returns what `open` does; its Error (NoDevice) names the host too.
template <typename Open>
auto namingTheHost(Open open) {
    try {
        return open();
    } catch (const Error& error) {
        if (error.code() != ExitCode::NoDevice) throw;
        throw Error(
            ExitCode::NoDevice,
            fmt::format("{}\nrender, verify and selftest do without Vulkan, on the CPU: --device host", error.what()));
    }
}

/// The Vulkan device that the options ask for.
gpu::Device openDevice(const CommonOptions& options, bool caches = true);

/// Throws Error (Failure) with the messages if the validation layers had any.
void checkValidation(const gpu::Device& device);

void addRender(CLI::App& app, Action& action);
void addView(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addVerify(CLI::App& app, Action& action);
void addQuery(CLI::App& app, Action& action);
void addBake(CLI::App& app, Action& action);
void addSelftest(CLI::App& app, Action& action);
void addDevices(CLI::App& app, Action& action);
void addDiff(CLI::App& app, Action& action);
void addInfo(CLI::App& app, Action& action);
void addImport(CLI::App& app, Action& action);
void addGenerate(CLI::App& app, Action& action);
void addMerge(CLI::App& app, Action& action);

}  // namespace dsphere::cli
