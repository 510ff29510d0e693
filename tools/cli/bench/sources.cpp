// SPDX-License-Identifier: MIT
#include "cli/bench/sources.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/versions.hpp"
#include "effect/study/source_study.hpp"
#include "report/output_file.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

using effect::SourceRow;
using nlohmann::ordered_json;

// Two rows give one row of the table: without the filter and with it.
std::string issao_table(const std::vector<SourceRow>& rows) {
    std::string text =
        "| method | samples taken | no filter, ms | bilateral, ms | difference | error | error, bilateral |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n";
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
        const double plain = rows[i].occlusion_ms;
        const double filtered = rows[i + 1].occlusion_ms + rows[i + 1].filter_ms;
        text +=
            fmt::format("| {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} |\n", rows[i].name,
                        rows[i].taken, plain, filtered, filtered - plain, rows[i].error, rows[i + 1].error);
    }
    return text;
}

std::string radius_table(const std::vector<SourceRow>& rows) {
    std::string text =
        "| scene | configuration | | samples | ms | error | error, of the smaller radius |\n"
        "|---|---|---|--:|--:|--:|--:|\n";
    for (const SourceRow& row : rows)
        text +=
            fmt::format("| {} | {} | {} | {:.0f} | {:.2f} | {:.3f} | {:.3f} |\n", row.scene, row.name,
                        row.what, row.taken, row.occlusion_ms + row.filter_ms, row.error, row.error_before);
    return text;
}

std::string quality_table(const std::vector<SourceRow>& rows) {
    std::string text =
        "| scene | configuration | samples | ms | error | error, best remap |\n|---|---|--:|--:|--:|--:|\n";
    for (const SourceRow& row : rows)
        text += fmt::format("| {} | {} | {} | {:.2f} | {:.3f} | {:.3f} |\n", row.scene, row.name,
                            row.settings.samples, row.occlusion_ms, row.error, row.error_remapped);
    return text;
}

ordered_json rows_json(const std::vector<SourceRow>& rows) {
    ordered_json all = ordered_json::array();
    for (const SourceRow& row : rows)
        all.push_back({{"scene", row.scene},
                       {"configuration", row.name},
                       {"what", row.what},
                       {"radius", row.radius},
                       {"samples", row.settings.samples},
                       {"samples_taken", row.taken},
                       {"occlusion_ms", row.occlusion_ms},
                       {"filter_ms", row.filter_ms},
                       {"error", row.error},
                       {"error_smaller_radius", row.error_before},
                       {"error_remapped", row.error_remapped}});
    return all;
}

void append(std::vector<SourceRow>& rows, const std::vector<SourceRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

}  // namespace

int run_bench_sources(const BenchSourcesOptions& options) {
    effect::SourceOptions study{
        .extent = image_size(options.size), .rounds = options.rounds, .rays = options.rays};
    (void)scene::make_scene(options.table_scene);
    for (const std::string& name : options.scenes) (void)scene::make_scene(name);
    std::string page = options.page.empty() ? "" : read_page(options.page);
    if (!options.page.empty())
        (void)with_blocks(page, {{"issao_table", ""}, {"quality", ""}, {"radius", ""}});
    const report::OutputFile page_file(options.page);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const scene::TruthCache cache(truth_cache_directory());
    study.progress = progress_bar("ISSAO's table 1");
    const auto table = effect::study_issao_table(device, passes, cache, options.table_scene, study);
    std::vector<SourceRow> quality;
    std::vector<SourceRow> radius;
    for (const std::string& name : options.scenes) {
        study.progress = progress_bar(name + ": quality");
        append(quality, effect::study_quality(device, passes, cache, name, study));
        study.progress = progress_bar(name + ": radius");
        append(radius, effect::study_radius(device, passes, cache, name, study));
    }
    const std::vector<PageBlock> blocks{{"issao_table", issao_table(table)},
                                        {"quality", quality_table(quality)},
                                        {"radius", radius_table(radius)}};
    fmt::print("{}, {} x {} pixels, least of {} runs\n\n", device.info().name, study.extent.width,
               study.extent.height, study.rounds);
    for (const PageBlock& block : blocks) fmt::print("{}\n", block.text);
    const ordered_json document{{"versions", versions()},          {"device", device.info().name},
                                {"width", study.extent.width},     {"height", study.extent.height},
                                {"issao_table", rows_json(table)}, {"quality", rows_json(quality)},
                                {"radius", rows_json(radius)}};
    json.write(document.dump(2) + "\n");
    if (!options.page.empty()) page_file.write(with_blocks(page, blocks));
    return validation_status(device);
}

void add_bench_sources(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchSourcesOptions>();
    CLI::App* command = bench.add_subcommand("sources",
                                             "experiments that the sources print: ISSAO's table 1, the "
                                             "study's quality configurations and doubled radius");
    command->add_option("--table-scene", options->table_scene, "built-in scene of ISSAO's table 1")
        ->capture_default_str();
    command->add_option("--scene", options->scenes, "built-in scenes of the study's experiments")
        ->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command->add_option("--rounds", options->rounds, "in which everything is timed once")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page, "page whose tables are written anew");
    command->callback([options, &status] { status = run_bench_sources(*options); });
}

}  // namespace gloam::cli
