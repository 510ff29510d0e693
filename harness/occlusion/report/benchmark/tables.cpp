// SPDX-License-Identifier: MIT
#include "report/benchmark/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/benchmark/pareto.hpp"

namespace gloam::report {
namespace {

constexpr const char* row_titles =
    "| configuration | copies | ms | gather: copies | ms | samples taken | RMSE (G) | (D) | raw (G) | (D) | "
    "SSIM | "
    "flicker | MiB |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

std::string number(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string line_of(const Row& row, bool bold) {
    const Quality& q = row.quality;
    const char* mark = bold ? "**" : "";
    return fmt::format("| {}{}{} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.1f} |\n", mark,
                       choice_of(row.configuration), mark, number(row.total_copies.median, 1),
                       number(row.total_ms.median, 3), number(row.gather_copies.median, 1),
                       number(row.gather_ms.median, 3), number(q.samples, 1), number(q.geometry, 4),
                       number(q.depth, 4), number(q.raw_geometry, 4), number(q.raw_depth, 4),
                       number(q.similarity, 3), number(q.flicker, 5),
                       static_cast<double>(q.memory_bytes) / (1024.0 * 1024.0));
}

// The row with the least error of each method or preset, single and temporal.
std::vector<const Row*> best_of(const Benchmark& benchmark, const std::string& scene) {
    std::vector<const Row*> best;
    for (const Row& row : benchmark.rows) {
        if (row.configuration.scene != scene) continue;
        Configuration family = row.configuration;
        family.samples = 0;
        const auto found = std::ranges::find(best, family, [](const Row* other) {
            Configuration its = other->configuration;
            its.samples = 0;
            return its;
        });
        if (found == best.end()) {
            best.push_back(&row);
        } else if (row.quality.geometry < (*found)->quality.geometry) {
            *found = &row;
        }
    }
    return best;
}

std::string overall_cells(const Overall& choice) {
    return fmt::format("{} | {} | {} | {} | {} | {} |", choice_of(choice.choice), number(choice.copies, 1),
                       number(choice.ms, 3), number(choice.error_ratio, 2), number(choice.mean_error, 4),
                       number(choice.worst_error, 4));
}

// The place of a choice: on the front, or behind the most exact point of it that is no slower.
std::string place_of(const Overall& choice, const std::vector<Overall>& front) {
    const Overall* ahead = nullptr;
    for (const Overall& point : front) {
        if (point.choice == choice.choice) return "on the front";
        if (point.copies <= choice.copies) ahead = &point;
    }
    return ahead == nullptr ? "" : "behind " + choice_of(ahead->choice);
}

}  // namespace

std::string scene_front_table(const Benchmark& benchmark, const std::string& scene) {
    std::string text = row_titles;
    for (const Row* row : front_of(benchmark, scene)) text += line_of(*row, false);
    return text;
}

std::string best_table(const Benchmark& benchmark, const std::string& scene) {
    const std::vector<const Row*> front = front_of(benchmark, scene);
    std::string text = row_titles;
    for (const Row* row : best_of(benchmark, scene))
        text += line_of(*row, std::ranges::find(front, row) != front.end());
    return text;
}

std::string overall_table(const Benchmark& benchmark) {
    std::string text =
        "| configuration | copies | ms | error over the scene's best | mean RMSE (G) | largest |\n"
        "| --- | --- | --- | --- | --- | --- |\n";
    for (const Overall& choice : front_of(overall_of(benchmark))) text += "| " + overall_cells(choice) + "\n";
    return text;
}

std::string presets_table(const Benchmark& benchmark) {
    const std::vector<Overall> all = overall_of(benchmark);
    const std::vector<Overall> front = front_of(all);
    std::string text;
    for (const Overall& choice : all) {
        if (choice.choice.preset.empty()) continue;
        text += fmt::format("| {} {} |\n", overall_cells(choice), place_of(choice, front));
    }
    if (text.empty()) return {};
    return "| preset | copies | ms | error over the scene's best | mean RMSE (G) | largest | |\n"
           "| --- | --- | --- | --- | --- | --- | --- |\n" +
           text;
}

std::string framework_table(const Benchmark& benchmark) {
    if (benchmark.framework.empty()) return {};
    std::string text = "| figure | value |\n| --- | --- |\n";
    for (const Figure& figure : benchmark.framework)
        text += fmt::format("| {} | {:.4g} {} |\n", figure.name, figure.value, figure.unit);
    return text;
}

}  // namespace gloam::report
