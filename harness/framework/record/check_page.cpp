// SPDX-License-Identifier: MIT
#include "record/check_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "base/text.hpp"
#include "numeric/numbers.hpp"

namespace gloam::record {
namespace {

constexpr std::size_t longest_value = 400;     // bytes of a cell
constexpr std::size_t longest_story = 12'000;  // bytes of a failure's story
constexpr std::size_t most_stories = 100;
constexpr int device_column = 3;  // if there are several devices

std::vector<Column> columns(bool several_devices) {
    std::vector<Column> all{
        {.title = "verdict",
         .meaning = "ok, the number of inputs outside what is allowed, not judged, or why it did not run"},
        {.title = "equation"},
        {.title = "function"},
        {.title = "variant", .meaning = "how the shader was compiled", .filter = true},
        {.title = "judged by",
         .meaning =
             "rules: what Vulkan's precision rules permit. budget: the accuracy that the function documents",
         .filter = true}};
    all.insert(all.end(), error_columns().begin(), error_columns().end());
    all.push_back(
        {.title = "remark", .meaning = "why it was not judged, or what the verdict says nothing of"});
    all.push_back({.title = "worst input", .meaning = "the input with the largest error"});
    if (several_devices) all.insert(all.begin() + device_column, {.title = "device", .filter = true});
    return all;
}

// The cells of a row, without the device.
std::vector<Cell> cells_of(const check::Answer& row) {
    const Tone tone = row.passed() ? Tone::good : row.failed() ? Tone::bad : Tone::plain;
    std::vector<Cell> cells{{verdict_of(row), {}, tone},
                            row.equation,
                            row.function,
                            row.variant,
                            row.ran() ? std::string(name_of(row.verdict)) : "-"};
    std::ranges::copy(error_cells(row), std::back_inserter(cells));
    cells.emplace_back(base::shortened(remark_on(row), longest_value));
    const std::string worst = !row.ran() ? row.error : row.worst ? row.worst->values : "-";
    cells.emplace_back(base::shortened(worst, longest_value));
    return cells;
}

Table device_table(const std::vector<CheckReport>& reports) {
    Table table{{{.title = "device"},
                 {.title = "interface"},
                 {.title = "checks", .numeric = true},
                 {.title = "failed", .numeric = true},
                 {.title = "not judged", .numeric = true},
                 {.title = "made by", .meaning = "versions of gloam and of the compilers"}}};
    for (const CheckReport& report : reports) {
        const std::size_t failed = report.count(check::Outcome::failed);
        table.rows.push_back({name_of(report.device),
                              api_of(report.device),
                              report.rows.size(),
                              {failed, failed == 0 ? Tone::good : Tone::bad},
                              report.count(check::Outcome::not_judged),
                              report.versions});
    }
    return table;
}

void add_stories(Page& page, const std::vector<CheckReport>& reports) {
    std::size_t told = 0;
    for (const CheckReport& report : reports) {
        for (const check::Answer& row : report.rows) {
            if (!row.failed()) continue;
            if (told == 0) page.heading("Failures");
            if (++told > most_stories) continue;
            page.preformatted(fmt::format("{} {} on {}: {}", row.equation, row.variant,
                                          name_of(report.device),
                                          base::shortened(row.ran() ? row.story : row.error, longest_story)));
        }
    }
    if (told > most_stories) page.paragraph(fmt::format("{} more are in the table.", told - most_stories));
}

bool judged_by_rules(const check::Answer& row) {
    return row.verdict == check::Verdict::rules;
}

// A function without a documented error is judged by the rules in every variant.
bool documents_nothing(const check::Answer& row) {
    return judged_by_rules(row) && row.variant != "strict" && row.variant != "relaxed";
}

// The largest measured error of a driver, over the variants that are judged by the documented error.
struct MeasuredError {
    double fraction = 0.0;  // of the documented error
    std::string variant;    // the variant with the largest error
};

// The documented, the guaranteed and the measured accuracy of an equation.
struct EquationAccuracy {
    std::string equation;
    std::string documented;  // "4 ulp"; empty where Vulkan's rules alone judge
    // What the rules guarantee on any driver; nullopt without a strict run.
    std::optional<check::Guarantee> any_driver;
    double open = 0.0;  // share of the inputs for which the rules permit every result
    std::vector<std::optional<MeasuredError>> measured;  // for each report; nullopt if the rules judge
};

void add_guarantee(EquationAccuracy& equation, const check::Answer& row) {
    if (row.bounded == 0 || row.variant == "relaxed") return;
    check::Guarantee most = equation.any_driver.value_or(check::Guarantee{});
    most.ulp = std::max(most.ulp, row.guarantee.ulp);
    most.absolute = std::max(most.absolute, row.guarantee.absolute);
    equation.any_driver = most;
    equation.open =
        std::max(equation.open, static_cast<double>(row.unbounded) / static_cast<double>(row.bounded));
}

void add_measured(std::optional<MeasuredError>& measured, const check::Answer& row) {
    if (row.judged() == 0 || !row.ran() || judged_by_rules(row)) return;
    if (!measured || row.budget_fraction > measured->fraction)
        measured = MeasuredError{row.budget_fraction, row.variant};
}

// Of every equation, in the order of the rows.
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

// "0.50 optimized".
Cell measured_cell(const std::optional<MeasuredError>& measured) {
    if (!measured) return "-";
    if (measured->fraction == 0.0) return {"exact", 0.0};
    return {numeric::to_short_text(measured->fraction) + " " + measured->variant, measured->fraction};
}

// The device's name if it is unique; otherwise with the driver.
std::string column_title(const CheckReport& report, const std::vector<CheckReport>& reports) {
    const auto same = [&](const CheckReport& other) { return other.device.name == report.device.name; };
    return std::ranges::count_if(reports, same) == 1 ? report.device.name : name_of(report.device);
}

}  // namespace

Table accuracy_table(const std::vector<CheckReport>& reports) {
    Table table{
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
          .numeric = true}}};
    for (const CheckReport& report : reports)
        table.columns.push_back(
            {.title = column_title(report, reports),
             .meaning =
                 "the largest measured error as a part of the documented one, and the variant that had it",
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
        for (const auto& measured : e.measured) cells.push_back(measured_cell(measured));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table check_table(const std::vector<CheckReport>& reports) {
    const bool several = reports.size() > 1;
    Table table{columns(several)};
    for (const auto outcome : {check::Outcome::failed, check::Outcome::not_judged, check::Outcome::ok}) {
        for (const CheckReport& report : reports) {
            for (const check::Answer& row : report.rows) {
                if (row.outcome() != outcome) continue;
                table.rows.push_back(cells_of(row));
                std::vector<Cell>& cells = table.rows.back();
                if (several) cells.insert(cells.begin() + device_column, name_of(report.device));
            }
        }
    }
    return table;
}

std::string to_check_page(const std::vector<CheckReport>& reports, const std::vector<std::string>& notes) {
    Page page("gloam check: " + to_text(counts_of(reports)));
    for (const std::string& note : notes) page.paragraph(note);
    page.heading("Devices");
    page.table(device_table(reports));
    add_stories(page, reports);
    page.heading("Accuracy");
    page.table(accuracy_table(reports));
    page.heading("Checks");
    page.table(check_table(reports));
    return page.html();
}

}  // namespace gloam::record
