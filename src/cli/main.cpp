#include "base/error.h"
#include "cli/commands.h"
#include "cli/print.h"
#include "cli/signals.h"
#include "cli/usage.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

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
    addMerge(app, action);
    addVerify(app, action);
    addSelftest(app, action);
    addQuery(app, action);
    addBake(app, action);
    addBench(app, action);
    addDiff(app, action);
    addInfo(app, action);
    addImport(app, action);
    addGenerate(app, action);
    addDevices(app, action);
    checkArguments(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw Error(ExitCode::Usage, explained(app, error));
        std::ostringstream help, nothing;  // --help, --version
        app.exit(error, help, nothing);
        printText(help.str());
        return int(ExitCode::Ok);
    }
    return action();
}

std::string messageOf(const std::filesystem::filesystem_error& error) {
    return fmt::format("{}: {}", error.path1().string(), error.code().message());
}

// A thread that could not be started is short of memory, or of the processes that the user may have.
std::string messageOf(const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
        return "no further thread could be started: memory, or the number of processes allowed, is short";
    return error.code().message();
}

// After a signal libraries are not waited for: they may take long to take themselves down.
int ended(int code) {
    if (caughtSignal() != 0) std::_Exit(code);
    return code;
}

}  // namespace

}  // namespace dsphere::cli

// The one place that catches: every failure becomes a line on standard error and an exit code.
int main(int argc, char** argv) {
    using namespace dsphere;
    cli::catchSignals();
    cli::openClosedStreams();
    try {
        const int code = cli::run(argc, argv);
        cli::finishOutput();
        return code;
    } catch (const Error& error) {
        cli::printError(error.what());
        return cli::ended(cli::exitCodeOf(error));
    } catch (const std::bad_alloc&) {
        cli::printError("out of memory");
    } catch (const std::filesystem::filesystem_error& error) {
        cli::printError(cli::messageOf(error));
    } catch (const std::system_error& error) {
        cli::printError(cli::messageOf(error));
    } catch (const std::exception& error) {
        cli::printError(error.what());
    }
    return int(ExitCode::Failure);
}
