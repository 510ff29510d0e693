// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/settings.hpp"
#include "effect/study/tuning.hpp"
#include "experiment/runner.hpp"
#include "experiment/table.hpp"
#include "report/output.hpp"

namespace gloam::cli {
namespace {

using effect::SearchPoint;
using effect::TunedView;
using effect::TuneOutcome;
using effect::TuneTask;
using scene::ViewHalf;

// The options of `gloam tune`.
struct TuneOptions {
    std::string preset = "quality";       // where the search begins: a name or a file
    std::string method;                   // instead of the preset's
    std::vector<std::string> set;         // NAME=VALUE, fixed; lengths for a radius of 1
    std::vector<std::string> parameters;  // NAME=LEAST:MOST[:log]
    std::string objective = "mean";       // or "relative"
    int evaluations = 60;
    std::optional<double> copies;    // largest mean time of a frame
    bool sequence = false;           // frames in sequence, not alone
    std::vector<std::string> views;  // empty: all
    std::string size = "160x90";
    int frames = 16;
    int scored = 2;
    int rays = 128;
    std::filesystem::path meshes;
    std::string device;
    bool validation = false;
    std::filesystem::path out;     // the preset; empty: not written
    std::filesystem::path report;  // in Markdown; empty: not written
};

std::string parameters_text(const TuneOutcome& outcome, const TuneTask& task) {
    std::string text = "| parameter | from | to | start | tuned |\n|---|--:|--:|--:|--:|\n";
    for (std::size_t i = 0; i < task.parameters.size(); ++i) {
        const effect::SearchRange& range = task.parameters[i];
        text += fmt::format("| `{}` | {} | {} | {:.4g} | {:.4g} |\n", range.name, range.least, range.most,
                            outcome.search.points.front().at[i], outcome.search.best.at[i]);
    }
    return text;
}

std::string mean_row(const TuneOutcome& outcome, ViewHalf half) {
    double before = 0.0;
    double after = 0.0;
    int count = 0;
    for (const TunedView& tuned : outcome.views) {
        if (tuned.view.half != half) continue;
        before += tuned.before.rmse;
        after += tuned.after.rmse;
        ++count;
    }
    return fmt::format("| {} | {} | {:.4f} | {:.4f} | {:.3f} |\n", scene::name_of(half), count,
                       before / count, after / count, after / before);
}

std::string views_text(const TuneOutcome& outcome) {
    std::string text = "| view | kind | half | start | tuned | ratio |\n|---|---|---|--:|--:|--:|\n";
    for (const TunedView& tuned : outcome.views)
        text += fmt::format("| {} | {} | {} | {:.4f} | {:.4f} | {:.3f} |\n", tuned.view.name, tuned.view.kind,
                            scene::name_of(tuned.view.half), tuned.before.rmse, tuned.after.rmse,
                            tuned.after.rmse / tuned.before.rmse);
    return text;
}

// The points that were better than all before them.
std::string course_text(const TuneOutcome& outcome, const TuneTask& task) {
    std::string head = "| evaluation |";
    std::string rule = "|--:|";
    for (const effect::SearchRange& range : task.parameters) {
        head += fmt::format(" `{}` |", range.name);
        rule += "--:|";
    }
    std::string text = head + " objective |\n" + rule + "--:|\n";
    for (std::size_t i = 0; i < outcome.search.points.size(); ++i) {
        const SearchPoint& point = outcome.search.points[i];
        if (!point.improves) continue;
        text += fmt::format("| {} |", i + 1);
        for (const double value : point.at) text += fmt::format(" {:.4g} |", value);
        text += fmt::format(" {:.5f} |\n", point.value);
    }
    return text;
}

constexpr int timed_rounds = 3;  // of single frames

// The views with these names, in the order of the list; all without names.
std::vector<scene::ViewInfo> views_named(const std::vector<std::string>& names) {
    std::string known;
    for (const scene::ViewInfo& view : scene::all_views()) known += (known.empty() ? "" : ", ") + view.name;
    std::vector<scene::ViewInfo> views;
    for (const scene::ViewInfo& view : scene::all_views())
        if (names.empty() || std::ranges::count(names, view.name) > 0) views.push_back(view);
    for (const std::string& name : names)
        if (std::ranges::find(views, name, &scene::ViewInfo::name) == views.end())
            throw std::invalid_argument(fmt::format("--view {}: expected {}", name, known));
    return views;
}

effect::TuneTask task_of(const TuneOptions& options) {
    const RenderOptions start{.method = options.method, .preset = options.preset, .set = options.set};
    effect::TuneTask task{.start = settings_for(start, 1.0),
                          .objective = options.objective == "relative" ? effect::TuneObjective::relative
                                                                       : effect::TuneObjective::mean,
                          .evaluations = options.evaluations,
                          .copies = options.copies};
    for (const std::string& text : options.parameters)
        task.parameters.push_back(effect::tuned_parameter(text));
    if (task.parameters.empty())
        throw std::invalid_argument("nothing to tune: give --parameter NAME=LEAST:MOST");
    if (options.scored > options.frames)
        throw std::invalid_argument(
            fmt::format("--scored {}: expected at most {}, the frames", options.scored, options.frames));
    return task;
}

// Measures settings as the only candidate of an experiment on one view.
class MeasuredViews {
  public:
    MeasuredViews(const gpu::Device& device, const TuneOptions& options)
        : size_(judged_size(options.size)),
          passes_(glsl_directory(), cache_directory()),
          place_{.device = device,
                 .passes = passes_,
                 .truth_cache = truth_cache_directory(),
                 .meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes,
                 .preset_of = [this](const std::string&) { return tried_; },
                 .progress = [](const std::string& what) -> std::function<void(double)> {
                     if (what.ends_with("truth")) return progress_bar(what);
                     return [](double) {};
                 }},
          what_{.name = "tune",
                .frames = options.frames,
                .scored = options.scored,
                .rounds = options.copies && !options.sequence ? timed_rounds : 0,
                .rays = options.rays,
                .interleaved = true,
                .equal_readings = true,
                .cases = {{.view = true}},
                .candidates = {{.name = "tried", .layer = {.preset = "tried"}}}} {
        what_.layer.sequence = options.sequence;
    }

    // settings: lengths for a radius of 1.
    [[nodiscard]] effect::ViewMeasure measure(const scene::ViewInfo& view, const effect::Settings& settings) {
        tried_ = settings;
        what_.cases[0].name = what_.cases[0].scene = view.name;
        experiment::Record record({});
        run(what_, size_, place_, record, shared_);
        const auto results = results_of(what_, {size_}, record);
        const auto value = [&](const char* quantity) {
            return experiment::mean_value({&results[0].cases[0]}, 0, quantity, "median", {});
        };
        return {.rmse = value("rmse").value(), .copies = value("copies").value_or(0.0)};
    }

  private:
    gpu::Extent size_;
    scene::PassLibrary passes_;
    effect::Settings tried_;
    experiment::Place place_;
    experiment::Experiment what_;
    experiment::Shared shared_;
};

std::string description_of(const effect::TuneOutcome& outcome, const TuneOptions& options) {
    return fmt::format("{} tuned by {} evaluations on {} views at {}", options.preset,
                       outcome.search.points.size(), outcome.views.size(), options.size);
}

void add_search(CLI::App& command, TuneOptions& options) {
    command.add_option("--preset", options.preset, "where the search begins: a preset, or a file of one")
        ->capture_default_str();
    command.add_option("--method", options.method, "instead of the preset's");
    command.add_option("--set", options.set, "NAME=VALUE: a setting that stays, lengths for a radius of 1")
        ->allow_extra_args(false);
    command.add_option("--parameter", options.parameters, "NAME=LEAST:MOST, or NAME=LEAST:MOST:log")
        ->allow_extra_args(false);
    command
        .add_option(
            "--objective", options.objective,
            "what is to be least: the mean error, or the mean ratio to the start's error of each view")
        ->check(CLI::IsMember({"mean", "relative"}))
        ->capture_default_str();
    command.add_option("--evaluations", options.evaluations, "settings that are tried at most")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    command.add_option("--copies", options.copies, "largest time of a frame, in copies; without it any")
        ->check(CLI::PositiveNumber);
    command.add_flag("--sequence", options.sequence, "frames in sequence with their history, not alone");
    command.add_option("--view", options.views, "views of both halves; without it all (gloam list views)");
}

// What of the views is rendered and traced.
void add_views(CLI::App& command, TuneOptions& options) {
    command.add_option("--size", options.size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command.add_option("--frames", options.frames, "of each view")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--scored", options.scored, "the last ones of these")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--rays", options.rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    command.add_option("--meshes", options.meshes, "folder of the meshes; without it that of glmark2-data");
}

// What was tuned and what it gains, in Markdown: the parameters before and after, the means of both halves, a
// row for each view, the course of the search.
std::string to_text(const TuneOutcome& outcome, const TuneTask& task, const TuneOptions& options) {
    std::string text = fmt::format("# Tuning of {}\n\n", options.preset);
    text += fmt::format(
        "The search took {} evaluations (at most {}) on the tuning half of the views. The unseen half was "
        "measured\nafterwards, at the start and at the result. Errors are RMSE against the truth of the "
        "geometry, of frames {},\n{} pixels, the last {} of {} frames, {} rays a pixel. The objective is the "
        "{} error.\n\n",
        outcome.search.points.size(), task.evaluations, options.sequence ? "in sequence" : "alone",
        options.size, options.scored, options.frames, options.rays, options.objective);
    text += parameters_text(outcome, task) + "\n";
    text += "| half | views | mean at the start | tuned | ratio |\n|---|--:|--:|--:|--:|\n" +
            mean_row(outcome, ViewHalf::tuning) + mean_row(outcome, ViewHalf::unseen) + "\n";
    return text + "## Views\n\n" + views_text(outcome) +
           "\n## The search\n\nPoints that were better than all before.\n\n" + course_text(outcome, task);
}

int run_tune(const TuneOptions& options) {
    const std::vector<scene::ViewInfo> views = views_named(options.views);
    const effect::TuneTask task = task_of(options);
    const report::OutputFile out(options.out);
    const report::OutputFile report(options.report);
    gpu::Device device = open_device(options.device, options.validation);
    MeasuredViews measured(device, options);
    const effect::TuneOutcome outcome = effect::tune(
        task, views,
        [&](const scene::ViewInfo& view, const effect::Settings& settings) {
            return measured.measure(view, settings);
        },
        progress_bar("search"));
    const std::string text = to_text(outcome, task, options);
    fmt::print("{}", text);
    report.write(text);
    const std::string name = options.out.empty() ? "tuned" : options.out.stem().string();
    out.write(preset_json(name, description_of(outcome, options), outcome.settings));
    return validation_status(device);
}

}  // namespace

void add_tune(CLI::App& app, int& status) {
    auto options = std::make_shared<TuneOptions>();
    CLI::App* command = app.add_subcommand(
        "tune", "fit settings on one half of the views and judge them on the half that they have not seen");
    add_search(*command, *options);
    add_views(*command, *options);
    add_device_options(*command, options->device, options->validation);
    command->add_option("--out", options->out, "write the preset here, for --preset FILE.json");
    command->add_option("--report", options->report, "write the report here, in Markdown");
    command->callback([options, &status] { status = run_tune(*options); });
}

}  // namespace gloam::cli
