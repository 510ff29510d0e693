// SPDX-License-Identifier: MIT
#include "cli/bench/benchmark_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/bench/benchmark.hpp"
#include "cli/open_device.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {
namespace {

void add_what(CLI::App& bench, BenchmarkOptions& options) {
    bench.add_option("--scene", options.scenes, "built-in scenes")->capture_default_str();
    bench.add_option("--method", options.methods,
                     "methods; `all` for all, which is what is measured unless presets are named");
    bench.add_option("--preset", options.presets, "presets, measured as they are; `all` for all");
    bench.add_option("--samples", options.samples, "samples for each pixel in each frame, of the methods")
        ->check(CLI::Range(std::uint32_t{1}, effect::most_samples))
        ->capture_default_str();
    bench.add_option("--size", options.size, "WIDTHxHEIGHT of the images")->capture_default_str();
    bench.add_flag("--temporal", options.temporal_only, "only over the frames of a moving camera");
    bench.add_flag("--single", options.single_only, "only single frames");
    bench
        .add_option("--frames", options.frames,
                    "frames of a temporal run; half of them, at most 8, are scored")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    bench.add_option("--repeat", options.repeat, "rounds over all configurations")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    bench.add_option("--rays", options.rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
}

void add_costs(CLI::App& bench, BenchmarkOptions& options) {
    bench.add_flag("--framework", options.framework, "instead: what the shader-test framework itself costs");
}

void add_answers(CLI::App& bench, BenchmarkOptions& options) {
    bench.add_option("--budget", options.budget, "name the most exact within this time: 1ms, 40copies");
    bench.add_option("--error", options.error, "name the fastest with at most this RMSE")
        ->check(CLI::PositiveNumber);
    CLI::Option* from =
        bench.add_option("--from", options.from, "results of earlier --json as one, instead of measuring");
    CLI::Option* compare =
        bench.add_option("--compare", options.compare, "two results: what changed from OLD to NEW")
            ->expected(2);
    bench
        .add_flag("--fail-if-worse", options.fail_if_worse,
                  "with --compare: status 1 when something got worse beyond its spread")
        ->needs(compare);
    compare->excludes(from);
    // Options of a measurement; they cannot be combined with result files.
    for (const char* measured : {"--scene", "--method", "--preset", "--samples", "--size", "--temporal",
                                 "--single", "--frames", "--repeat", "--rays", "--framework"}) {
        from->excludes(bench.get_option(measured));
        compare->excludes(bench.get_option(measured));
    }
}

void add_outputs(CLI::App& bench, BenchmarkOptions& options) {
    add_device_options(bench, options.device, options.validation);
    bench.add_option(
        "--report", options.report,
        "write the benchmark as a Markdown page; its plots lie in --out, or images/benchmark beside it");
    bench.add_option("--json", options.json, "write every number to this file");
    bench.add_option("--csv", options.csv, "a line for each configuration");
    bench.add_option("--out", options.out, "folder for results, plots and the journal");
    bench.add_flag("--resume", options.resume, "measure only what the journal in --out lacks")
        ->excludes(bench.get_option("--from"))
        ->excludes(bench.get_option("--compare"));
}

}  // namespace

void add_benchmark(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchmarkOptions>();
    add_what(bench, *options);
    add_costs(bench, *options);
    add_answers(bench, *options);
    add_outputs(bench, *options);
    bench.callback([options, &bench, &status] {
        if (bench.get_subcommands().empty()) status = run_benchmark(*options);
    });
}

}  // namespace gloam::cli
