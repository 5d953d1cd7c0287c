#include "base/error.h"
#include "cli/commands.h"

#include <fmt/format.h>

#include <csignal>

namespace dsphere::cli {

namespace {

int exitCodeOf(const Error& error) {
    if (error.code() == ExitCode::Interrupted && caughtSignal() == SIGTERM) return int(ExitCode::Terminated);
    return int(error.code());
}

int run(int argc, char** argv) {
    CLI::App app("Ray-traces displacement-mapped spheres on a Vulkan device, exactly.", "dsphere");
    app.set_version_flag("--version", "dsphere " DSPHERE_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 ok, 1 render or I/O failure, 2 usage, 3 invalid scene or map, 4 no usable device,\n"
        "5 comparison failed, 130 interrupted, 143 terminated.");
    Action action;
    addView(app, action);
    addRender(app, action);
    addVerify(app, action);
    addBench(app, action);
    addDiff(app, action);
    addInfo(app, action);
    addGenerate(app, action);
    addDevices(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        throw Error(ExitCode::Usage, fmt::format("{}; see dsphere --help", error.what()));
    }
    catchSignals();
    return action();
}

}  // namespace

}  // namespace dsphere::cli

// The one place that catches: every failure becomes a line on standard error and an exit code.
int main(int argc, char** argv) {
    using namespace dsphere;
    try {
        return cli::run(argc, argv);
    } catch (const Error& error) {
        cli::printError(error.what());
        return cli::exitCodeOf(error);
    } catch (const std::bad_alloc&) {
        cli::printError("out of memory");
    } catch (const std::exception& error) {
        cli::printError(error.what());
    }
    return int(ExitCode::Failure);
}
