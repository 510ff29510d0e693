// SPDX-License-Identifier: MIT
#include "report/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "numeric/numbers.hpp"

namespace gloam::report {
namespace {

constexpr std::size_t most_listed = 10;

bool judged_by_rules(const check::Answer& row) {
    return row.verdict == check::Verdict::rules;
}

// A function without a documented error is judged by the rules in every variant.
bool documents_nothing(const check::Answer& row) {
    return judged_by_rules(row) && row.variant != "strict" && row.variant != "relaxed";
}

void add_guarantee(EquationAccuracy& equation, const check::Answer& row) {
    if (row.bounded == 0 || row.variant == "relaxed") return;
    check::Guarantee most = equation.any_driver.value_or(check::Guarantee{});
    most.ulp = std::max(most.ulp, row.guarantee.ulp);
    most.absolute = std::max(most.absolute, row.guarantee.absolute);
    most.fraction = std::max(most.fraction, row.guarantee.fraction);
    equation.any_driver = most;
    equation.open =
        std::max(equation.open, static_cast<double>(row.unbounded) / static_cast<double>(row.bounded));
}

void add_measured(std::optional<MeasuredError>& measured, const check::Answer& row) {
    if (row.judged() == 0 || !row.ran() || judged_by_rules(row)) return;
    if (!measured || row.budget_fraction > measured->fraction)
        measured = MeasuredError{row.budget_fraction, row.variant};
}

double most_used(const EquationAccuracy& equation) {
    double most = 0.0;
    for (const auto& measured : equation.measured)
        if (measured) most = std::max(most, measured->fraction);
    return most;
}

// "3.6e-07, 6 ulp".
std::string error_text(double absolute, double ulp) {
    if (absolute == 0.0) return "exact";
    return fmt::format("{:.1e}, {:.3g} ulp", absolute, ulp);
}

std::string any_driver_text(const EquationAccuracy& equation) {
    if (!equation.any_driver) return "not calculated";
    const std::string text = error_text(equation.any_driver->absolute, equation.any_driver->ulp);
    return equation.open > 0.0 ? fmt::format("{}; {:.3g} % open", text, 100.0 * equation.open) : text;
}

std::string measured_text(const std::optional<MeasuredError>& measured) {
    if (!measured) return "by the rules alone";
    if (measured->fraction == 0.0) return "exact";
    return numeric::to_short_text(measured->fraction) + " " + measured->variant;
}

// The device's name if it is unique; otherwise with the driver.
std::string column_title(const CheckReport& report, const std::vector<CheckReport>& reports) {
    const auto same = [&](const CheckReport& other) { return other.device.name == report.device.name; };
    return std::ranges::count_if(reports, same) == 1 ? report.device.name : name_of(report.device);
}

// A table whose last columns are the devices.
Table table_of(std::vector<Column> columns, const std::vector<CheckReport>& reports,
               const Column& of_a_device = {}) {
    for (const CheckReport& report : reports) {
        columns.push_back(of_a_device);
        columns.back().title = column_title(report, reports);
    }
    return {std::move(columns)};
}

// A range of shares of the documented error, up to the upper end, for a row of the first table.
struct Part {
    const char* name;
    double most;
};
constexpr Part parts[] = {
    {"nothing: exact", 0.0}, {"up to a quarter", 0.25}, {"up to a half", 0.5}, {"up to all of it", 1.0}};

Table parts_table(const std::vector<EquationAccuracy>& equations, const std::vector<CheckReport>& reports) {
    Table table = table_of({{"part of the documented error"}}, reports);
    const auto add = [&](const char* name, const auto& counts) {
        std::vector<Cell>& row = table.rows.emplace_back(1, name);
        for (std::size_t i = 0; i < reports.size(); ++i)
            row.emplace_back(static_cast<std::size_t>(std::ranges::count_if(
                equations, [&](const EquationAccuracy& e) { return counts(e.measured[i]); })));
    };
    double above = -1.0;
    for (const Part& part : parts) {
        add(part.name, [&](const auto& measured) {
            return measured && measured->fraction > above && measured->fraction <= part.most;
        });
        above = part.most;
    }
    add("more: outside", [&](const auto& measured) { return measured && measured->fraction > above; });
    add("none documented: judged by the rules alone", [](const auto& measured) { return !measured; });
    return table;
}

std::string guarantee_sentence(const std::vector<EquationAccuracy>& equations) {
    const auto documented = [](const EquationAccuracy& e) { return e.any_driver && !e.documented.empty(); };
    const auto kept = [&](const EquationAccuracy& e) {
        return documented(e) && e.any_driver->fraction <= 1.0;
    };
    if (std::ranges::none_of(equations, documented)) return "";
    return fmt::format(
        "\nOf {} functions with a documented error, {} keep it on any driver that keeps Vulkan's rules, by "
        "the\nrules alone, over the inputs that were tried.\n",
        std::ranges::count_if(equations, documented), std::ranges::count_if(equations, kept));
}

Table nearest_table(std::vector<EquationAccuracy> equations, const std::vector<CheckReport>& reports) {
    std::ranges::stable_sort(equations, std::ranges::greater{}, most_used);
    equations.resize(std::min(equations.size(), most_listed));
    std::erase_if(equations, [](const EquationAccuracy& e) { return most_used(e) == 0.0; });
    Table table = table_of({{"equation"}, {"documented"}, {"any driver"}}, reports);
    for (const EquationAccuracy& e : equations) {
        table.rows.push_back({e.equation, e.documented, any_driver_text(e)});
        for (const auto& measured : e.measured) table.rows.back().emplace_back(measured_text(measured));
    }
    return table;
}

std::string failure_text(const check::Answer& row) {
    if (!row.ran() || !row.fault.empty()) return fmt::format("{} {}", row.variant, verdict_of(row));
    return fmt::format("{} {} of {}", row.variant, row.outside(), row.inputs());
}

// A row for each variant, in the order of the rows: how many of its checks passed on each driver, of those
// that were judged.
Table variants_table(const std::vector<CheckReport>& reports) {
    std::vector<std::string> variants;
    for (const CheckReport& report : reports)
        for (const check::Answer& row : report.rows)
            if (std::ranges::find(variants, row.variant) == variants.end()) variants.push_back(row.variant);
    Table table = table_of({{"checks passed in the variant"}}, reports);
    for (const std::string& variant : variants) {
        table.rows.push_back({variant});
        for (const CheckReport& report : reports) {
            const auto count = [&](check::Outcome outcome) {
                return std::ranges::count_if(report.rows, [&](const check::Answer& row) {
                    return row.variant == variant && row.outcome() == outcome;
                });
            };
            const auto passed = count(check::Outcome::ok);
            table.rows.back().emplace_back(
                fmt::format("{} of {}", passed, passed + count(check::Outcome::failed)));
        }
    }
    return table;
}

// A row for each equation and device.
Table failures_table(const std::vector<CheckReport>& reports) {
    Table table{{{"equation"}, {"device"}, {"inputs outside"}}};
    for (const CheckReport& report : reports) {
        const std::size_t first = table.rows.size();
        for (const check::Answer& row : report.rows) {
            if (!row.failed()) continue;
            if (table.rows.size() == first || table.rows.back()[0].text != row.equation)
                table.rows.push_back({row.equation, column_title(report, reports), failure_text(row)});
            else
                table.rows.back()[2].text += ", " + failure_text(row);
        }
    }
    return table;
}

// Without rows: what is said instead.
std::string text_of(const Table& table, const char* otherwise = "") {
    return table.rows.empty() ? otherwise : "\n" + to_markdown(table);
}

}  // namespace

std::vector<EquationAccuracy> accuracies(const std::vector<CheckReport>& reports) {
    std::vector<EquationAccuracy> all;
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        for (const check::Answer& row : reports[i].rows) {
            const auto [place, is_new] = places.try_emplace(row.equation, all.size());
            if (is_new) {
                all.push_back({.equation = row.equation,
                               .documented = to_text(row.budget),
                               .measured = std::vector<std::optional<MeasuredError>>(reports.size())});
            }
            EquationAccuracy& equation = all[place->second];
            if (documents_nothing(row)) equation.documented.clear();
            add_guarantee(equation, row);
            add_measured(equation.measured[i], row);
        }
    }
    return all;
}

std::string to_accuracy_markdown(const std::vector<CheckReport>& reports) {
    const std::vector<EquationAccuracy> equations = accuracies(reports);
    return fmt::format("{} equations.\n", equations.size()) + text_of(parts_table(equations, reports)) +
           guarantee_sentence(equations) + text_of(nearest_table(equations, reports)) + "\n" +
           to_markdown(variants_table(reports)) + text_of(failures_table(reports), "\nNo check failed.\n");
}

Table accuracy_table(const std::vector<CheckReport>& reports) {
    Table table = table_of(
        {{"equation"},
         {.title = "documented", .meaning = "each output is within the ULP bound or within the absolute one"},
         {.title = "any driver, absolute",
          .meaning =
              "the largest error that Vulkan's rules leave any driver that runs the strict shader, over "
              "the ordinary inputs that were tried",
          .numeric = true},
         {.title = "any driver, ULP", .numeric = true},
         {.title = "open, %",
          .meaning = "share of all inputs, special ones included, for which the rules permit anything",
          .numeric = true}},
        reports,
        {.meaning = "the largest measured error as a part of the documented one, and the variant that had it",
         .numeric = true});
    for (const EquationAccuracy& e : accuracies(reports)) {
        std::vector<Cell> cells{e.equation, e.documented.empty() ? "Vulkan's rules" : e.documented};
        if (const auto& any = e.any_driver) {
            cells.emplace_back(fmt::format("{:.1e}", any->absolute), any->absolute);
            cells.emplace_back(fmt::format("{:.3g}", any->ulp), any->ulp);
            cells.emplace_back(fmt::format("{:.3g}", 100.0 * e.open), e.open);
        } else {
            cells.insert(cells.end(), 3, "-");
        }
        for (const auto& measured : e.measured)
            cells.push_back(measured ? Cell(measured_text(measured), measured->fraction) : "-");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace gloam::report
