// SPDX-License-Identifier: MIT
#include "report/benchmark/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

// The index of the point with this value; nullopt if it was not measured.
std::optional<std::size_t> point_at(const Growth& growth, double value) {
    const auto found = std::ranges::find_if(
        growth.points, [&](const auto& point) { return std::abs(point.first - value) <= 1e-6 * value; });
    if (found == growth.points.end()) return std::nullopt;
    return static_cast<std::size_t>(found - growth.points.begin());
}

// Ratio of the time for `to` to that for `from`; nullopt if one was not measured.
std::optional<double> growth_between(const Growth& growth, double from, double to) {
    const auto first = point_at(growth, from);
    const auto last = point_at(growth, to);
    if (!first || !last) return std::nullopt;
    const double ratio = growth.points[*last].second / growth.points[*first].second;
    return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

bool any_open(const Growth& growth) {
    return std::ranges::any_of(growth.open, [](double part) { return part > 0.0; });
}

std::string criterion(const std::string& what, double measured, double allowed) {
    return fmt::format("| {} | {:.3f} | {:.2f} | {} |\n", what, measured, allowed,
                       measured <= allowed ? "met" : "**not met**");
}

// Judged only if every tile is known to be sampled; otherwise pixels are not the same work at both sizes.
std::string pixels_criterion_of(const Growth& growth) {
    constexpr double hd = 1280.0 * 720.0;
    constexpr double uhd = 3840.0 * 2160.0;
    const auto ratio = growth_between(growth, hd, uhd);
    if (!ratio) return {};
    const double per_pixel = *ratio * hd / uhd;
    const std::string what = growth.method + ": time per pixel, 3840 x 2160 over 1280 x 720";
    if (!growth.open.empty() && !any_open(growth)) return criterion(what, per_pixel, 1.15);
    const std::string open = growth.open.empty()
                                 ? "open tiles not counted"
                                 : fmt::format("{:.0f} % of the tiles left out as open over {:.0f} %",
                                               100.0 * growth.open[*point_at(growth, uhd)],
                                               100.0 * growth.open[*point_at(growth, hd)]);
    return fmt::format("| {}, {} | {:.3f} | - | not judged |\n", what, open, per_pixel);
}

std::string criterion_of(const Growth& growth) {
    if (growth.of.starts_with("pixels")) return pixels_criterion_of(growth);
    if (growth.of != "radius in pixels" || growth.points.empty()) return {};
    const double widest = growth.points.back().first;
    if (const auto ratio = growth_between(growth, 0.1 * widest, widest))
        return criterion(growth.method + ": time, ten times the radius", *ratio, 1.5);
    return {};
}

std::string points_of(const Growth& growth) {
    std::string points;
    for (std::size_t i = 0; i < growth.points.size(); ++i) {
        const auto& [value, ms] = growth.points[i];
        points += fmt::format("{}{:.4g}: {}", points.empty() ? "" : ", ", value, number(ms, 3));
        if (any_open(growth)) points += fmt::format(" ({:.0f} % open)", 100.0 * growth.open[i]);
    }
    return points;
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

std::string scaling_table(const Benchmark& benchmark) {
    if (benchmark.scaling.empty()) return {};
    std::string text = "| time against | method | exponent | value: ms |\n| --- | --- | --- | --- |\n";
    for (const Growth& growth : benchmark.scaling) {
        text += fmt::format("| {} | {} | {} | {} |\n", growth.of, growth.method, number(growth.exponent, 3),
                            points_of(growth));
    }
    return text;
}

std::string scaling_criteria_table(const Benchmark& benchmark) {
    std::string text;
    for (const Growth& growth : benchmark.scaling) text += criterion_of(growth);
    return text.empty() ? text : "| criterion | measured | allowed | |\n| --- | --- | --- | --- |\n" + text;
}

std::string framework_table(const Benchmark& benchmark) {
    if (benchmark.framework.empty()) return {};
    std::string text = "| figure | value |\n| --- | --- |\n";
    for (const Figure& figure : benchmark.framework)
        text += fmt::format("| {} | {:.4g} {} |\n", figure.name, figure.value, figure.unit);
    return text;
}

}  // namespace gloam::report
