// SPDX-License-Identifier: MIT
#include "cli/bench/benchmark.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/bench/answers.hpp"
#include "cli/bench/benchmark_files.hpp"
#include "cli/bench/configurations.hpp"
#include "cli/bench/framework.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/bench/measure.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "effect/study/copy_clock.hpp"
#include "report/benchmark/budget.hpp"
#include "report/benchmark/compare.hpp"
#include "report/benchmark/join.hpp"
#include "report/benchmark/pareto.hpp"
#include "report/benchmark/tables.hpp"

namespace gloam::cli {
namespace {

void check(const BenchmarkOptions& options) {
    if (options.temporal_only && options.single_only)
        throw std::invalid_argument("--temporal and --single: expected one of them, or none for both");
    if (options.resume && options.out.empty())
        throw std::invalid_argument("--resume: expected --out, the folder whose journal is taken up again");
    if (!options.budget.empty()) (void)report::time_budget(options.budget);
    if (!options.compare.empty() || !options.from.empty()) return;
    (void)configurations_of(options);
    (void)image_size(options.size);
}

int compare_files(const BenchmarkOptions& options) {
    const report::Comparison comparison =
        report::compared(benchmark_from(options.compare.at(0)), benchmark_from(options.compare.at(1)));
    fmt::print("{}", report::to_text(comparison));
    return options.fail_if_worse && comparison.got_worse() ? 1 : 0;
}

void print_tables(const report::Benchmark& benchmark) {
    if (!benchmark.rows.empty()) {
        fmt::print("{} ({}), {} x {} pixels; a copy takes {:.4f} ms. Pareto fronts, time against RMSE (G):\n",
                   benchmark.device, benchmark.driver, benchmark.width, benchmark.height,
                   benchmark.copy_ms.median);
        for (const std::string& scene : report::scenes_of(benchmark))
            fmt::print("\n{}\n\n{}", scene, report::scene_front_table(benchmark, scene));
        fmt::print("\nall scenes\n\n{}", report::overall_table(benchmark));
    }
    if (!benchmark.framework.empty()) fmt::print("\nframework\n\n{}", report::framework_table(benchmark));
}

int report_on(const report::Benchmark& benchmark, const BenchmarkOptions& options, BenchmarkFiles& files) {
    files.write(benchmark);
    print_tables(benchmark);
    return answer(benchmark, options) ? 0 : 1;
}

report::Benchmark measured(const BenchmarkOptions& options, const gpu::Device& device) {
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    if (!options.framework) return measured_benchmark(options, device, passes);
    return {.device = device.info().name,
            .driver = device.info().driver,
            .framework = framework_figures(options.device, options.repeat, progress_bar("framework"))};
}

}  // namespace

int run_benchmark(const BenchmarkOptions& options) {
    check(options);
    if (!options.compare.empty()) return compare_files(options);
    if (!options.from.empty()) {
        std::vector<report::Benchmark> parts;
        for (const auto& file : options.from) parts.push_back(benchmark_from(file));
        const report::Benchmark benchmark = report::joined(parts);
        BenchmarkFiles files(options);
        return report_on(benchmark, options, files);
    }
    gpu::Device device = open_device(options.device, options.validation);
    effect::require_timestamps(device.info());
    BenchmarkFiles files(options);
    files.keep_folder();
    report::Benchmark benchmark = measured(options, device);
    benchmark.versions = versions();
    const int status = report_on(benchmark, options, files);
    const int messages = validation_status(device);
    return messages == 0 ? status : messages;
}

}  // namespace gloam::cli
