// SPDX-License-Identifier: MIT
#include "cli/bench/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/names.hpp"
#include "effect/study/own_value.hpp"

namespace gloam::cli {
namespace {

using namespace effect;
using nlohmann::json;

// A header line and the line under it.
std::string header(const std::vector<std::string>& titles) {
    std::string text = "|";
    std::string rule = "|";
    for (const std::string& title : titles) {
        text += " " + title + " |";
        rule += " --- |";
    }
    return text + "\n" + rule + "\n";
}

// Whether the row is that of a method, not of a preset.
bool is_default(const MethodRow& row) {
    return row.configuration.name == row.configuration.settings.method;
}

// Whether the row differs from its method's default in more than the number of samples.
bool has_views_of_its_own(const MethodRow& row) {
    const Settings& settings = row.configuration.settings;
    return is_default(row) || !same_estimate(settings, with_method(Settings{}, settings.method));
}

std::string estimates_table(const MethodsReport& report) {
    std::string text = header({"method", "samples", "how", "measure", "falloff"});
    for (const MethodRow& row : report.rows) {
        if (!is_default(row)) continue;
        const MethodInfo& method = method_named(row.configuration.name);
        text += fmt::format("| {} | {} | {} | {} | {} |\n", method.name, row.configuration.settings.samples,
                            method.description, to_string(method.measure), method.falloff);
    }
    return text;
}

// A method has nearly the same value on all bare planes, so these share one column.
bool is_plane(const ViewResult& view) {
    return view.view.starts_with("plane");
}

// The views, which are the same in all rows.
std::vector<ViewResult> views_of(const MethodsReport& report) {
    return report.rows.empty() ? std::vector<ViewResult>{} : report.rows.front().views;
}

std::vector<std::string> view_titles(const MethodsReport& report, const std::string& last) {
    std::vector<std::string> titles{"configuration", "planes"};
    for (const ViewResult& view : views_of(report))
        if (!is_plane(view)) titles.push_back(view.view);
    titles.push_back(last);
    return titles;
}

std::string truth_row(const MethodsReport& report) {
    std::string text = "| *truth* | *0* |";
    for (const ViewResult& view : views_of(report))
        if (!is_plane(view)) text += fmt::format(" *{:.3f}* |", view.truth);
    return text + " |\n";
}

// The value furthest from 0 on the planes.
double widest_plane(const MethodRow& row, double ViewResult::* value) {
    double widest = 0.0;
    for (const ViewResult& view : row.views)
        if (is_plane(view) && std::abs(view.*value) > std::abs(widest)) widest = view.*value;
    return widest;
}

std::string views_table(const MethodsReport& report) {
    std::string text = header(view_titles(report, "furthest from its own")) + truth_row(report);
    for (const MethodRow& row : report.rows) {
        if (!has_views_of_its_own(row)) continue;
        double plane = 0.0;
        double furthest = 0.0;
        std::string cells;
        for (const ViewResult& view : row.views) {
            if (view.own) furthest = std::max(furthest, std::abs(view.measured.value - view.own->value));
            if (is_plane(view)) {
                plane = std::max(plane, view.measured.value);
            } else if (view.own) {
                cells += fmt::format(" {:.3f} ({:.3f}) |", view.measured.value, view.own->value);
            } else {
                cells += fmt::format(" {:.3f} |", view.measured.value);
            }
        }
        const bool known = !row.views.empty() && row.views.front().own;
        text += fmt::format("| {} | {:.3f} |{} {} |\n", row.configuration.name, plane, cells,
                            known ? fmt::format("{:.3f}", furthest) : "not known");
    }
    return text;
}

std::string bias_table(const MethodsReport& report) {
    std::string text = header(view_titles(report, "furthest off"));
    for (const MethodRow& row : report.rows) {
        if (!has_views_of_its_own(row)) continue;
        const ViewResult* worst = nullptr;
        std::string cells;
        for (const ViewResult& view : row.views) {
            const double bias = view.shown - view.truth;
            if (!worst || std::abs(bias) > std::abs(worst->shown - worst->truth)) worst = &view;
            if (!is_plane(view)) cells += fmt::format(" {:+.3f} |", bias);
        }
        text += fmt::format(
            "| {} | {:+.3f} |{} {} |\n", row.configuration.name, widest_plane(row, &ViewResult::shown), cells,
            worst ? fmt::format("{}: {:+.3f}", worst->view, worst->shown - worst->truth) : "");
    }
    return text;
}

std::string scenes_table(const MethodsReport& report) {
    std::vector<std::string> titles{"configuration"};
    for (const std::string& scene : report.scenes) {
        for (const char* what : {"", ", remapped", ", own measure", ", one frame"})
            titles.push_back(scene + what);
    }
    titles.insert(titles.end(), {"samples", "gather, ms", "frame, ms"});
    std::string text = header(titles) + "| *truth of the depth buffer* |";
    for (const Metrics& depth : report.depth)
        text += fmt::format(" *{:.3f}* | *{:.3f}* | - | - |", depth.raw.rmse, depth.after_remap.rmse);
    text += " - | - | - |\n";
    for (const MethodRow& row : report.rows) {
        text += fmt::format("| {} |", row.configuration.name);
        double gather = 0.0;
        double frame = 0.0;
        for (const SceneResult& scene : row.scenes) {
            text += fmt::format(" {:.3f} | {:.3f} | {} | {:.3f} |", scene.geometry.raw.rmse,
                                scene.geometry.after_remap.rmse,
                                scene.own ? fmt::format("{:.3f}", scene.own->rmse) : "-", scene.frame.rmse);
            gather += scene.gather_ms / static_cast<double>(row.scenes.size());
            frame += scene.frame_ms / static_cast<double>(row.scenes.size());
        }
        text += fmt::format(" {} | {:.1f} | {:.1f} |\n", row.configuration.settings.samples, gather, frame);
    }
    return text;
}

std::string pictures_table(const MethodsReport& report) {
    std::vector<std::string> titles{""};
    titles.insert(titles.end(), report.scenes.begin(), report.scenes.end());
    std::string text = header(titles);
    const auto row_of = [&](const std::string& title, const std::string& what) {
        text += fmt::format("| {} |", title);
        for (const std::string& scene : report.scenes)
            text += fmt::format(" ![{}: {}](images/methods/{}) |", scene, title, picture_name(scene, what));
        text += "\n";
    };
    row_of("truth of the geometry", "truth");
    row_of("truth of the depth buffer", "depth");
    for (const MethodRow& row : report.rows)
        if (is_default(row)) row_of(row.configuration.name, row.configuration.name);
    return text;
}

json estimate_json(const Estimate& estimate) {
    return {{"value", estimate.value}, {"standard_error", estimate.error}};
}

json view_json(const ViewResult& view) {
    json own = nullptr;
    if (view.own) own = estimate_json(*view.own);
    return {{"view", view.view},
            {"truth", view.truth},
            {"measured", estimate_json(view.measured)},
            {"own", own},
            {"shown", view.shown}};
}

json errors_json(const Errors& errors) {
    return {{"rmse", errors.rmse}, {"bias", errors.bias}, {"percentile_99", errors.percentile_99}};
}

json scene_json(const std::string& name, const SceneResult& scene) {
    json own = nullptr;
    if (scene.own) own = errors_json(*scene.own);
    return {{"scene", name},
            {"limit",
             {{"geometry", errors_json(scene.geometry.raw)},
              {"geometry_after_remap", errors_json(scene.geometry.after_remap)},
              {"similarity", scene.geometry.similarity},
              {"depth", errors_json(scene.depth)},
              {"own", own}}},
            {"frame", {{"geometry", errors_json(scene.frame)}}},
            {"samples", scene.samples},
            {"gather_ms", scene.gather_ms},
            {"frame_ms", scene.frame_ms}};
}

}  // namespace

std::string picture_name(const std::string& scene, const std::string& what) {
    return scene + "-" + what + ".png";
}

std::vector<PageBlock> to_blocks(const MethodsReport& report) {
    return {{"estimates", estimates_table(report)},
            {"views", views_table(report)},
            {"bias", bias_table(report)},
            {"scenes", scenes_table(report)},
            {"pictures", pictures_table(report)}};
}

std::string to_json(const MethodsReport& report) {
    json rows = json::array();
    for (const MethodRow& row : report.rows) {
        json views = json::array();
        for (const ViewResult& view : row.views) views.push_back(view_json(view));
        json scenes = json::array();
        for (std::size_t i = 0; i < row.scenes.size(); ++i)
            scenes.push_back(scene_json(report.scenes[i], row.scenes[i]));
        rows.push_back({{"name", row.configuration.name},
                        {"method", row.configuration.settings.method},
                        {"samples", row.configuration.settings.samples},
                        {"views", views},
                        {"scenes", scenes}});
    }
    json depth = json::object();
    for (std::size_t i = 0; i < report.depth.size(); ++i)
        depth[report.scenes[i]] = errors_json(report.depth[i].raw);
    return json{{"versions", versions()},          {"device", report.device.name},
                {"depth_against_geometry", depth}, {"width", report.extent.width},
                {"height", report.extent.height},  {"view_pixels", report.pixels},
                {"configurations", rows}}
               .dump(2) +
           "\n";
}

}  // namespace gloam::cli
