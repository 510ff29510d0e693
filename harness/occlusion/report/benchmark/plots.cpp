// SPDX-License-Identifier: MIT
#include "report/benchmark/plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "report/benchmark/pareto.hpp"

namespace gloam::report {
namespace {

// A point of a plot, and its family, which determines its colour: a method or a preset, single or temporal.
struct Entry {
    Configuration choice;
    double copies = 0.0;
    double error = 0.0;
};

std::string family_of(const Configuration& choice) {
    return fmt::format("{}{}", choice.preset.empty() ? choice.method : choice.preset,
                       choice.temporal ? ", temporal" : "");
}

std::string time_axis(const Benchmark& benchmark, const char* more) {
    return fmt::format("time of all passes, in copies of an image ({:.3g} ms each){}",
                       benchmark.copy_ms.median, more);
}

// Presets that are not on the front, with their names.
Curve presets_of(const std::vector<Entry>& entries, const std::vector<std::size_t>& front) {
    Curve curve{.name = "presets behind it", .style = CurveStyle::points};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        if (entry.choice.preset.empty() || std::ranges::find(front, i) != front.end()) continue;
        curve.points.emplace_back(entry.copies, entry.error);
        curve.labels.push_back(entry.choice.preset + (entry.choice.temporal ? "" : ", single"));
    }
    return curve;
}

std::vector<Curve> curves_of(const std::vector<Entry>& entries) {
    std::vector<std::pair<double, double>> points;
    for (const Entry& entry : entries) points.emplace_back(entry.copies, entry.error);
    Curve front{.name = "Pareto front", .style = CurveStyle::steps};
    std::vector<std::string> families;
    const std::vector<std::size_t> on_front = pareto_front(points);
    for (const std::size_t i : on_front) {
        front.points.push_back(points[i]);
        front.labels.push_back(choice_of(entries[i].choice));
        const std::string family = family_of(entries[i].choice);
        if (std::ranges::find(families, family) == families.end()) families.push_back(family);
    }
    std::vector<Curve> curves{{.name = "others", .style = CurveStyle::background}};
    for (const std::string& family : families) curves.push_back({.name = family});
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto found = std::ranges::find(families, family_of(entries[i].choice));
        const auto at = found == families.end() ? 0 : found - families.begin() + 1;
        curves[static_cast<std::size_t>(at)].points.push_back(points[i]);
    }
    if (curves.front().points.empty()) curves.erase(curves.begin());
    curves.push_back(presets_of(entries, on_front));
    if (curves.back().points.empty()) curves.pop_back();
    curves.push_back(std::move(front));
    return curves;
}

}  // namespace

Plot error_against_time(const Benchmark& benchmark, const std::string& scene) {
    std::vector<Entry> entries;
    for (const Row& row : benchmark.rows) {
        if (row.configuration.scene == scene)
            entries.push_back({row.configuration, row.total_copies.median, row.quality.geometry});
    }
    return {
        .title = fmt::format("{}, {} x {}, {}", scene, benchmark.width, benchmark.height, benchmark.device),
        .x = time_axis(benchmark, ""),
        .y = "RMSE of the occlusion, against (G)",
        .logarithmic = true,
        .curves = curves_of(entries)};
}

Plot error_against_time(const Benchmark& benchmark) {
    std::vector<Entry> entries;
    for (const Overall& choice : overall_of(benchmark))
        entries.push_back({choice.choice, choice.copies, choice.error_ratio});
    return {
        .title = fmt::format("all scenes, {} x {}, {}", benchmark.width, benchmark.height, benchmark.device),
        .x = time_axis(benchmark, ", geometric mean"),
        .y = "RMSE over the scene's best, geometric mean",
        .logarithmic = true,
        .curves = curves_of(entries)};
}

std::vector<std::pair<std::string, Plot>> plots_of(const Benchmark& benchmark) {
    std::vector<std::pair<std::string, Plot>> plots;
    for (const std::string& scene : scenes_of(benchmark))
        plots.emplace_back(base::file_name_of(scene), error_against_time(benchmark, scene));
    if (!overall_of(benchmark).empty()) plots.emplace_back("overall", error_against_time(benchmark));
    return plots;
}

}  // namespace gloam::report
