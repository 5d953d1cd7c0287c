#include "base/error.h"
#include "bench/environment.h"
#include "bench/suite.h"
#include "bench/table.h"
#include "cli/commands.h"
#include "cli/sceneoptions.h"

#include <chrono>

namespace dsphere::cli {

namespace {

struct BenchOptions {
    CommonOptions common;
    std::vector<std::string> scenes, methods;
    std::vector<int> resolution;
    bench::Suite suite;
    bench::Plan plan;
    bool quick = false;
};

int runBench(const BenchOptions& options) {
    bench::Plan plan = options.plan;
    plan.methods = bench::chooseMethods(options.methods);
    std::vector<bench::Source> sources = bench::suiteSources(options.suite);
    auto start = std::chrono::steady_clock::now();
    gpu::Device device = openDevice(options.common);
    double open_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    bench::Results results;
    {
        ProgressLine line(options.common.progress, options.common.quiet, "bench");
        results.views = bench::measure(device, sources, plan, [&](double share) { return line.update(share); });
    }
    checkValidation(device);
    results.environment = bench::describeEnvironment(device, open_seconds);
    fmt::print("{}", bench::table(results));
    return int(ExitCode::Ok);
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bench", "Measure speed against error, beside other methods");
    auto options = std::make_shared<BenchOptions>();
    command->add_option("--methods", options->methods, "Methods or families of methods; default: all")->delimiter(',');
    command->add_option("--maps", options->suite.widths, "Widths of the fractal maps")->delimiter(',');
    command->add_option("--displacements", options->suite.percents, "Displacements in percent")->delimiter(',');
    command->add_option("--views", options->suite.views, "Views")->delimiter(',');
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runBench(*options); }; });
}

}  // namespace dsphere::cli
