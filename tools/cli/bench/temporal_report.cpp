// SPDX-License-Identifier: MIT
#include "cli/bench/temporal.hpp"
#include "cli/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace gloam::cli {
namespace {

using namespace effect;
using nlohmann::json;

constexpr std::array<PixelClass, pixel_classes> all_classes{PixelClass::all, PixelClass::settled,
                                                            PixelClass::young, PixelClass::disoccluded,
                                                            PixelClass::near_moving};
constexpr std::array<Against, references> all_references{Against::limit, Against::depth, Against::geometry};

// Number of first frames, with short histories, that the tables skip.
std::size_t warm(const MotionStudy& study) {
    return study.frames.size() / 4;
}

std::string number(double value, int digits = 4) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

const MotionRun* run_named(const MotionStudy& study, const std::string& name) {
    const auto found =
        std::ranges::find(study.runs, name, [](const MotionRun& run) { return run.variant.name; });
    return found == study.runs.end() ? nullptr : &*found;
}

void add_motion_criteria(std::vector<Criterion>& list, const std::string& name, const MotionRun& run,
                         const MotionStudy& study) {
    const Score score = total(run.scores, warm(study));
    const Score single = total(study.single, warm(study));
    const Score still = total(study.still, warm(study));
    for (const Against a : all_references) {
        const std::string against = fmt::format("{}, against the {}", name, name_of(a));
        list.push_back(
            {against + ": settled, times the still error",
             score.rmse_filtered(a, PixelClass::settled) / still.rmse_filtered(a, PixelClass::settled), 1.3});
        list.push_back({against + ": disoccluded, filtered, times a single frame filtered",
                        score.rmse_filtered(a, PixelClass::disoccluded) /
                            single.rmse_filtered(a, PixelClass::disoccluded),
                        1.0});
        list.push_back(
            {against + ": near moving objects, times a single frame",
             score.rmse_raw(a, PixelClass::near_moving) / single.rmse_raw(a, PixelClass::near_moving), 1.2});
    }
}

std::string criteria_table(const TemporalReport& report) {
    std::string text = "| criterion | measured | allowed | |\n| --- | --- | --- | --- |\n";
    for (const Criterion& c : criteria_of(report)) {
        if (std::isnan(c.measured)) continue;
        text += fmt::format("| {} | {} | {} | {} |\n", c.what, number(c.measured), number(c.allowed, 2),
                            c.measured <= c.allowed ? "met" : "**not met**");
    }
    return text;
}

std::string convergence_table(const TemporalReport& report) {
    std::string text =
        "| frame | samples | raw, against the limit | filtered | bias | filtered, against (D) | (G) |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (std::size_t f = 1; f <= report.still.size(); f *= 2) {
        const StillFrame& frame = report.still[f - 1];
        text += fmt::format("| {} | {:.0f} | {} | {} | {:+.5f} | {} | {} |\n", f, frame.samples,
                            number(frame.raw[0]), number(frame.filtered[0]), frame.bias,
                            number(frame.filtered[1]), number(frame.filtered[2]));
    }
    return text;
}

std::string row(const std::string& name, const std::string& instead, const Score& score,
                const std::string& rest) {
    std::string text = fmt::format("| {} | {} |", name, instead);
    for (const PixelClass c : all_classes) {
        text += fmt::format(" {} / {} |", number(score.rmse_filtered(Against::limit, c)),
                            number(score.rmse_filtered(Against::geometry, c)));
    }
    return text + rest + "\n";
}

std::string ablation_table(const TemporalReport& report) {
    const MotionStudy& study = report.motion;
    std::string text = "| switched off | instead |";
    for (const PixelClass c : all_classes) text += fmt::format(" {} |", name_of(c));
    text +=
        " flicker: all | settled | time |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const MotionRun& run : study.runs) {
        text += row(run.variant.name, run.variant.instead, total(run.scores, warm(study)),
                    fmt::format(" {} | {} | {} |", number(run.flicker[0], 5), number(run.flicker[1], 5),
                                number(time_ratio(run, study.runs.front()), 2)));
    }
    text +=
        row("everything", "a single frame of k1 samples", total(study.single, warm(study)), " - | - | - |");
    text += row("motion", "as many frames of the same view", total(study.still, warm(study)), " - | - | - |");
    return text;
}

json table_json(const Score::Table& table) {
    json result = json::object();
    for (std::size_t r = 0; r < references; ++r) {
        for (std::size_t c = 0; c < pixel_classes; ++c) {
            if (table[r][c].count == 0) continue;
            result[name_of(all_references[r])][name_of(all_classes[c])] = {{"rmse", table[r][c].rmse()},
                                                                           {"pixels", table[r][c].count}};
        }
    }
    return result;
}

json scores_json(const std::vector<Score>& scores) {
    json result = json::array();
    for (const Score& score : scores)
        result.push_back({{"raw", table_json(score.raw)}, {"filtered", table_json(score.filtered)}});
    return result;
}

json run_json(const MotionRun& run, const MotionStudy& study) {
    json flicker = json::object();
    for (std::size_t c = 0; c < pixel_classes; ++c) flicker[name_of(all_classes[c])] = run.flicker[c];
    return {{"off", run.variant.name},
            {"instead", run.variant.instead},
            {"time_ratio", time_ratio(run, study.runs.front())},
            {"flicker", flicker},
            {"frames", scores_json(run.scores)}};
}

json still_json(const std::vector<StillFrame>& frames) {
    json result = json::array();
    for (const StillFrame& frame : frames) {
        json entry{{"samples", frame.samples}, {"bias", frame.bias}};
        for (std::size_t r = 0; r < references; ++r) {
            entry["raw"][name_of(all_references[r])] = frame.raw[r];
            entry["filtered"][name_of(all_references[r])] = frame.filtered[r];
        }
        result.push_back(entry);
    }
    return result;
}

}  // namespace

std::vector<Criterion> criteria_of(const TemporalReport& report) {
    std::vector<Criterion> list;
    const StillFrame& last = report.still.back();
    const std::size_t at = std::min<std::size_t>(32, report.still.size()) - 1;
    list.push_back({"still: slope of the mean square error over the samples",
                    convergence_slope(report.still, report.weight_max), -1.0});
    list.push_back(
        {fmt::format("still: RMSE at frame {}, against the limit", at + 1), report.still[at].raw[0], 0.01});
    if (report.still.size() > at + 1) {
        list.push_back(
            {fmt::format("still: RMSE at frame {}, times that of frame {}", report.still.size(), at + 1),
             last.raw[0] / report.still[at].raw[0], 1.1});
    }
    for (const char* name : {"full", "preset moving"}) {
        if (const MotionRun* run = run_named(report.motion, name))
            add_motion_criteria(list, name, *run, report.motion);
    }
    return list;
}

std::string to_markdown(const TemporalReport& report) {
    return fmt::format("Scene `{}`, preset `{}`, {} x {} pixels, {} frames, on {}.\n\n{}\n{}\n{}",
                       report.scene, report.preset, report.extent.width, report.extent.height,
                       report.motion.runs.front().times_ms.size(), report.device.name, criteria_table(report),
                       convergence_table(report), ablation_table(report));
}

std::string to_json(const std::vector<TemporalReport>& reports) {
    json scenes = json::array();
    for (const TemporalReport& report : reports) {
        json runs = json::array();
        for (const MotionRun& run : report.motion.runs) runs.push_back(run_json(run, report.motion));
        json criteria = json::array();
        for (const Criterion& c : criteria_of(report))
            criteria.push_back({{"what", c.what}, {"measured", c.measured}, {"allowed", c.allowed}});
        scenes.push_back({{"scene", report.scene},
                          {"preset", report.preset},
                          {"width", report.extent.width},
                          {"height", report.extent.height},
                          {"criteria", criteria},
                          {"slope", convergence_slope(report.still, report.weight_max)},
                          {"still", still_json(report.still)},
                          {"scored_frames", report.motion.frames},
                          {"runs", runs},
                          {"single", scores_json(report.motion.single)},
                          {"same_view", scores_json(report.motion.still)}});
    }
    const std::string device = reports.empty() ? "" : reports.front().device.name;
    return json{{"versions", versions()}, {"device", device}, {"scenes", scenes}}.dump(2) + "\n";
}

}  // namespace gloam::cli
