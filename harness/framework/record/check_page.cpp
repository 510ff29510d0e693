// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/text.hpp"
#include "numeric/numbers.hpp"
#include "record/check_report.hpp"
#include "record/page.hpp"

namespace gloam::record {
namespace {

constexpr std::size_t longest_value = 400;     // bytes of a cell
constexpr std::size_t longest_story = 12'000;  // bytes of a failure's story
constexpr std::size_t most_stories = 100;
constexpr int device_column = 4;  // if there are several devices

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
std::vector<Cell> cells_of(const judge::Answer& row) {
    const Tone tone = row.passed() ? Tone::good : row.failed() ? Tone::bad : Tone::plain;
    std::vector<Cell> cells{{verdict_of(row), {}, tone},
                            row.equation,
                            row.function,
                            row.variant,
                            row.ran() ? std::string(name_of(row.criterion)) : "-"};
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
        const std::size_t failed = report.count(judge::Outcome::failed);
        table.rows.push_back({name_of(report.device),
                              api_of(report.device),
                              report.rows.size(),
                              {failed, failed == 0 ? Tone::good : Tone::bad},
                              report.count(judge::Outcome::not_judged),
                              report.versions});
    }
    return table;
}

void add_stories(Page& page, const std::vector<CheckReport>& reports) {
    std::size_t told = 0;
    for (const CheckReport& report : reports) {
        for (const judge::Answer& row : report.rows) {
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

// The documented, the guaranteed and the measured accuracy of an equation.
struct EquationAccuracy {
    std::string equation;
    std::string documented;                      // "4 ulp"
    std::optional<judge::ErrorSize> any_driver;  // by the rules; nullopt without a strict run
    double open = 0.0;  // share of the inputs for which the rules permit every result
    // Of each report, the largest error of a variant that is judged by the documented one; nullptr: none is.
    std::vector<const judge::Answer*> worst;

    void add(std::size_t report, const judge::Answer& row) {
        const bool by_rules = row.rules_alone();
        // A function without a documented error is judged by the rules in every variant.
        if (by_rules && row.variant != "strict" && row.variant != "relaxed") documented = "Vulkan's rules";
        if (row.bounded > 0 && row.variant != "relaxed") {
            const judge::ErrorSize most = any_driver.value_or(judge::ErrorSize{});
            any_driver = {.ulp = std::max(most.ulp, row.guarantee.ulp),
                          .absolute = std::max(most.absolute, row.guarantee.absolute)};
            open = std::max(open, static_cast<double>(row.unbounded) / static_cast<double>(row.bounded));
        }
        if (by_rules || !row.ran() || row.judged() == 0) return;
        const judge::Answer*& most = worst[report];
        if (most == nullptr || row.largest.fraction > most->largest.fraction) most = &row;
    }
};

// Of every equation, in the order of the rows.
std::vector<EquationAccuracy> accuracies(const std::vector<CheckReport>& reports) {
    std::vector<EquationAccuracy> all;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        for (const judge::Answer& row : reports[i].rows) {
            auto known = std::ranges::find(all, row.equation, &EquationAccuracy::equation);
            if (known == all.end())
                known = all.insert(known, {.equation = row.equation,
                                           .documented = to_text(row.budget),
                                           .any_driver = {},
                                           .worst = std::vector<const judge::Answer*>(reports.size())});
            known->add(i, row);
        }
    }
    return all;
}

// "0.50 optimized".
Cell measured_cell(const judge::Answer* worst) {
    if (worst == nullptr) return "-";
    const double fraction = worst->largest.fraction;
    return {fraction == 0.0 ? "exact" : numeric::to_short_text(fraction) + " " + worst->variant, fraction};
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
        std::vector<Cell>& cells = table.rows.emplace_back(std::vector<Cell>{e.equation, e.documented});
        if (const auto& any = e.any_driver) {
            const bool anything = e.open > 0.5 && any->absolute == 0.0;  // of ordinary inputs
            cells.emplace_back(anything ? "anything" : fmt::format("{:.1e}", any->absolute), any->absolute);
            cells.emplace_back(anything ? "anything" : fmt::format("{:.3g}", any->ulp), any->ulp);
            cells.emplace_back(fmt::format("{:.3g}", 100.0 * e.open), e.open);
        } else {
            cells.insert(cells.end(), 3, "-");
        }
        std::ranges::transform(e.worst, std::back_inserter(cells), measured_cell);
    }
    return table;
}

Table check_table(const std::vector<CheckReport>& reports) {
    const bool several = reports.size() > 1;
    Table table{columns(several)};
    for (const auto outcome : {judge::Outcome::failed, judge::Outcome::not_judged, judge::Outcome::ok}) {
        for (const CheckReport& report : reports) {
            for (const judge::Answer& row : report.rows) {
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
