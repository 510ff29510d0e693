// SPDX-License-Identifier: MIT
#include "cli/tune_report.hpp"

#include <fmt/format.h>

namespace gloam::cli {
namespace {

using effect::SearchPoint;
using effect::TunedView;
using effect::TuneOutcome;
using effect::TuneTask;
using scene::ViewHalf;

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

}  // namespace

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

}  // namespace gloam::cli
