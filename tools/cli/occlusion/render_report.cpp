// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/version.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/settings.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;

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

ordered_json or_null(const std::string& text) {
    return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

// The use of the history: the share of the pixels with geometry that have one, and its samples, their mean.
ordered_json history_json(const effect::Frame& frame, const scene::GBuffer& view, const std::string& cut) {
    double surface = 0.0;
    double kept = 0.0;
    double samples = 0.0;
    for (std::size_t i = 0; i < frame.kept.size(); ++i) {
        if (!std::isfinite(view.depth[i])) continue;
        surface += 1.0;
        kept += frame.kept[i] > 0.0F ? 1.0 : 0.0;
        samples += double{frame.kept[i]};
    }
    return {{"cut", or_null(cut)},
            {"kept", kept / std::max(surface, 1.0)},
            {"samples", samples / std::max(kept, 1.0)}};
}

// Over the pixels with geometry.
double mean_convergence(const effect::Frame& frame, const scene::GBuffer& view) {
    double sum = 0.0;
    for (const float value : frame.convergence) sum += double{value};
    const auto surface = std::ranges::count_if(view.depth, [](float d) { return std::isfinite(d); });
    return surface == 0 ? 0.0 : sum / static_cast<double>(surface);
}

// standard_error: root mean square over the pixels.
ordered_json truth_json(const scene::TracedTruth& traced) {
    double squares = 0.0;
    for (const float error : traced.standard_error) squares += double{error} * double{error};
    return {{"rays", traced.rays},
            {"pixels", traced.pixels},
            {"unmatched", traced.unmatched},
            {"standard_error",
             std::sqrt(squares / static_cast<double>(std::max<std::uint64_t>(1, traced.pixels)))}};
}

// Adds "truth", where it was traced, and "errors". last: of its view, for which there are metrics as well.
void add_errors(ordered_json& report, const ShadedView& shown, const effect::Frame& frame,
                const FrameChange& change, bool last) {
    const effect::Errors raw = effect::errors_of(frame.occlusion, shown.truth);
    ordered_json errors{{"compared", raw.compared},
                        {"raw", errors_json(raw)},
                        {"filtered", errors_json(effect::errors_of(frame.filtered, shown.truth))}};
    if (shown.geometry || shown.depth) report["truth"] = truth_json(shown.best());
    if (shown.geometry && shown.depth) {
        const effect::Truth depth = effect::truth_from(shown.view, shown.depth->occlusion);
        report["truth"]["depth_against_geometry"] = errors_json(effect::errors_of(depth, shown.truth));
        errors["filtered_against_depth"] = errors_json(effect::errors_of(frame.filtered, depth));
    }
    if (last)
        errors["filtered_metrics"] =
            metrics_json(effect::metrics_of(frame.filtered, shown.truth, shown.view.extent));
    if (change.flicker) {
        const effect::ClassErrors by_class =
            effect::class_errors_of(frame.filtered, shown.truth, *change.classes);
        for (std::size_t i = 0; i < by_class.size(); ++i) {
            ordered_json& json = errors["filtered_by_class"][effect::pixel_class_names[i]];
            if (by_class[i].compared == 0) continue;  // null
            json["compared"] = by_class[i].compared;
            json.update(errors_json(by_class[i]));
        }
    }
    report["errors"] = std::move(errors);
}

double number_in(const ordered_json& json, const char* path) {
    return json.at(ordered_json::json_pointer(path)).get<double>();
}

std::string errors_line(const char* what, const ordered_json& errors) {
    return fmt::format("  {:<25} rmse {:.5f}, mean {:.5f}, 99 % below {:.5f}, max {:.5f}, bias {:+.5f}\n",
                       what, number_in(errors, "/rmse"), number_in(errors, "/mean"),
                       number_in(errors, "/percentile_99"), number_in(errors, "/max"),
                       number_in(errors, "/bias"));
}

std::string work_lines(const effect::Frame& frame, const ordered_json& report) {
    std::string text;
    for (const effect::PassTime& time : frame.times)
        text += fmt::format("{}{} {:.2f} ms", text.empty() ? "" : ", ", time.pass, time.ms);
    const auto percent = [&](const char* path) { return 100.0 * number_in(report, path); };
    text += fmt::format(
        "\ntiles: {:.1f} % background, {:.1f} % below a pixel, {:.1f} % at half size, {:.1f} % in full",
        percent("/tiles/background"), percent("/tiles/below_pixel"), percent("/tiles/half"),
        percent("/tiles/full"));
    if (frame.samples == 0.0) return text + "\n";
    return text + fmt::format("\n{:.1f} samples of a pixel, mean convergence {:.3f}\n", frame.samples,
                              number_in(report, "/convergence"));
}

}  // namespace

ordered_json frame_json(const RenderInput& input, const ShadedView& shown, int i, const effect::Frame& frame,
                        const FrameChange& change) {
    ordered_json times = ordered_json::object();
    for (const effect::PassTime& time : frame.times)
        times[time.pass] = std::isfinite(time.ms) ? ordered_json(time.ms) : ordered_json(nullptr);
    const effect::TileShares tiles = shares_of(frame.tiles);
    ordered_json report{{"frame", shown.number + i},
                        {"width", frame.extent.width},
                        {"height", frame.extent.height},
                        {"history", history_json(frame, shown.view, i == 0 ? shown.cut : "")},
                        {"radius", shown.settings.radius},
                        {"bias", shown.settings.bias},
                        {"times_ms", times},
                        {"tiles",
                         {{"background", tiles.background},
                          {"below_pixel", tiles.below_pixel},
                          {"half", tiles.half},
                          {"full", tiles.full}}},
                        {"samples", frame.samples},
                        {"convergence", mean_convergence(frame, shown.view)}};
    if (input.scene) report["scene_frame"] = input.first_frame + shown.number;
    if (change.flicker) report["flicker"] = *change.flicker;
    if (!shown.truth.empty()) add_errors(report, shown, frame, change, i + 1 == input.frames_per_view);
    return report;
}

ordered_json report_of(const RenderOptions& options, const RenderInput& input,
                       const RenderCandidate& candidate, const backend::DeviceInfo& device,
                       const Rendered& run, const ordered_json& frames) {
    const effect::Settings& s = run.settings;
    return {{"gloam", base::version()},
            {"device",
             {{"name", device.name},
              {"driver", device.driver},
              {"type", device.type},
              {"api_version", device.api_version}}},
            {"versions", versions()},
            {"source", input.name},
            {"method", s.method},
            {"preset", candidate.preset},
            {"radius", s.radius},
            {"falloff", effect::method_named(s.method).falloff},
            {"width", run.frame.extent.width},
            {"height", run.frame.extent.height},
            {"settings", json_of(s)},
            {"repeat", options.repeat},
            {"truth", or_null(input.truth_name)},
            {"frames", frames}};
}

std::string to_text(const Rendered& run) {
    const ordered_json& last = run.report.at("frames").back();
    const auto text_of = [&](const char* name) { return run.report.at(name).get<std::string>(); };
    const effect::Settings& s = run.settings;
    const std::size_t frames = run.report.at("frames").size();
    std::string text = fmt::format(
        "{}: {} ({}), {} samples a frame, radius {:g}, {} x {}, {} frame{} on {}\n", text_of("source"),
        s.method, text_of("preset"), s.samples, s.radius, run.frame.extent.width, run.frame.extent.height,
        frames, frames == 1 ? "" : "s", run.report.at("device").at("name").get<std::string>());
    text += (frames > 1 ? "last frame: " : "") + work_lines(run.frame, last);
    const bool study = s.passes == effect::Passes::study;
    if (study && frames > 1)
        text += fmt::format("history at {:.1f} % of the pixels, of {:.0f} samples\n",
                            100.0 * number_in(last, "/history/kept"), number_in(last, "/history/samples"));
    if (!last.contains("errors")) return text;
    const ordered_json& errors = last.at("errors");
    text += fmt::format("error against {}, {} pixels compared (rmse: root mean square error):\n",
                        text_of("truth"), errors.at("compared").get<std::size_t>());
    if (study) text += errors_line("before the filter", errors.at("raw"));
    if (!study || filters(s)) text += errors_line("after the filter", errors.at("filtered"));
    if (errors.contains("filtered_against_depth"))
        text += errors_line("against the depth buffer's", errors.at("filtered_against_depth"));
    const ordered_json& metrics = errors.at("filtered_metrics");
    text += fmt::format(
        "  SSIM (structural similarity, 1: the same) {:.4f}; best remap ({:.3f} (v {:+.3f}))^{:.3f}: "
        "rmse {:.5f}, SSIM {:.4f}\n",
        number_in(metrics, "/ssim"), number_in(metrics, "/remap/b"), number_in(metrics, "/remap/a"),
        number_in(metrics, "/remap/c"), number_in(metrics, "/remapped/rmse"),
        number_in(metrics, "/remapped_ssim"));
    if (last.contains("truth"))
        text += fmt::format("  truth: {} rays a pixel, standard error {:.5f}\n",
                            last.at("truth").at("rays").get<std::uint64_t>(),
                            number_in(last, "/truth/standard_error"));
    return text;
}

}  // namespace gloam::cli
