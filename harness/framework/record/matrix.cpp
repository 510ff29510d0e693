// SPDX-License-Identifier: MIT
#include "record/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "numeric/numbers.hpp"
#include "record/table.hpp"

namespace gloam::record {
namespace {

// The driver; and what it was asked with, where another report is of the same driver.
std::string title_of(const std::vector<CheckReport>& reports, std::size_t index) {
    const CheckReport& report = reports[index];
    const std::string name = name_of(report.device);
    const auto same = [&](const CheckReport& other) { return name_of(other.device) == name; };
    if (std::ranges::count_if(reports, same) < 2) return name;
    return fmt::format("{}, {} inputs, seed {}", name, report.inputs, report.seed);
}

std::string cell(const judge::Answer& row) {
    if (!row.ran()) return std::string(name_of(row.reason));
    if (!row.fault.empty()) return "FAULT";
    if (row.outside() > 0) return fmt::format("FAIL {}/{}", row.outside(), row.inputs());
    if (!row.passed()) return std::string(name_of(row.outcome()));
    return "ok " + numeric::to_short_text(row.fraction_of_allowed());
}

// A row for each equation, a column for each variant on each driver. A device's own row is in the summary.
Table table_of(const std::vector<CheckReport>& reports) {
    Table table{{{.title = "equation"}}};
    std::map<std::string, std::vector<Cell>> by_equation;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        for (const judge::Answer& row : reports[i].rows) {
            if (row.variant.empty()) continue;
            const std::string title =
                reports.size() == 1 ? row.variant : fmt::format("{} {}", i + 1, row.variant);
            const auto found = std::ranges::find(table.columns, title, &Column::title);
            const auto at = static_cast<std::size_t>(found - table.columns.begin());
            if (at == table.columns.size()) table.columns.push_back({title});
            std::vector<Cell>& cells = by_equation[row.equation];
            cells.resize(std::max(cells.size(), at + 1), "-");
            cells[at] = cell(row);
        }
    }
    for (auto& [equation, cells] : by_equation) {
        cells.resize(table.columns.size(), "-");
        cells.front() = equation;
        table.rows.push_back(cells);
    }
    return table;
}

constexpr std::string_view legend =
    "ok 0.85: passed, the largest error is 0.85 of what is allowed. FAIL 3/100: 3 of 100 inputs are "
    "outside.\n"
    "not judged, unsupported: no verdict. hang, crash and other words: the check did not end. -: it was not "
    "run.\n";

std::string summary(const CheckReport& report) {
    std::map<std::string, std::size_t> reasons;
    const judge::Answer* worst = nullptr;
    for (const judge::Answer& row : report.rows) {
        if (row.failed())
            ++reasons[row.reason == judge::Reason::none ? "outside" : std::string(name_of(row.reason))];
        if (row.ran() && row.judged() > 0 &&
            (worst == nullptr || row.fraction_of_allowed() > worst->fraction_of_allowed()))
            worst = &row;
    }
    std::string text = to_text(counts_of({report}));
    std::string separator = "; failed: ";
    for (const auto& [reason, count] : reasons) {
        text += fmt::format("{}{} {}", separator, count, reason);
        separator = ", ";
    }
    if (worst != nullptr)
        text += fmt::format("; worst error {:.3g} of what is allowed: {} {}", worst->fraction_of_allowed(),
                            worst->equation, worst->variant);
    for (const judge::Answer& row : report.rows)
        if (row.variant.empty()) text += "; " + base::one_line(row.error);
    return text;
}

}  // namespace

std::string to_matrix(const std::vector<CheckReport>& reports) {
    std::string text;
    for (std::size_t i = 0; i < reports.size(); ++i)
        text += fmt::format("driver {}: {}\n", i + 1, title_of(reports, i));
    text += "\n" + aligned(table_of(reports)) + "\n" + std::string(legend) + "\n";
    for (std::size_t i = 0; i < reports.size(); ++i)
        text += fmt::format("driver {}: {}\n", i + 1, summary(reports[i]));
    return text;
}

std::string to_matrix_markdown(const std::vector<CheckReport>& reports) {
    Table drivers{{{"driver"}, {""}, {"result"}}};
    for (std::size_t i = 0; i < reports.size(); ++i)
        drivers.rows.push_back({i + 1, title_of(reports, i), summary(reports[i])});
    return "# Equations on drivers\n\n" + to_markdown(drivers) + "\n" + to_markdown(table_of(reports));
}

}  // namespace gloam::record
