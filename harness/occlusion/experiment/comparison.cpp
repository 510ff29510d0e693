// SPDX-License-Identifier: MIT
#include "experiment/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace gloam::experiment {
namespace {

constexpr double noticed = 1e-4;  // RMSE: as many digits as are printed

std::string line_of(const std::string& question, const Choice& choice) {
    return fmt::format("{}: {}, at most {:.3f} ms, RMSE (G) {:.4f} in the mean, at most {:.4f}\n", question,
                       choice.name, choice.worst_ms, choice.mean_error, choice.worst_error);
}

void add_answer(Answers& answers, const std::string& question, const std::optional<Choice>& best,
                const std::vector<Choice>& choices, double Choice::* nearest) {
    answers.text += "\n";
    if (best) {
        answers.text += line_of(question, *best);
        return;
    }
    answers.all = false;
    answers.text += fmt::format("{}: no configuration\n", question);
    const auto found = std::ranges::min_element(choices, {}, nearest);
    if (found != choices.end()) answers.text += line_of("  the nearest", *found);
}

// What is compared of a candidate in a case.
struct Compared {
    std::string name;
    numeric::Spread time;
    double error = 0.0;
};

std::vector<Compared> compared_of(const Record& record) {
    Experiment all;
    const std::vector<gpu::Extent> sizes = choose_recorded(all, record);
    const std::vector<SizeResult> results = results_of(all, sizes, record);
    std::vector<Compared> measured;
    for (std::size_t size = 0; size < results.size(); ++size) {
        for (const CaseResult& one : results[size].cases) {
            for (std::size_t i = 0; i < one.cells.size(); ++i) {
                const std::optional<Cell>& cell = one.cells[i];
                if (!cell) continue;
                std::string name = size == 0 ? "" : fmt::format("size {}/", size + 1);
                name += one.shown.name + (one.shown.what.empty() ? "" : ", " + one.shown.what) + "/";
                measured.push_back(
                    {.name = name + all.candidates[i].name,
                     .time = numeric::spread_of(times_of(*cell, {})),
                     .error = mean_value({&one}, i, "rmse", "median", {}).value_or(std::nan(""))});
            }
        }
    }
    return measured;
}

Change change_of(const Compared& before, const Compared& after) {
    const numeric::Spread& old_time = before.time;
    const numeric::Spread& new_time = after.time;
    const double risen = after.error - before.error;
    return {.name = after.name,
            .time = {new_time.median / old_time.median, new_time.low / old_time.high,
                     new_time.high / old_time.low},
            .error = risen == 0.0 ? 1.0 : after.error / before.error,
            .slower = new_time.low > old_time.high,
            .faster = new_time.high < old_time.low,
            .worse = risen >= noticed,
            .better = risen <= -noticed};
}

double geometric_mean(const std::vector<Change>& changes, double (*of)(const Change&)) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Change& change : changes) {
        const double value = std::log(of(change));
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    return count == 0 ? 1.0 : std::exp(sum / static_cast<double>(count));
}

std::string sizes_text(const Record& record) {
    std::vector<std::string> sizes;
    for (const Visit& visit : record.visits()) {
        std::string size = size_text(visit.size);
        if (std::ranges::count(sizes, size) == 0) sizes.push_back(std::move(size));
    }
    return fmt::format("{}", fmt::join(sizes, ", "));
}

std::vector<std::string> warnings_of(const Record& before, const Record& after) {
    const Conditions& old = before.conditions();
    const Conditions& now = after.conditions();
    std::vector<std::string> warnings;
    const auto warn = [&](const char* what, const std::string& first, const std::string& second) {
        if (first != second) warnings.push_back(fmt::format("other {}: {} and {}", what, first, second));
    };
    const auto device = [](const Conditions& c) { return fmt::format("{} ({})", c.device, c.driver); };
    const auto frames = [](const Conditions& c) {
        return fmt::format("{} of {} frames, {} rays", c.scored, c.frames, c.rays);
    };
    warn("experiments", old.experiment, now.experiment);
    warn("devices", device(old), device(now));
    warn("sizes", sizes_text(before), sizes_text(after));
    warn("frames or rays", frames(old), frames(now));
    return warnings;
}

std::string list_of(const char* title, const std::vector<Change>& changes, bool Change::* which) {
    std::string lines;
    std::size_t count = 0;
    for (const Change& change : changes) {
        if (!(change.*which)) continue;
        lines += fmt::format("  {:<44} time {:.3f} ({:.3f} to {:.3f})   error {:.3f}\n", change.name,
                             change.time.median, change.time.low, change.time.high, change.error);
        ++count;
    }
    return count == 0 ? std::string{} : fmt::format("{}: {}\n{}", title, count, lines);
}

std::string names_line(const char* title, const std::vector<std::string>& names) {
    return names.empty() ? std::string{}
                         : fmt::format("{}: {}, the first {}\n", title, names.size(), names.front());
}

}  // namespace

double time_budget(std::string_view text) {
    double budget = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), budget);
    const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
    if (error == std::errc{} && unit == "ms" && std::isfinite(budget) && budget > 0.0) return budget;
    throw std::invalid_argument(fmt::format("--budget {}: expected milliseconds, such as 1ms", text));
}

std::vector<Choice> choices_of(const Experiment& experiment, const SizeResult& result) {
    std::vector<const CaseResult*> cases;
    for (const CaseResult& one : result.cases) cases.push_back(&one);
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < experiment.candidates.size(); ++i) {
        const auto value = [&](const char* quantity, const char* statistic) {
            return mean_value(cases, i, quantity, statistic, {}).value_or(std::nan(""));
        };
        const Choice choice{.name = experiment.candidates[i].name,
                            .ms = value("ms", "median"),
                            .worst_ms = value("ms", "most"),
                            .mean_error = value("rmse", "median"),
                            .worst_error = value("rmse", "most")};
        if (std::isfinite(choice.ms) && std::isfinite(choice.mean_error)) choices.push_back(choice);
    }
    return choices;
}

std::optional<Choice> best_within(const std::vector<Choice>& choices, double budget) {
    std::optional<Choice> best;
    for (const Choice& choice : choices) {
        if (!(choice.worst_ms <= budget)) continue;
        if (!best || std::pair(choice.mean_error, choice.ms) < std::pair(best->mean_error, best->ms))
            best = choice;
    }
    return best;
}

std::optional<Choice> fastest_with(const std::vector<Choice>& choices, double error) {
    std::optional<Choice> best;
    for (const Choice& choice : choices) {
        if (!(choice.worst_error <= error)) continue;
        if (!best || std::pair(choice.ms, choice.mean_error) < std::pair(best->ms, best->mean_error))
            best = choice;
    }
    return best;
}

Answers answers_to(const Experiment& experiment, const std::vector<SizeResult>& results,
                   const std::string& budget, double error) {
    Answers answers;
    for (const SizeResult& result : results) {
        const std::vector<Choice> choices = choices_of(experiment, result);
        const std::string at = results.size() == 1 ? "" : size_text(result.extent) + ", ";
        if (!budget.empty())
            add_answer(answers, at + "within " + budget, best_within(choices, time_budget(budget)), choices,
                       &Choice::worst_ms);
        if (error > 0.0)
            add_answer(answers, fmt::format("{}RMSE at most {:g}", at, error), fastest_with(choices, error),
                       choices, &Choice::worst_error);
    }
    if (!answers.text.empty())
        answers.text += "RMSE (G): root mean square error against the traced geometry\n";
    return answers;
}

bool Comparison::got_worse() const {
    return std::ranges::any_of(changes, [](const Change& c) { return c.slower || c.worse; });
}

Comparison compared(const Record& before, const Record& after) {
    Comparison result{.warnings = warnings_of(before, after)};
    std::map<std::string, Compared> old;
    for (const Compared& one : compared_of(before)) old.emplace(one.name, one);
    for (const Compared& one : compared_of(after)) {
        if (const auto found = old.find(one.name); found != old.end()) {
            result.changes.push_back(change_of(found->second, one));
            old.erase(found);
        } else {
            result.only_new.push_back(one.name);
        }
    }
    for (const auto& [name, one] : old) result.only_old.push_back(name);
    result.time = geometric_mean(result.changes, [](const Change& c) { return c.time.median; });
    result.error = geometric_mean(result.changes, [](const Change& c) { return c.error; });
    return result;
}

std::string to_text(const Comparison& comparison) {
    std::string text;
    for (const std::string& warning : comparison.warnings) text += "warning: " + warning + "\n";
    text +=
        fmt::format("{} configurations in both; new over old, geometric means: time {:.3f}, error {:.3f}\n",
                    comparison.changes.size(), comparison.time, comparison.error);
    text += names_line("only in the old file", comparison.only_old);
    text += names_line("only in the new file", comparison.only_new);
    text += list_of("slower, beyond the spread", comparison.changes, &Change::slower);
    text += list_of("larger error", comparison.changes, &Change::worse);
    text += list_of("faster, beyond the spread", comparison.changes, &Change::faster);
    text += list_of("smaller error", comparison.changes, &Change::better);
    if (!comparison.got_worse()) text += "nothing got worse beyond the spread\n";
    return text;
}

}  // namespace gloam::experiment
