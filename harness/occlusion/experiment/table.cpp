// SPDX-License-Identifier: MIT
#include "experiment/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiment/internal/rows.hpp"

namespace gloam::experiment {
namespace {

using internal::Row;

// What a column shows: itself, at one size, of one candidate.
struct Shown {
    const Column* column;
    std::size_t size = 0;
    std::optional<std::size_t> candidate;
    std::string title;
    std::vector<std::string> cases;  // over these alone; empty: over all of the row
};

// One table over results of one or all sizes.
class Writer {
  public:
    Writer(const Experiment& experiment, const std::vector<SizeResult>& results, const Table& table)
        : experiment_(experiment), results_(results), table_(table), rows_(experiment, results, table) {}

    // Empty where none of the cases is of the table's kind.
    [[nodiscard]] std::string written(std::size_t size) {
        const auto rows = rows_.of(size);
        if (!rows.empty() && std::ranges::all_of(rows, [](const Row& row) { return row.cases.empty(); }))
            return {};
        const std::vector<Shown> columns = columns_of(size);
        std::string text = "|";
        std::string rule = "\n|";
        for (const Shown& shown : columns) {
            text += fmt::format(" {} |", shown.title);
            rule += shown.column->label.empty() && !shown.column->target ? "--:|" : "---|";
        }
        text += rule + "\n";
        for (const Row& row : rows) {
            std::string line = "|";
            bool known = table_.rows != "candidates";
            for (const Shown& shown : columns) {
                const std::string cell = cell_text(row, shown);
                known |= shown.column->label.empty() && cell != "-";
                line += fmt::format(" {} |", cell);
            }
            if (known) text += line + "\n";
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
            columns.push_back({&column, at, candidate, title, column.cases});
        };
        for (std::size_t i = 0; i < table_.columns.size(); ++i) {
            const Column& column = table_.columns[i];
            if (column.repeated == "candidates") {
                for (std::size_t c = 0; c < experiment_.candidates.size(); ++c)
                    add(column, size, c, experiment_.candidates[c].name);
            } else if (!column.repeated.empty()) {
                // Columns beside each other are repeated together.
                const std::size_t first = i;
                while (i + 1 < table_.columns.size() && table_.columns[i + 1].repeated == column.repeated)
                    ++i;
                const auto repeat = [&](std::size_t at, const std::string& name, bool of_case) {
                    for (std::size_t c = first; c <= i; ++c) {
                        add(table_.columns[c], at, std::nullopt, name);
                        if (of_case) columns.back().cases = {name};
                    }
                };
                for (std::size_t s = 0; column.repeated == "sizes" && s < results_.size(); ++s)
                    repeat(s, size_text(results_[s].extent), false);
                if (column.repeated == "cases")
                    for (const CaseResult* one :
                         rows_.cases_of(rows_.all_cases(size), size, column.cases, ""))
                        repeat(size, one->shown.name, true);
            } else {
                add(column, size, std::nullopt,
                    column.of.empty() ? "" : experiment_.candidates[number_of(column.of, 0)].name);
            }
        }
        return columns;
    }

    // require_consistent() has found that there is such a candidate.
    [[nodiscard]] std::size_t number_of(const std::string& candidate, std::size_t rows) const {
        return candidate.empty() ? rows : candidate_of(experiment_, candidate).value();
    }

    [[nodiscard]] std::string label_text(const Row& row, const Shown& shown) const {
        const Case& first = results_[shown.size].cases[row.cases.front()].shown;
        const std::string& label = shown.column->label;
        if (label == "case") return first.name;
        if (label == "what") return first.what;
        if (label == "kind") return first.kind;
        if (label == "half") return first.half;
        if (label == "pass") return row.pass;
        if (label == "frame") return std::to_string(row.frame);
        if (label == "cases") return std::to_string(row.cases.size());
        return experiment_.candidates[row.candidate].name;
    }

    // The value of a column in a row, after all divisions.
    [[nodiscard]] std::optional<double> number_in(const Row& row, const Shown& shown) const {
        const Column& column = *shown.column;
        const std::vector<const CaseResult*> cases =
            rows_.cases_of(row, shown.size, shown.cases, column.half);
        const std::size_t of = number_of(column.of, shown.candidate.value_or(row.candidate));
        const Part part = part_of(row, column);
        const auto value_in = [&](std::size_t candidate, const Part& counted) {
            return mean_value(cases, candidate, column.value, column.statistic, counted);
        };
        std::optional<double> value = value_in(of, part);
        const auto combine = [&](const std::optional<double>& other, const auto& operation) {
            value = value && other ? std::optional(operation(*value, *other)) : std::nullopt;
        };
        if (!column.over.empty()) combine(value_in(number_of(column.over, of), part), std::divides{});
        if (!column.minus.empty()) combine(value_in(number_of(column.minus, of), part), std::minus{});
        if (column.over_frame > 0) {
            Part over_part = part;
            over_part.frame = column.over_frame;
            combine(value_in(of, over_part), std::divides{});
        }
        return value;
    }

    [[nodiscard]] static Part part_of(const Row& row, const Column& column) {
        return {.prefixes = column.passes,
                .name = row.pass,
                .pixels = column.pixels,
                .against = column.against,
                .frame = row.frame > 0 ? row.frame : column.frame};
    }

    [[nodiscard]] std::string cell_text(const Row& row, const Shown& shown) {
        const Column& column = *shown.column;
        if (!column.label.empty()) return label_text(row, shown);
        const std::vector<const CaseResult*> cases =
            rows_.cases_of(row, shown.size, shown.cases, column.half);
        const std::size_t of = number_of(column.of, shown.candidate.value_or(row.candidate));
        if (column.statistic == "furthest") return furthest_text(cases, of, column);
        const std::optional<double> value = number_in(row, shown);
        if (column.target) return target_text(*cases.front(), value);
        if (!value) return "-";
        std::string text = number_text(*value, column);
        if (column.most) text += most_text(*value, *column.most);
        return column.front && on_front(cases, of) ? "**" + text + "**" : text;
    }

    // Whether a target of the column's own is met.
    [[nodiscard]] std::string most_text(double value, double most) {
        missed_ |= !(value <= most);
        return fmt::format(", at most {:g}: {}", most, value <= most ? "met" : "missed");
    }

    // The value that is furthest from 0, behind its case.
    [[nodiscard]] static std::string furthest_text(const std::vector<const CaseResult*>& cases,
                                                   std::size_t of, const Column& column) {
        std::optional<double> furthest;
        std::string name;
        for (const CaseResult* one : cases) {
            const auto value = mean_value({one}, of, column.value, "median", {});
            if (!value || (furthest && std::abs(*value) <= std::abs(*furthest))) continue;
            furthest = value;
            name = one->shown.name;
        }
        return furthest ? fmt::format("{}: {}", name, number_text(*furthest, column)) : "-";
    }

    [[nodiscard]] static std::string number_text(double value, const Column& column) {
        if (column.percent) return fmt::format("{:.{}f} %", 100.0 * value, column.digits);
        return column.with_sign ? fmt::format("{:+.{}f}", value, column.digits)
                                : fmt::format("{:.{}f}", value, column.digits);
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
            if (of(other, "rmse") < of(own, "rmse") && of(other, "ms") < of(own, "ms")) return false;
        return true;
    }

    const Experiment& experiment_;
    const std::vector<SizeResult>& results_;
    const Table& table_;
    internal::Rows rows_;
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
            if (text.empty()) continue;
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
