// SPDX-License-Identifier: MIT
#include "report/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "numeric/numbers.hpp"

namespace gloam::report {
namespace {

using Line = std::vector<std::string>;

// The driver; and what it was asked with, where another report is of the same driver.
std::string title_of(const std::vector<CheckReport>& reports, std::size_t index) {
    const CheckReport& report = reports[index];
    const std::string name = name_of(report.device);
    const auto same = [&](const CheckReport& other) { return name_of(other.device) == name; };
    if (std::ranges::count_if(reports, same) < 2) return name;
    return fmt::format("{}, {} inputs, seed {}", name, report.inputs, report.seed);
}

std::string cell(const check::Answer& row) {
    if (!row.ran()) return std::string(name_of(row.reason));
    if (!row.fault.empty()) return "FAULT";
    if (row.outside() > 0) return fmt::format("FAIL {}/{}", row.outside(), row.inputs());
    if (!row.passed()) return std::string(name_of(row.outcome()));
    return "ok " + numeric::to_short_text(row.fraction_of_allowed());
}

std::vector<std::string> variants_of(const CheckReport& report) {
    std::vector<std::string> variants;
    for (const check::Answer& row : report.rows) {
        if (!row.variant.empty() && std::ranges::find(variants, row.variant) == variants.end()) {
            variants.push_back(row.variant);
        }
    }
    return variants;
}

// The column titles, then a line for each equation.
TextTable lines_of(const std::vector<CheckReport>& reports) {
    TextTable lines{{"equation"}};
    std::map<std::string, Line> by_equation;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const std::vector<std::string> variants = variants_of(reports[i]);
        const std::size_t first = lines.front().size();
        for (const std::string& variant : variants) {
            lines.front().push_back(reports.size() == 1 ? variant : fmt::format("{} {}", i + 1, variant));
        }
        for (const check::Answer& row : reports[i].rows) {
            if (row.variant.empty()) continue;  // the row of the device itself, which is in the summary
            Line& line = by_equation.try_emplace(row.equation, Line{row.equation}).first->second;
            const auto at = std::ranges::find(variants, row.variant) - variants.begin();
            line.resize(std::max(line.size(), first + static_cast<std::size_t>(at) + 1), "-");
            line[first + static_cast<std::size_t>(at)] = cell(row);
        }
    }
    for (auto& [equation, line] : by_equation) {
        line.resize(lines.front().size(), "-");
        lines.push_back(line);
    }
    return lines;
}

constexpr std::string_view legend =
    "ok 0.85: passed, the largest error is 0.85 of what is allowed. FAIL 3/100: 3 of 100 inputs are "
    "outside.\n"
    "not judged, unsupported: no verdict. Another reason, \"hang\" say: the check did not end. -: it was not "
    "run.\n";

std::string summary(const CheckReport& report) {
    std::map<std::string, std::size_t> reasons;
    const check::Answer* worst = nullptr;
    for (const check::Answer& row : report.rows) {
        if (row.failed())
            ++reasons[row.reason == check::Reason::none ? "outside" : std::string(name_of(row.reason))];
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
    if (worst != nullptr) {
        text += fmt::format("; worst error {:.3g} of what is allowed: {} {}", worst->fraction_of_allowed(),
                            worst->equation, worst->variant);
    }
    for (const check::Answer& row : report.rows) {
        if (row.variant.empty()) text += "; " + row.error;
    }
    return text;
}

}  // namespace

std::string to_matrix(const std::vector<CheckReport>& reports) {
    std::string text;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        text += fmt::format("driver {}: {}\n", i + 1, title_of(reports, i));
    }
    text += "\n" + aligned(lines_of(reports)) + "\n" + std::string(legend) + "\n";
    for (std::size_t i = 0; i < reports.size(); ++i) {
        text += fmt::format("driver {}: {}\n", i + 1, summary(reports[i]));
    }
    return text;
}

std::string to_matrix_markdown(const std::vector<CheckReport>& reports) {
    TextTable drivers{{"driver", "", "result"}};
    for (std::size_t i = 0; i < reports.size(); ++i)
        drivers.push_back({std::to_string(i + 1), title_of(reports, i), summary(reports[i])});
    return "# Equations on drivers\n\n" + to_markdown(drivers) + "\n" + to_markdown(lines_of(reports));
}

std::string aligned(const TextTable& table) {
    std::vector<std::size_t> widths(table.front().size(), 0);
    for (const Line& line : table)
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const Line& line : table) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) row += fmt::format("{:<{}}  ", line[i], widths[i]);
        text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string to_markdown(const TextTable& table) {
    std::string text;
    for (const Line& line : table) {
        text += "|";
        for (const std::string& cell : line) {
            text += cell.empty() ? "" : " ";
            for (const char c : cell) text += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
            text += " |";
        }
        text += "\n";
        if (&line != &table.front()) continue;
        text += "|";
        for (std::size_t i = 0; i < line.size(); ++i) text += " --- |";
        text += "\n";
    }
    return text;
}

}  // namespace gloam::report
