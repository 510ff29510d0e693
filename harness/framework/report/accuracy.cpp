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

std::string markdown_header(std::vector<std::string> titles, const std::vector<CheckReport>& reports) {
    for (const CheckReport& report : reports) titles.push_back(column_title(report, reports));
    std::string line = "\n|";
    std::string rules = "|";
    for (const std::string& title : titles) {
        line += " " + title + " |";
        rules += " --- |";
    }
    return line + "\n" + rules + "\n";
}

// A range of shares of the documented error, up to the upper end, for a row of the first table.
struct Part {
    std::string_view name;
    double most;
};
constexpr Part parts[] = {
    {"nothing: exact", 0.0}, {"up to a quarter", 0.25}, {"up to a half", 0.5}, {"up to all of it", 1.0}};

std::string parts_table(const std::vector<EquationAccuracy>& equations,
                        const std::vector<CheckReport>& reports) {
    std::string text = markdown_header({"part of the documented error"}, reports);
    const auto line = [&](std::string_view name, const auto& counts) {
        text += fmt::format("| {} |", name);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            text += fmt::format(" {} |", std::ranges::count_if(equations, [&](const EquationAccuracy& e) {
                                    return counts(e.measured[i]);
                                }));
        }
        text += "\n";
    };
    double above = -1.0;
    for (const Part& part : parts) {
        line(part.name, [&](const auto& measured) {
            return measured && measured->fraction > above && measured->fraction <= part.most;
        });
        above = part.most;
    }
    line("more: outside", [&](const auto& measured) { return measured && measured->fraction > above; });
    line("none documented: judged by the rules alone", [](const auto& measured) { return !measured; });
    return text;
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

std::string nearest_table(std::vector<EquationAccuracy> equations, const std::vector<CheckReport>& reports) {
    std::ranges::stable_sort(equations, std::ranges::greater{}, most_used);
    equations.resize(std::min(equations.size(), most_listed));
    std::erase_if(equations, [](const EquationAccuracy& e) { return most_used(e) == 0.0; });
    if (equations.empty()) return {};
    std::string text = markdown_header({"equation", "documented", "any driver"}, reports);
    for (const EquationAccuracy& equation : equations) {
        text += fmt::format("| {} | {} | {} |", equation.equation, equation.documented,
                            any_driver_text(equation));
        for (const auto& measured : equation.measured) text += " " + measured_text(measured) + " |";
        text += "\n";
    }
    return text;
}

std::string failure_text(const check::Answer& row) {
    if (!row.ran() || !row.fault.empty()) return fmt::format("{} {}", row.variant, verdict_of(row));
    return fmt::format("{} {} of {}", row.variant, row.outside(), row.inputs());
}

// A row for each variant, in the order of the rows: how many of its checks passed on each driver, of those
// that were judged.
std::string variants_table(const std::vector<CheckReport>& reports) {
    std::vector<std::string> variants;
    for (const CheckReport& report : reports)
        for (const check::Answer& row : report.rows)
            if (std::ranges::find(variants, row.variant) == variants.end()) variants.push_back(row.variant);
    std::string text = markdown_header({"checks passed in the variant"}, reports);
    for (const std::string& variant : variants) {
        text += fmt::format("| {} |", variant);
        for (const CheckReport& report : reports) {
            const auto count = [&](check::Outcome outcome) {
                return std::ranges::count_if(report.rows, [&](const check::Answer& row) {
                    return row.variant == variant && row.outcome() == outcome;
                });
            };
            const auto passed = count(check::Outcome::ok);
            text += fmt::format(" {} of {} |", passed, passed + count(check::Outcome::failed));
        }
        text += "\n";
    }
    return text;
}

// A row for each equation and device.
std::string failures_table(const std::vector<CheckReport>& reports) {
    std::string text;
    for (const CheckReport& report : reports) {
        std::vector<std::pair<std::string, std::string>> failures;  // by equation: its variants
        for (const check::Answer& row : report.rows) {
            if (!row.failed()) continue;
            if (failures.empty() || failures.back().first != row.equation)
                failures.emplace_back(row.equation, failure_text(row));
            else
                failures.back().second += ", " + failure_text(row);
        }
        for (const auto& [equation, variants] : failures)
            text += fmt::format("| {} | {} | {} |\n", equation, column_title(report, reports), variants);
    }
    if (text.empty()) return "\nNo check failed.\n";
    return "\n| equation | device | inputs outside |\n| --- | --- | --- |\n" + text;
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
    return fmt::format("{} equations.\n", equations.size()) + parts_table(equations, reports) +
           guarantee_sentence(equations) + nearest_table(equations, reports) + variants_table(reports) +
           failures_table(reports);
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
