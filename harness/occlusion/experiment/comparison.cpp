// SPDX-License-Identifier: MIT
#include "experiment/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/number.hpp"

namespace gloam::experiment {
namespace {

// Candidates that were judged and timed in all cases.
constexpr const char* choice =
    "SELECT printf('%s, at most %.3f ms, RMSE (G) %.4f in the mean, at most %.4f', candidate, worst_ms, "
    "rmse, worst_rmse) FROM overall WHERE size = :size AND ms + rmse IS NOT NULL";

// What both runs hold, by name, with the ratios of new to old.
constexpr const char* both = R"(WITH
named AS (SELECT *, iif(size_number > 1, 'size ' || size_number || '/', '') || [case]
  || iif(what = '', '', ', ' || what) || '/' || candidate AS name
  FROM (SELECT 'old' AS run, * FROM before.result UNION ALL SELECT 'new', * FROM main.result) WHERE measured),
old AS (SELECT * FROM named WHERE run = 'old'), new AS (SELECT * FROM named WHERE run = 'new'),
change AS (SELECT name, new.ms / old.ms AS time, new.low_ms / old.high_ms AS low, new.high_ms / old.low_ms AS high,
  iif(new.rmse = old.rmse, 1.0, new.rmse / old.rmse) AS error, new.low_ms > old.high_ms AS slower,
  new.high_ms < old.low_ms AS faster, ifnull(new.rmse - old.rmse >= 1e-4, old.rmse IS NOT NULL) AS worse,
  new.rmse - old.rmse <= -1e-4 AS better
  FROM new JOIN old USING (name) ORDER BY new.size_number, new.case_number, new.candidate_number)
)";

// The conditions of a record and its sizes, by what a warning calls them.
std::vector<std::pair<const char*, std::string>> circumstances(const Record& record) {
    const Conditions& all = record.conditions();
    return {{"experiments", all.experiment},
            {"devices", fmt::format("{} ({})", all.device, all.driver)},
            {"sizes", Database(record).texts("SELECT group_concat(size, ', ') FROM sizes").at(0)},
            {"frames or rays", fmt::format("{} of {} frames, {} rays", all.scored, all.frames, all.rays)}};
}

std::string warnings(const Record& before, const Record& after) {
    std::string text;
    const auto old = circumstances(before);
    const auto now = circumstances(after);
    for (std::size_t i = 0; i < old.size(); ++i)
        if (old[i].second != now[i].second)
            text += fmt::format("warning: other {}: {} and {}\n", old[i].first, old[i].second, now[i].second);
    return text;
}

std::string lines_of(const Database& database, const std::string& select, const std::string& size = "") {
    std::string lines;
    for (const std::string& line : database.texts(select, size)) lines += line + "\n";
    return lines;
}

}  // namespace

double time_budget(std::string_view text) {
    if (text.ends_with("ms"))
        if (const auto budget = base::number_from<double>(text.substr(0, text.size() - 2));
            budget && std::isfinite(*budget) && *budget > 0.0)
            return *budget;
    throw std::invalid_argument(fmt::format("--budget {}: expected milliseconds, such as 1ms", text));
}

Answers answers_to(const Database& database, const std::string& budget, double error) {
    Answers answers;
    const std::vector<std::string> sizes = database.texts("SELECT size FROM sizes");
    const auto ask = [&](const std::string& size, const std::string& question, const std::string& within,
                         const std::string& best, const std::string& nearest) {
        const std::string at = sizes.size() == 1 ? "" : size + ", ";
        answers.text += fmt::format("\n{}{}: ", at, question);
        const std::string found =
            lines_of(database, fmt::format("{} AND {} ORDER BY {} LIMIT 1", choice, within, best), size);
        answers.text += found.empty() ? "no configuration\n" : found;
        if (!found.empty()) return;
        answers.all = false;
        const std::string near =
            lines_of(database, fmt::format("{} ORDER BY {} LIMIT 1", choice, nearest), size);
        if (!near.empty()) answers.text += "  the nearest: " + near;
    };
    for (const std::string& size : sizes) {
        if (!budget.empty())
            ask(size, "within " + budget, fmt::format("worst_ms <= {}", time_budget(budget)),
                "rmse, ms, rowid", "worst_ms, rowid");
        if (error > 0.0)
            ask(size, fmt::format("RMSE at most {:g}", error), fmt::format("worst_rmse <= {}", error),
                "ms, rmse, rowid", "worst_rmse, rowid");
    }
    if (!answers.text.empty())
        answers.text += "RMSE (G): root mean square error against the traced geometry\n";
    return answers;
}

Comparison compared(const Record& before, const Record& after) {
    const Database database(after, &before);
    const auto ask = [&](const std::string& select) { return lines_of(database, both + select); };
    Comparison found{.text = warnings(before, after)};
    found.text += ask(
        "SELECT printf('%d configurations in both; new over old, geometric means: time %.3f, error %.3f', "
        "count(*), coalesce(exp(avg(ln(time))), 1), coalesce(exp(avg(ln(error))), 1)) FROM change");
    for (const auto& [here, there, title] : {std::tuple("old", "new", "old"), {"new", "old", "new"}})
        found.text += ask(
            fmt::format("SELECT printf('only in the {} file: %d, the first %s', count(*), min(name)) FROM {} "
                        "WHERE name NOT IN (SELECT name FROM {}) HAVING count(*) > 0",
                        title, here, there));
    for (const auto& [title, which] : {std::pair("slower, beyond the spread", "slower"),
                                       {"larger error", "worse"},
                                       {"faster, beyond the spread", "faster"},
                                       {"smaller error", "better"}}) {
        const std::string lines = ask(fmt::format(
            "SELECT printf('{}: %d', count(*)) FROM change WHERE {} HAVING count(*) > 0", title, which));
        found.got_worse |=
            !lines.empty() && (which == std::string("slower") || which == std::string("worse"));
        found.text += lines;
        found.text +=
            ask(fmt::format("SELECT printf('  %-44s time %s (%s to %s)   error %s', name, "
                            "ifnull(fixed(time, 3), '-'), ifnull(fixed(low, 3), '-'), "
                            "ifnull(fixed(high, 3), '-'), ifnull(fixed(error, 3), '-')) FROM change WHERE {}",
                            which));
    }
    if (ask("SELECT name FROM change LIMIT 1").empty())
        throw std::runtime_error("nothing is compared: the files have no configuration in common");
    if (!found.got_worse) found.text += "nothing got worse beyond the spread\n";
    return found;
}

}  // namespace gloam::experiment
