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
TextTable table_of(std::vector<std::string> titles, const std::vector<CheckReport>& reports) {
    for (const CheckReport& report : reports) titles.push_back(column_title(report, reports));
    return {std::move(titles)};
}

// A range of shares of the documented error, up to the upper end, for a row of the first table.
struct Part {
    std::string_view name;
    double most;
};
constexpr Part parts[] = {
    {"nothing: exact", 0.0}, {"up to a quarter", 0.25}, {"up to a half", 0.5}, {"up to all of it", 1.0}};

TextTable parts_table(const std::vector<EquationAccuracy>& equations,
                      const std::vector<CheckReport>& reports) {
    TextTable table = table_of({"part of the documented error"}, reports);
    const auto add = [&](std::string_view name, const auto& counts) {
        std::vector<std::string>& line = table.emplace_back(1, std::string(name));
        for (std::size_t i = 0; i < reports.size(); ++i)
            line.push_back(std::to_string(std::ranges::count_if(
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
    return fmt::format(
        "\nOf {} functions with a documented error, {} keep it on any driver that keeps Vulkan's rules, by "
        "the\nrules alone, over the inputs that were tried.\n",
        std::ranges::count_if(equations, documented), std::ranges::count_if(equations, kept));
}

TextTable nearest_table(std::vector<EquationAccuracy> equations, const std::vector<CheckReport>& reports) {
    std::ranges::stable_sort(equations, std::ranges::greater{}, most_used);
    equations.resize(std::min(equations.size(), most_listed));
    std::erase_if(equations, [](const EquationAccuracy& e) { return most_used(e) == 0.0; });
    TextTable table = table_of({"equation", "documented", "any driver"}, reports);
    for (const EquationAccuracy& e : equations) {
        table.push_back({e.equation, e.documented, any_driver_text(e)});
        for (const auto& measured : e.measured) table.back().push_back(measured_text(measured));
    }
    return table;
}

std::string failure_text(const check::Answer& row) {
    if (!row.ran() || !row.fault.empty()) return fmt::format("{} {}", row.variant, verdict_of(row));
    return fmt::format("{} {} of {}", row.variant, row.outside(), row.inputs());
}

// A row for each variant, in the order of the rows: how many of its checks passed on each driver, of those
// that were judged.
TextTable variants_table(const std::vector<CheckReport>& reports) {
    std::vector<std::string> variants;
    for (const CheckReport& report : reports)
        for (const check::Answer& row : report.rows)
            if (std::ranges::find(variants, row.variant) == variants.end()) variants.push_back(row.variant);
    TextTable table = table_of({"checks passed in the variant"}, reports);
    for (const std::string& variant : variants) {
        table.push_back({variant});
        for (const CheckReport& report : reports) {
            const auto count = [&](check::Outcome outcome) {
                return std::ranges::count_if(report.rows, [&](const check::Answer& row) {
                    return row.variant == variant && row.outcome() == outcome;
                });
            };
            const auto passed = count(check::Outcome::ok);
            table.back().push_back(fmt::format("{} of {}", passed, passed + count(check::Outcome::failed)));
        }
    }
    return table;
}

// A row for each equation and device.
TextTable failures_table(const std::vector<CheckReport>& reports) {
    TextTable table{{"equation", "device", "inputs outside"}};
    for (const CheckReport& report : reports) {
        const std::size_t first = table.size();
        for (const check::Answer& row : report.rows) {
            if (!row.failed()) continue;
            if (table.size() == first || table.back()[0] != row.equation)
                table.push_back({row.equation, column_title(report, reports), failure_text(row)});
            else
                table.back()[2] += ", " + failure_text(row);
        }
    }
    return table;
}

// Without lines: what is said instead.
std::string text_of(const TextTable& table, const char* otherwise = "") {
    return table.size() == 1 ? otherwise : "\n" + to_markdown(table);
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

PageTable accuracy_table(const std::vector<CheckReport>& reports) {
    PageTable table{
        .columns = {{.title = "equation"},
                    {.title = "documented",
                     .meaning = "each output is within the ULP bound or within the absolute one"},
                    {.title = "any driver, absolute",
                     .meaning = "the largest error that Vulkan's rules leave any driver that runs "
                                "the strict shader, over the ordinary inputs that were tried",
                     .numeric = true},
                    {.title = "any driver, ULP", .numeric = true},
                    {.title = "open, %",
                     .meaning = "share of all inputs, special ones included, for which the rules "
                                "permit anything",
                     .numeric = true}},
        .rows = {}};
    for (const CheckReport& report : reports) {
        table.columns.push_back({.title = column_title(report, reports),
                                 .meaning = "the largest measured error as a part of the documented one, and "
                                            "the variant that had it",
                                 .numeric = true});
    }
    for (const EquationAccuracy& e : accuracies(reports)) {
        std::vector<PageCell> cells{{e.equation}, {e.documented.empty() ? "Vulkan's rules" : e.documented}};
        if (e.any_driver) {
            cells.push_back(
                number_cell(e.any_driver->absolute, fmt::format("{:.1e}", e.any_driver->absolute)));
            cells.push_back(number_cell(e.any_driver->ulp, fmt::format("{:.3g}", e.any_driver->ulp)));
            cells.push_back(number_cell(e.open, fmt::format("{:.3g}", 100.0 * e.open)));
        } else {
            cells.insert(cells.end(), 3, {"-"});
        }
        for (const auto& measured : e.measured)
            cells.push_back(measured ? number_cell(measured->fraction, measured_text(measured))
                                     : PageCell{"-"});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace gloam::report
