// SPDX-License-Identifier: MIT
#include "report/check_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "report/accuracy.hpp"

namespace gloam::report {
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

}  // namespace

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

}  // namespace gloam::report
