// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/occlusion/settings.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;

std::string falloff_of(const effect::Settings& settings) {
    return effect::method_named(settings.method).falloff;
}

ordered_json errors_json(const effect::Errors& errors) {
    return {{"rmse", errors.rmse},
            {"mean", errors.mean},
            {"percentile_99", errors.percentile_99},
            {"max", errors.max},
            {"bias", errors.bias}};
}

ordered_json metrics_json(const effect::Metrics& metrics) {
    return {{"ssim", metrics.similarity},
            {"remap", {{"a", metrics.remap.a}, {"b", metrics.remap.b}, {"c", metrics.remap.c}}},
            {"remapped", errors_json(metrics.after_remap)},
            {"remapped_ssim", metrics.similarity_after_remap}};
}

// null where a class has no pixels.
ordered_json class_json(const effect::Errors& errors) {
    if (errors.compared == 0) return nullptr;
    ordered_json json{{"compared", errors.compared}};
    json.update(errors_json(errors));
    return json;
}

ordered_json frame_errors_json(const FrameErrors& errors) {
    ordered_json json{{"compared", errors.raw.compared},
                      {"raw", errors_json(errors.raw)},
                      {"filtered", errors_json(errors.filtered)}};
    if (errors.filtered_depth) json["filtered_against_depth"] = errors_json(*errors.filtered_depth);
    if (errors.metrics) json["filtered_metrics"] = metrics_json(*errors.metrics);
    if (errors.by_class) {
        for (std::size_t i = 0; i < errors.by_class->size(); ++i)
            json["filtered_by_class"][effect::pixel_class_names[i]] = class_json((*errors.by_class)[i]);
    }
    return json;
}

ordered_json truth_json(const TruthReport& truth) {
    ordered_json json{{"rays", truth.rays},
                      {"pixels", truth.pixels},
                      {"unmatched", truth.unmatched},
                      {"standard_error", truth.standard_error}};
    if (truth.depth) json["depth_against_geometry"] = errors_json(*truth.depth);
    return json;
}

ordered_json times_json(const std::vector<effect::PassTime>& times) {
    ordered_json json = ordered_json::object();
    for (const effect::PassTime& time : times) {
        json[time.pass] = std::isfinite(time.ms) ? ordered_json(time.ms) : ordered_json(nullptr);
    }
    return json;
}

ordered_json history_json(const HistoryReport& history) {
    return {{"cut", history.cut.empty() ? ordered_json(nullptr) : ordered_json(history.cut)},
            {"kept", history.kept},
            {"samples", history.samples}};
}

ordered_json frame_json(const FrameReport& frame) {
    ordered_json json{{"frame", frame.number},
                      {"width", frame.extent.width},
                      {"height", frame.extent.height},
                      {"history", history_json(frame.history)},
                      {"radius", frame.settings.radius},
                      {"bias", frame.settings.bias},
                      {"times_ms", times_json(frame.times)},
                      {"tiles",
                       {{"background", frame.tiles.background},
                        {"below_pixel", frame.tiles.below_pixel},
                        {"half", frame.tiles.half},
                        {"full", frame.tiles.full}}},
                      {"samples", frame.samples},
                      {"convergence", frame.mean_convergence}};
    if (frame.scene_frame) json["scene_frame"] = *frame.scene_frame;
    if (frame.flicker) json["flicker"] = *frame.flicker;
    if (frame.truth) json["truth"] = truth_json(*frame.truth);
    if (frame.errors) json["errors"] = frame_errors_json(*frame.errors);
    return json;
}

std::string errors_line(const char* what, const effect::Errors& e) {
    return fmt::format("  {:<25} rmse {:.5f}, mean {:.5f}, 99 % below {:.5f}, max {:.5f}, bias {:+.5f}\n",
                       what, e.rmse, e.mean, e.percentile_99, e.max, e.bias);
}

std::string work_lines(const FrameReport& frame) {
    std::string text;
    for (const effect::PassTime& time : frame.times)
        text += fmt::format("{}{} {:.2f} ms", text.empty() ? "" : ", ", time.pass, time.ms);
    text += fmt::format(
        "\ntiles: {:.1f} % background, {:.1f} % below a pixel, {:.1f} % at half size, {:.1f} % in full",
        100.0 * frame.tiles.background, 100.0 * frame.tiles.below_pixel, 100.0 * frame.tiles.half,
        100.0 * frame.tiles.full);
    if (frame.samples == 0.0) return text + "\n";
    return text + fmt::format("\n{:.1f} samples of a pixel, mean convergence {:.3f}\n", frame.samples,
                              frame.mean_convergence);
}

}  // namespace

std::string to_json(const RenderReport& report) {
    const FrameReport& last = report.frames.back();
    ordered_json json{{"gloam", base::version()},
                      {"device",
                       {{"name", report.device.name},
                        {"driver", report.device.driver},
                        {"type", report.device.type},
                        {"api_version", report.device.api_version}}},
                      {"versions", versions()},
                      {"source", report.source},
                      {"method", last.settings.method},
                      {"preset", report.preset},
                      {"radius", last.settings.radius},
                      {"falloff", falloff_of(last.settings)},
                      {"width", last.extent.width},
                      {"height", last.extent.height},
                      {"settings", json_of(last.settings)},
                      {"repeat", report.repeat},
                      {"truth", report.truth.empty() ? ordered_json(nullptr) : ordered_json(report.truth)}};
    json["frames"] = ordered_json::array();
    for (const FrameReport& frame : report.frames) json["frames"].push_back(frame_json(frame));
    return json.dump(2) + "\n";
}

std::string to_text(const RenderReport& report) {
    const FrameReport& last = report.frames.back();
    const effect::Settings& s = last.settings;
    std::string text = fmt::format(
        "{}: {} ({}), {} samples a frame, radius {:g}, {} x {}, {} frame{} on {}\n", report.source, s.method,
        report.preset, s.samples, s.radius, last.extent.width, last.extent.height, report.frames.size(),
        report.frames.size() == 1 ? "" : "s", report.device.name);
    text += (report.frames.size() > 1 ? "last frame: " : "") + work_lines(last);
    const bool study = s.passes == effect::Passes::study;
    if (study && report.frames.size() > 1) {
        text += fmt::format("history at {:.1f} % of the pixels, of {:.0f} samples\n",
                            100.0 * last.history.kept, last.history.samples);
    }
    if (!last.errors) return text;
    text += fmt::format("error against {}, {} pixels compared (rmse: root mean square error):\n",
                        report.truth, last.errors->raw.compared);
    if (study) text += errors_line("before the filter", last.errors->raw);
    if (!study || filters(s)) text += errors_line("after the filter", last.errors->filtered);
    if (last.errors->filtered_depth)
        text += errors_line("against the depth buffer's", *last.errors->filtered_depth);
    if (last.errors->metrics) {
        const effect::Metrics& m = *last.errors->metrics;
        text += fmt::format(
            "  SSIM (structural similarity, 1: the same) {:.4f}; best remap ({:.3f} (v {:+.3f}))^{:.3f}: "
            "rmse {:.5f}, SSIM {:.4f}\n",
            m.similarity, m.remap.b, m.remap.a, m.remap.c, m.after_remap.rmse, m.similarity_after_remap);
    }
    if (last.truth) {
        text += fmt::format("  truth: {} rays a pixel, standard error {:.5f}\n", last.truth->rays,
                            last.truth->standard_error);
    }
    return text;
}

}  // namespace gloam::cli
