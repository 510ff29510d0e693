// SPDX-License-Identifier: MIT
#include "experiment/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace gloam::experiment {
namespace {

// What a row is about: cases and a candidate, both by number, and a pass.
struct Row {
    std::vector<std::size_t> cases;
    std::size_t candidate = 0;
    std::string pass;
};

// What a column shows: itself, at one size, of one candidate.
struct Shown {
    const Column* column;
    std::size_t size = 0;
    std::optional<std::size_t> candidate;
    std::string title;
};

// One table over results of one or all sizes.
class Writer {
  public:
    Writer(const Experiment& experiment, const std::vector<SizeResult>& results, const Table& table)
        : experiment_(experiment), results_(results), table_(table) {}

    [[nodiscard]] std::string written(std::size_t size) {
        const std::vector<Shown> columns = columns_of(size);
        std::string text = "|";
        std::string rule = "\n|";
        for (const Shown& shown : columns) {
            text += fmt::format(" {} |", shown.title);
            rule += shown.column->label.empty() && !shown.column->target ? "--:|" : "---|";
        }
        text += rule + "\n";
        for (const Row& row : rows_of(size)) {
            text += "|";
            for (const Shown& shown : columns) text += fmt::format(" {} |", cell_text(row, shown));
            text += "\n";
        }
        return text;
    }

    [[nodiscard]] bool missed() const { return missed_; }

  private:
    [[nodiscard]] std::vector<Shown> columns_of(std::size_t size) const {
        std::vector<Shown> columns;
        const auto add = [&](const Column& column, std::size_t at, std::optional<std::size_t> candidate,
                             const std::string& name) {
            std::string title = column.title;
            const std::size_t place = title.find("{}");
            if (place != std::string::npos) title.replace(place, 2, name);
            columns.push_back({&column, at, candidate, title});
        };
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            const Column& column = table_.columns[i];
            if (column.repeated == "candidates") {
                for (std::size_t c = 0; c < experiment_.candidates.size(); ++c)
                    add(column, size, c, experiment_.candidates[c].name);
            } else if (column.repeated == "sizes") {
                // Columns beside each other are repeated together.
                std::size_t end = i;
                while (end < table_.columns.size() && table_.columns[end].repeated == "sizes") ++end;
                for (std::size_t s = 0; s < results_.size(); ++s)
                    for (std::size_t c = i; c < end; ++c)
                        add(table_.columns[c], s, std::nullopt, size_text(results_[s].extent));
                i = end - 1;
            } else {
                add(column, size, std::nullopt,
                    column.of.empty() ? "" : experiment_.candidates[number_of(column.of, 0)].name);
            }
        }
        return columns;
    }

    [[nodiscard]] std::vector<Row> rows_of(std::size_t size) const {
        const std::vector<CaseResult>& cases = results_[size].cases;
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < cases.size(); ++i)
            if (table_.kind.empty() || cases[i].shown.kind == table_.kind) all.push_back(i);
        std::vector<Row> rows;
        if (table_.rows == "candidates") {
            for (const std::size_t c : kept(cases_of({all, 0, ""}, size, ""))) rows.push_back({all, c, ""});
        } else if (table_.rows == "kinds") {
            add_kinds(rows, cases, all, 0, false);
        } else if (table_.rows == "growth") {
            for (std::size_t c = 0; c < experiment_.candidates.size(); ++c)
                add_kinds(rows, cases, all, c, true);
        } else {
            for (const std::size_t i : all) add_rows(rows, cases[i], i);
        }
        return rows;
    }

    // A row for each kind of the cases; measured: only cases in which the candidate was measured.
    static void add_kinds(std::vector<Row>& rows, const std::vector<CaseResult>& cases,
                          const std::vector<std::size_t>& all, std::size_t candidate, bool measured) {
        std::map<std::string, std::size_t> row_of;  // by kind
        for (const std::size_t i : all) {
            if (measured && !cases[i].cells[candidate]) continue;
            const auto [at, is_new] = row_of.try_emplace(cases[i].shown.kind, rows.size());
            if (is_new) rows.push_back({{}, candidate, ""});
            rows[at->second].cases.push_back(i);
        }
    }

    // The candidates of which a table over these cases has rows, in their order.
    [[nodiscard]] std::vector<std::size_t> kept(const std::vector<const CaseResult*>& cases) const {
        std::vector<std::size_t> numbers;
        if (table_.keep == "front") {
            for (const FrontPoint& point : front_of(front_points(cases))) numbers.push_back(point.candidate);
        } else {
            for (std::size_t c = 0; c < experiment_.candidates.size(); ++c) numbers.push_back(c);
            if (table_.keep == "best") numbers = best_of(cases, numbers);
        }
        std::erase_if(numbers, [&](std::size_t c) {
            return !table_.group.empty() && experiment_.candidates[c].group != table_.group;
        });
        return numbers;
    }

    // The one with the least error of each group.
    [[nodiscard]] std::vector<std::size_t> best_of(const std::vector<const CaseResult*>& cases,
                                                   const std::vector<std::size_t>& numbers) const {
        std::map<std::string, std::pair<double, std::size_t>> best;  // by group
        for (const std::size_t c : numbers) {
            const auto error = mean_value(cases, c, "rmse", "median", {});
            if (!error) continue;
            const auto [at, is_new] = best.try_emplace(experiment_.candidates[c].group, *error, c);
            if (!is_new && *error < at->second.first) at->second = {*error, c};
        }
        std::vector<std::size_t> chosen;
        for (const auto& [group, found] : best) chosen.push_back(found.second);
        std::ranges::sort(chosen);
        return chosen;
    }

    // The rows of one case.
    void add_rows(std::vector<Row>& rows, const CaseResult& result, std::size_t number) const {
        if (table_.rows == "cases") {
            rows.push_back({{number}, 0, ""});
            return;
        }
        for (const std::size_t c : kept({&result})) {
            if (!result.cells[c]) continue;
            if (table_.rows == "runs") rows.push_back({{number}, c, ""});
            if (table_.rows == "passes")
                for (const std::string& pass : passes_of(*result.cells[c]))
                    rows.push_back({{number}, c, pass});
        }
    }

    // require_consistent() has found that there is such a candidate.
    [[nodiscard]] std::size_t number_of(const std::string& candidate, std::size_t rows) const {
        return candidate.empty() ? rows : candidate_of(experiment_, candidate).value();
    }

    [[nodiscard]] std::vector<const CaseResult*> cases_of(const Row& row, std::size_t size,
                                                          const std::string& half) const {
        std::vector<const CaseResult*> cases;
        for (const std::size_t i : row.cases) {
            const CaseResult& one = results_[size].cases[i];
            if (half.empty() || one.shown.half == half) cases.push_back(&one);
        }
        return cases;
    }

    [[nodiscard]] std::string label_text(const Row& row, const Shown& shown) const {
        const Case& first = results_[shown.size].cases[row.cases.front()].shown;
        const std::string& label = shown.column->label;
        if (label == "case") return first.name;
        if (label == "what") return first.what;
        if (label == "kind") return first.kind;
        if (label == "half") return first.half;
        if (label == "pass") return row.pass;
        if (label == "cases") return std::to_string(row.cases.size());
        return experiment_.candidates[row.candidate].name;
    }

    [[nodiscard]] std::string cell_text(const Row& row, const Shown& shown) {
        const Column& column = *shown.column;
        if (!column.label.empty()) return label_text(row, shown);
        const std::vector<const CaseResult*> cases = cases_of(row, shown.size, column.half);
        const std::size_t of = number_of(column.of, shown.candidate.value_or(row.candidate));
        const TimedPasses passes{.prefixes = column.passes, .name = row.pass};
        const TimedPasses over_passes{.prefixes = column.over_passes, .name = row.pass};
        if (column.statistic == "quartiles") return quartiles_text(cases, of, column);
        if (column.statistic == "list") return list_text(cases, of, column);
        const auto value_in = [&](const std::vector<const CaseResult*>& some, std::size_t candidate,
                                  const TimedPasses& timed) {
            return mean_value(some, candidate, column.value, column.statistic, timed);
        };
        std::optional<double> value = value_in(cases, of, passes);
        const auto combine = [&](const std::optional<double>& other, const auto& operation) {
            value = value && other ? std::optional(operation(*value, *other)) : std::nullopt;
        };
        if (!column.over.empty())
            combine(value_in(cases, number_of(column.over, of), over_passes), std::divides{});
        if (!column.over_case.empty())
            combine(value_in(case_named(column.over_case, shown.size), of, over_passes), std::divides{});
        if (!column.minus.empty())
            combine(value_in(cases, number_of(column.minus, of), passes), std::minus{});
        if (column.target) return target_text(*cases.front(), value);
        if (!value) return "-";
        const std::string text = number_text(*value, column);
        return column.front && on_front(cases, of) ? "**" + text + "**" : text;
    }

    // None where it was not chosen.
    [[nodiscard]] std::vector<const CaseResult*> case_named(const std::string& name, std::size_t size) const {
        for (const CaseResult& one : results_[size].cases)
            if (one.shown.name == name) return {&one};
        return {};
    }

    // "4: 0.12, 8: 0.19": the value in each case, beside what grows.
    [[nodiscard]] static std::string list_text(const std::vector<const CaseResult*>& cases, std::size_t of,
                                               const Column& column) {
        std::string text;
        for (const CaseResult* one : cases) {
            const auto value = mean_value({one}, of, column.value, "median", {.prefixes = column.passes});
            text += fmt::format("{}{:.4g}: {}", text.empty() ? "" : ", ", one->shown.value,
                                value ? number_text(*value, column) : "-");
        }
        return text;
    }

    [[nodiscard]] static std::string number_text(double value, const Column& column) {
        return column.percent ? fmt::format("{:.{}f} %", 100.0 * value, column.digits)
                              : fmt::format("{:.{}f}", value, column.digits);
    }

    [[nodiscard]] std::string quartiles_text(const std::vector<const CaseResult*>& cases, std::size_t of,
                                             const Column& column) const {
        if (cases.empty()) return "-";
        const numeric::Spread spread =
            round_ratios(*cases.front(), of, number_of(column.over, of), {.prefixes = column.passes},
                         {.prefixes = column.over_passes});
        if (std::isnan(spread.median)) return "-";
        return fmt::format("{0:.{3}f} ({1:.{3}f} to {2:.{3}f})", spread.median, spread.low, spread.high,
                           column.digits);
    }

    [[nodiscard]] std::string target_text(const CaseResult& one, std::optional<double> value) {
        if (one.shown.target == 0.0 || !value) return "";
        const bool met = *value <= one.shown.target;
        missed_ |= !met;
        return fmt::format("{:.2f}, {}", one.shown.target, met ? "met" : "missed");
    }

    // Whether no other candidate has both a smaller mean error and a smaller mean time.
    [[nodiscard]] bool on_front(const std::vector<const CaseResult*>& cases, std::size_t own) const {
        const auto of = [&](std::size_t candidate, const char* what) {
            return mean_value(cases, candidate, what, "median", {}).value_or(0.0);
        };
        for (std::size_t other = 0; other < experiment_.candidates.size(); ++other)
            if (of(other, "rmse") < of(own, "rmse") && of(other, "copies") < of(own, "copies")) return false;
        return true;
    }

    const Experiment& experiment_;
    const std::vector<SizeResult>& results_;
    const Table& table_;
    bool missed_ = false;
};

}  // namespace

Text to_text(const Experiment& experiment, const std::vector<SizeResult>& results) {
    Text all;
    for (const Table& table : experiment.tables) {
        const bool by_size = std::ranges::count(table.columns, "sizes", &Column::repeated) > 0;
        for (std::size_t size = 0; size < (by_size ? 1 : results.size()); ++size) {
            Writer writer(experiment, results, table);
            std::string text = writer.written(size);
            if (!by_size && results.size() > 1) text = size_text(results[size].extent) + ":\n\n" + text;
            all.report += "\n" + text;
            if (!table.in_report) all.text += "\n" + text;
            if (!table.name.empty()) {
                std::string& block = all.named[table.name];
                block += (block.empty() ? "" : "\n") + text;
            }
            all.missed |= writer.missed();
        }
    }
    return all;
}

}  // namespace gloam::experiment
