// SPDX-License-Identifier: MIT
#include "cli/bench/plain.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/bench/slice_taps.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/versions.hpp"
#include "effect/study/plain_study.hpp"
#include "report/benchmark/summary.hpp"
#include "report/output_file.hpp"
#include "scene/rasterize.hpp"

namespace gloam::cli {
namespace {

using effect::PlainComparison;
using nlohmann::ordered_json;

constexpr const char* plain_block = "plain";

// Quotients of the readings that were made beside each other.
report::Spread comparison_ratio(const PlainComparison& row) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < row.plain_ms.size(); ++i)
        ratios.push_back(row.method_ms[i] / row.plain_ms[i]);
    return report::spread_of(ratios);
}

std::string comparison_table(const std::vector<PlainComparison>& rows) {
    std::string text =
        "| method | slices x steps | plain loop, ms | method, ms | ratio of minima | median ratio, quartiles "
        "| RMS difference of the images |\n|---|--:|--:|--:|--:|--:|--:|\n";
    for (const PlainComparison& row : rows) {
        const double plain = *std::ranges::min_element(row.plain_ms);
        const double method = *std::ranges::min_element(row.method_ms);
        const report::Spread ratio = comparison_ratio(row);
        text +=
            fmt::format("| {} | {} x {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} ({:.2f} to {:.2f}) | {:.4f} |\n",
                        row.method, row.taps.slices, row.taps.steps, plain, method, method / plain,
                        ratio.median, ratio.low, ratio.high, row.difference);
    }
    return text;
}

ordered_json comparison_json(const PlainComparison& row) {
    const report::Spread ratio = comparison_ratio(row);
    return {{"method", row.method},
            {"slices", row.taps.slices},
            {"steps", row.taps.steps},
            {"plain_ms", row.plain_ms},
            {"method_ms", row.method_ms},
            {"ratio", {{"median", ratio.median}, {"low", ratio.low}, {"high", ratio.high}}},
            {"rms_difference", row.difference}};
}

std::vector<effect::SliceTaps> taps_asked(const BenchPlainOptions& options) {
    std::vector<effect::SliceTaps> taps;
    for (const std::string& text : options.taps) taps.push_back(slice_taps(text));
    for (const std::string& method : options.methods)
        for (const effect::SliceTaps each : taps) (void)effect::single_frame_of_slices(method, each);
    return taps;
}

}  // namespace

int run_bench_plain(const BenchPlainOptions& options) {
    const gpu::Extent extent = image_size(options.size);
    const std::vector<effect::SliceTaps> taps = taps_asked(options);
    const scene::Scene scene = scene::make_scene(options.scene);
    const std::string old_page = options.page.empty() ? "" : read_page(options.page);
    if (!options.page.empty()) (void)with_blocks(old_page, {{plain_block, ""}});
    const report::OutputFile page(options.page);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const scene::GBuffer view = scene::rasterize(device, passes, scene, extent);
    const std::vector<PlainComparison> rows = effect::compare_with_plain(
        device, passes, view, static_cast<float>(scene.ao_radius), options.methods, taps, options.rounds);
    const std::string text = fmt::format("{} x {} pixels of the scene `{}`, {} rounds.\nOn {} ({}).\n\n{}",
                                         extent.width, extent.height, scene.name, options.rounds,
                                         device.info().name, device.info().driver, comparison_table(rows));
    fmt::print("{}", text);
    if (!options.page.empty()) page.write(with_blocks(old_page, {{plain_block, text}}));
    ordered_json document{{"versions", versions()},
                          {"device", device.info().name},
                          {"driver", device.info().driver},
                          {"width", extent.width},
                          {"height", extent.height},
                          {"scene", scene.name},
                          {"comparisons", ordered_json::array()}};
    for (const PlainComparison& row : rows) document["comparisons"].push_back(comparison_json(row));
    json.write(document.dump(2) + "\n");
    return validation_status(device);
}

void add_bench_plain(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchPlainOptions>();
    CLI::App* command = bench.add_subcommand(
        "plain", "time of methods of slices against that of a plain loop with equal taps");
    command->add_option("--method", options->methods, "methods whose samples are slices")
        ->capture_default_str();
    command->add_option("--taps", options->taps, "SLICESxSTEPS to each side")->capture_default_str();
    command->add_option("--scene", options->scene, "built-in scene")->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command->add_option("--rounds", options->rounds, "over all")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page, "page whose table is written anew (docs/passes.md)");
    command->callback([options, &status] { status = run_bench_plain(*options); });
}

}  // namespace gloam::cli
