// SPDX-License-Identifier: MIT
#include "cli/bench/skips.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/bench/image_size.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/versions.hpp"
#include "effect/study/copy_clock.hpp"
#include "effect/study/skip_cases.hpp"
#include "effect/study/skip_shares.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

using effect::SkipCase;
using effect::SkipTimes;
using nlohmann::ordered_json;

struct ShareRow {
    effect::SkipShare made;
    effect::SkipPair times;
};

struct Row {
    SkipCase skip_case;
    SkipTimes times;
};

// A count of tiles as a part of all, in per cent.
double percent(std::uint64_t tiles, const effect::Work& work) {
    return 100.0 * static_cast<double>(tiles) / static_cast<double>(work.tiles);
}

// Pixels with a march that was ended, as a share of those with a surface, in per cent.
double ended_early(const effect::Work& work) {
    const auto pixels = static_cast<double>(std::max<std::uint64_t>(work.pixels - work.background, 1));
    return 100.0 * static_cast<double>(work.ended_early) / pixels;
}

// The target as a share of the time without skips, and whether it is met; "" without a target.
std::string verdict(double ratio, double target) {
    return target > 0.0 ? fmt::format("{:.2f}, {}", target, ratio <= target ? "met" : "missed")
                        : std::string();
}

std::string table_row(const Row& row) {
    const SkipTimes& t = row.times;
    const auto part = [&](double time) { return time / t.without; };
    return fmt::format(
        "| {} | {} | {:.0f} % | {:.0f} % | {:.0f} % | {:.0f} % | {:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} "
        "| "
        "{:.2f} | {:.2f} | {:.2f} | {} |\n",
        row.skip_case.name, row.skip_case.what, percent(t.work.tiles_blank, t.work),
        percent(t.work.tiles_open, t.work), percent(t.work.tiles_settled, t.work), ended_early(t.work),
        t.without / t.copy, t.with / t.copy, part(t.background), part(t.open), part(t.settled),
        part(t.closed), part(t.with), t.with / t.fresh, verdict(part(t.with), row.skip_case.target));
}

std::string table_of(const std::vector<Row>& rows) {
    std::string text =
        "| scene | | tiles of background | open | settled | of pixels marches ended | copies without | "
        "copies | of the "
        "time without: "
        "background left out | open | "
        "settled | closed | all | of a first frame | target "
        "|\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const Row& row : rows) text += table_row(row);
    return text;
}

std::string table_of(const std::vector<ShareRow>& rows) {
    std::string text =
        "| part of the image | | tiles of background | open | settled | filtered enough | copies without | "
        "copies | of the time "
        "without | target |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const auto& [made, t] : rows) {
        text += fmt::format(
            "| {} | {:.0f} % | {:.0f} % | {:.0f} % | {:.0f} % | {:.0f} % | {:.1f} | {:.1f} | {:.2f} | {} |\n",
            made.skip_case.name, 100.0 * made.share, percent(t.work.tiles_blank, t.work),
            percent(t.work.tiles_open, t.work), percent(t.work.tiles_settled, t.work),
            percent(t.work.tiles_unfiltered, t.work), t.without / t.copy, t.with / t.copy, t.with / t.without,
            verdict(t.with / t.without, made.skip_case.target));
    }
    return text;
}

ordered_json row_json(const ShareRow& row) {
    const effect::SkipPair& t = row.times;
    return {{"part", row.made.skip_case.name},
            {"share", row.made.share},
            {"tiles", t.work.tiles},
            {"tiles_blank", t.work.tiles_blank},
            {"tiles_open", t.work.tiles_open},
            {"tiles_settled", t.work.tiles_settled},
            {"copy_ms", t.copy},
            {"without_ms", t.without},
            {"with_ms", t.with},
            {"ratio", t.with / t.without},
            {"target", row.made.skip_case.target}};
}

ordered_json row_json(const Row& row) {
    const SkipTimes& t = row.times;
    ordered_json passes;
    for (const effect::PassTime& pass : t.passes) passes[pass.pass] = pass.ms;
    return {{"scene", row.skip_case.name},
            {"what", row.skip_case.what},
            {"tiles", t.work.tiles},
            {"tiles_blank", t.work.tiles_blank},
            {"tiles_open", t.work.tiles_open},
            {"tiles_settled", t.work.tiles_settled},
            {"pixels_ended_early", t.work.ended_early},
            {"tiles_filtered", t.work.tiles_filtered},
            {"copy_ms", t.copy},
            {"without_ms", t.without},
            {"with_ms", t.with},
            {"background_ms", t.background},
            {"open_ms", t.open},
            {"closed_ms", t.closed},
            {"settled_ms", t.settled},
            {"first_frame_ms", t.fresh},
            {"ratio", t.with / t.without},
            {"copies", t.with / t.copy},
            {"passes_ms", passes},
            {"target", row.skip_case.target}};
}

}  // namespace

int run_bench_skips(const BenchSkipsOptions& options) {
    const gpu::Extent extent = image_size(options.size);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    effect::require_timestamps(device.info());
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const auto progress = progress_bar("skips");
    const std::vector<SkipCase> cases = effect::skip_cases(device, passes, extent);
    const std::vector<effect::SkipShare> shares = effect::skip_shares(device, passes, extent);
    const auto total = static_cast<double>(cases.size() + shares.size());
    effect::SkipStudy study(device, passes, extent);
    std::vector<Row> rows;
    for (const SkipCase& skip_case : cases) {
        rows.push_back({skip_case, study.times(skip_case, options.rounds)});
        progress(static_cast<double>(rows.size()) / total);
    }
    std::vector<ShareRow> share_rows;
    for (const effect::SkipShare& share : shares) {
        share_rows.push_back({share, study.pair(share.skip_case, options.rounds)});
        progress(static_cast<double>(rows.size() + share_rows.size()) / total);
    }
    fmt::print("{}, {} x {} pixels\n\n{}\n{}", device.info().name, extent.width, extent.height,
               table_of(rows), table_of(share_rows));
    ordered_json document{{"versions", versions()},
                          {"device", device.info().name},
                          {"width", extent.width},
                          {"height", extent.height}};
    document["cases"] = ordered_json::array();
    for (const Row& row : rows) document["cases"].push_back(row_json(row));
    document["shares"] = ordered_json::array();
    for (const ShareRow& row : share_rows) document["shares"].push_back(row_json(row));
    json.write(document.dump(2) + "\n");
    return validation_status(device);
}

void add_bench_skips(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchSkipsOptions>();
    CLI::App* command = bench.add_subcommand("skips", "time saved by skipping what the scene does not need");
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command->add_option("--rounds", options->rounds, "over all ways to run a scene")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->callback([options, &status] { status = run_bench_skips(*options); });
}

}  // namespace gloam::cli
