// SPDX-License-Identifier: MIT
#include "cli/bench/bar_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/versions.hpp"
#include "report/benchmark/summary.hpp"

namespace gloam::cli {
namespace {

using effect::BarReading;
using nlohmann::ordered_json;
using report::Spread;

Spread spread_of(const BarRow& row, double (*of)(const BarReading&)) {
    std::vector<double> values;
    for (const BarReading& reading : row.bar.readings) values.push_back(of(reading));
    return report::spread_of(values);
}

Spread run_ms(const BarRow& row) {
    return spread_of(row, [](const BarReading& reading) { return reading.temporal_ms; });
}

Spread gather_ms(const BarRow& row) {
    return spread_of(row, [](const BarReading& reading) { return reading.temporal_gather_ms; });
}

Spread fast_ms(const BarRow& row) {
    return spread_of(row, [](const BarReading& reading) { return reading.fast_ms; });
}

ordered_json json_of(const effect::BarError& error) {
    return {{"raw", error.raw}, {"shown", error.shown}};
}

ordered_json json_of(const Spread& spread) {
    return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

ordered_json json_of(const BarRow& row) {
    const effect::Bar& bar = row.bar;
    return {{"scene", row.scene},
            {"rmse_geometry", json_of(bar.temporal)},
            {"rmse_geometry_exact", json_of(bar.exact)},
            {"rmse_geometry_fast", json_of(bar.fast)},
            {"error_ratio", row.error_ratio()},
            {"flicker", bar.flicker ? ordered_json(*bar.flicker) : ordered_json(nullptr)},
            {"ms", json_of(run_ms(row))},
            {"gather_ms", json_of(gather_ms(row))},
            {"fast_ms", json_of(fast_ms(row))},
            {"exact_ms", json_of(report::spread_of(bar.exact_ms))},
            {"time_ratio", json_of(row.time_ratio())},
            {"time_ratio_to_slices", json_of(row.time_ratio_to_slices())},
            {"readings", bar.readings.size()},
            {"met", row.met()}};
}

// The name of the temporal run: the preset and the changed settings.
std::string candidate_of(const BenchBarOptions& options) {
    std::string name = options.preset;
    if (!options.method.empty()) name += ", " + options.method;
    if (options.samples) name += fmt::format(", {} samples", *options.samples);
    for (const std::string& assignment : options.set) name += ", " + assignment;
    return name;
}

}  // namespace

double BarRow::error_ratio() const {
    return bar.temporal.shown / bar.exact.shown;
}

Spread BarRow::time_ratio() const {
    return spread_of(*this, [](const BarReading& reading) { return reading.temporal_ms / reading.fast_ms; });
}

Spread BarRow::time_ratio_to_slices() const {
    return spread_of(*this,
                     [](const BarReading& reading) { return reading.temporal_ms / reading.fast_slices_ms; });
}

bool BarRow::met() const {
    return error_ratio() <= 1.0 && time_ratio().median <= 1.0;
}

std::string to_text(const BarReport& report, const BenchBarOptions& options) {
    std::string text = fmt::format(
        "`{}` over the last frames of {}, and single frames of {} and {} plain slices x steps beside each.\n"
        "{} x {} pixels, {} rounds, the truth of {} rays a pixel.\n"
        "On {} ({}).\n\n",
        candidate_of(options), options.frames, options.exact, options.fast, report.extent.width,
        report.extent.height, options.rounds, options.rays, report.device.name, report.device.driver);
    text += fmt::format(
        "| scene | RMSE (G) | of {0} | ratio | flicker | ms | of it samples | of {0} | of {1} | ratio of "
        "times, quartiles | to {1} without its blur | |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n",
        options.exact, options.fast);
    for (const BarRow& row : report.rows) {
        const Spread ratio = row.time_ratio();
        text += fmt::format(
            "| {} | {:.4f} | {:.4f} | {:.2f} | {:.5f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} ({:.2f} "
            "to {:.2f}) | {:.2f} | {} |\n",
            row.scene, row.bar.temporal.shown, row.bar.exact.shown, row.error_ratio(),
            row.bar.flicker.value_or(0.0), run_ms(row).median, gather_ms(row).median,
            report::spread_of(row.bar.exact_ms).median, fast_ms(row).median, ratio.median, ratio.low,
            ratio.high, row.time_ratio_to_slices().median, row.met() ? "met" : "**not met**");
    }
    return text;
}

std::string to_json(const BarReport& report, const BenchBarOptions& options) {
    ordered_json document{{"versions", versions()},
                          {"device", report.device.name},
                          {"driver", report.device.driver},
                          {"width", report.extent.width},
                          {"height", report.extent.height},
                          {"frames", options.frames},
                          {"rounds", options.rounds},
                          {"rays", options.rays},
                          {"candidate", candidate_of(options)},
                          {"exact", options.exact},
                          {"fast", options.fast},
                          {"scenes", ordered_json::array()}};
    for (const BarRow& row : report.rows) document["scenes"].push_back(json_of(row));
    return document.dump(2) + "\n";
}

}  // namespace gloam::cli
