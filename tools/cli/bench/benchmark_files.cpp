// SPDX-License-Identifier: MIT
#include "cli/bench/benchmark_files.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/arguments.hpp"
#include "report/benchmark/benchmark_json.hpp"
#include "report/benchmark/page.hpp"
#include "report/benchmark/plots.hpp"

namespace gloam::cli {
namespace {

constexpr const char* images_of_page = "images/benchmark";

}  // namespace

report::Benchmark benchmark_from(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    try {
        return report::benchmark_from_json(text);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("{} is not what `gloam bench --json` writes: {}", file.string(), error.what()));
    }
}

BenchmarkFiles::BenchmarkFiles(const BenchmarkOptions& options)
    : json_(options.json), csv_(options.csv), page_(options.report) {
    if (!options.out.empty()) out_.emplace(options.out);
    if (!options.report.empty()) images_.emplace(options.report.parent_path() / images_of_page);
}

void BenchmarkFiles::keep_folder() {
    if (out_) out_->keep();
}

void BenchmarkFiles::write(const report::Benchmark& benchmark) {
    json_.write(report::to_json(benchmark));
    csv_.write(report::to_csv(benchmark));
    if (!out_ && !images_) return;
    for (const auto& [name, plot] : report::plots_of(benchmark)) {
        const std::string svg = report::to_svg(plot);
        const std::string png = report::to_png(plot);
        for (auto* folder : {&images_, &out_}) {
            if (!*folder) continue;
            (*folder)->write(name + ".svg", svg);
            (*folder)->write(name + ".png", png);
        }
    }
    if (images_) images_->keep();
    page_.write(report::to_benchmark_page(benchmark, images_of_page));
    if (!out_) return;
    out_->write("results.json", report::to_json(benchmark));
    out_->write("results.csv", report::to_csv(benchmark));
    out_->keep();
}

}  // namespace gloam::cli
