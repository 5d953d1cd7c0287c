#pragma once

#include "cli/terminal.h"
#include "gpu/device.h"

#include <CLI/CLI.hpp>

#include <functional>
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

void addCommonOptions(CLI::App& command, CommonOptions& options);

/// The device that the options ask for.
gpu::Device openDevice(const CommonOptions& options);

/// Throws Error (Failure) with the messages if the validation layers had any.
void checkValidation(const gpu::Device& device);

void addRender(CLI::App& app, Action& action);
void addVerify(CLI::App& app, Action& action);
void addDevices(CLI::App& app, Action& action);

}  // namespace dsphere::cli
