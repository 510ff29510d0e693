// SPDX-License-Identifier: MIT
#include "cli/bench/benchmark.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/bench/answers.hpp"
#include "cli/bench/configurations.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/bench/measure.hpp"
#include "cli/environment.hpp"
#include "cli/read_text.hpp"
#include "effect/study/copy_clock.hpp"
#include "report/benchmark/benchmark_json.hpp"
#include "report/benchmark/budget.hpp"
#include "report/benchmark/compare.hpp"
#include "report/benchmark/pareto.hpp"
#include "report/benchmark/tables.hpp"
#include "report/output_file.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {
namespace {

report::Benchmark benchmark_of(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    try {
        return report::benchmark_from_json(text);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("{} is not what `gloam bench --json` writes: {}", file.string(), error.what()));
    }
}

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
        report::compared(benchmark_of(options.compare.at(0)), benchmark_of(options.compare.at(1)));
    fmt::print("{}", report::to_text(comparison));
    return options.fail_if_worse && comparison.got_worse() ? 1 : 0;
}

void print_fronts(const report::Benchmark& benchmark) {
    fmt::print("{} ({}), {} x {} pixels; a copy takes {:.4f} ms. Pareto fronts, time against RMSE (G):\n",
               benchmark.device, benchmark.driver, benchmark.width, benchmark.height,
               benchmark.copy_ms.median);
    for (const std::string& scene : report::scenes_of(benchmark))
        fmt::print("\n{}\n\n{}", scene, report::scene_front_table(benchmark, scene));
    fmt::print("\nall scenes\n\n{}", report::overall_table(benchmark));
}

// The files of one run: whether they can be written is found out before it.
class Outputs {
  public:
    explicit Outputs(const BenchmarkOptions& options) : json_(options.json), csv_(options.csv) {
        if (!options.out.empty()) folder_.emplace(options.out);
    }

    // The journal is worth keeping whatever happens next.
    void keep_folder() {
        if (folder_) folder_->keep();
    }

    void write(const report::Benchmark& benchmark) {
        json_.write(report::to_json(benchmark));
        csv_.write(report::to_csv(benchmark));
        if (!folder_) return;
        folder_->write("results.json", report::to_json(benchmark));
        folder_->write("results.csv", report::to_csv(benchmark));
        folder_->keep();
    }

  private:
    report::OutputFile json_;
    report::OutputFile csv_;
    std::optional<report::OutputFolder> folder_;
};

int report_on(const report::Benchmark& benchmark, const BenchmarkOptions& options, Outputs& outputs) {
    outputs.write(benchmark);
    print_fronts(benchmark);
    return answer(benchmark, options) ? 0 : 1;
}

}  // namespace

int run_benchmark(const BenchmarkOptions& options) {
    check(options);
    if (!options.compare.empty()) return compare_files(options);
    if (!options.from.empty()) {
        const report::Benchmark benchmark = benchmark_of(options.from);
        Outputs outputs(options);
        return report_on(benchmark, options, outputs);
    }
    gpu::Device device({.device = options.device,
                        .validation = options.validation ? gpu::Validation::on : gpu::Validation::off,
                        .cache_directory = cache_directory()});
    effect::require_timestamps(device.info());
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    Outputs outputs(options);
    outputs.keep_folder();
    const int status = report_on(measured_benchmark(options, device, passes), options, outputs);
    const auto messages = device.take_validation_messages();
    for (const std::string& message : messages) fmt::print(stderr, "gloam: {}\n", message);
    return messages.empty() ? status : 1;
}

}  // namespace gloam::cli
