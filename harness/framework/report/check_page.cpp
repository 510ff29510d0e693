// SPDX-License-Identifier: MIT
#include "report/check_page.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "numeric/numbers.hpp"
#include "report/accuracy.hpp"

namespace gloam::report {
namespace {

constexpr std::size_t longest_value = 400;     // bytes of a cell
constexpr std::size_t longest_story = 12'000;  // bytes of a failure's story
constexpr std::size_t most_stories = 100;
constexpr int device_column = 3;  // if there are several devices

std::vector<PageColumn> columns(bool several_devices) {
    std::vector<PageColumn> all{
        {.title = "verdict",
         .meaning = "ok, the number of inputs outside what is allowed, not judged, or why it did not run"},
        {.title = "equation"},
        {.title = "function"},
        {.title = "variant", .meaning = "how the shader was compiled", .filter = true},
        {.title = "judged by",
         .meaning =
             "rules: what Vulkan's precision rules permit. budget: the accuracy that the function documents",
         .filter = true},
        {.title = "judged", .meaning = "inputs for which some result would have failed", .numeric = true},
        {.title = "worst ULP",
         .meaning = "largest error in units in the last place of the printed equation in double precision",
         .numeric = true},
        {.title = "worst absolute", .numeric = true},
        {.title = "of allowed",
         .meaning = "the largest error as a fraction of what is allowed; more than 1 fails",
         .numeric = true},
        {.title = "remark", .meaning = "why it was not judged, or what the verdict says nothing of"},
        {.title = "worst input", .meaning = "the input with the largest error"}};
    if (several_devices) all.insert(all.begin() + device_column, {.title = "device", .filter = true});
    return all;
}

PageCell verdict_cell(const check::Answer& row) {
    const Tone tone = row.passed() ? Tone::good : row.failed() ? Tone::bad : Tone::plain;
    return {.text = verdict_of(row), .tone = tone};
}

// The cells of a row, without the device.
std::vector<PageCell> cells_of(const check::Answer& row) {
    std::vector<PageCell> cells{verdict_cell(row),
                                {row.equation},
                                {row.function},
                                {row.variant},
                                {row.ran() ? std::string(name_of(row.verdict)) : "-"}};
    if (!row.ran()) {
        cells.insert(cells.end(), 4, {"-"});
        cells.push_back({base::shortened(remark_on(row), longest_value)});
        cells.push_back({base::shortened(row.error, longest_value)});
        return cells;
    }
    const double used = row.fraction_of_allowed();
    cells.push_back(number_cell(static_cast<double>(row.judged()), fmt::format("{}", row.judged())));
    cells.push_back(number_cell(row.max_ulp, fmt::format("{:.3g}", row.max_ulp)));
    cells.push_back(number_cell(row.max_absolute, fmt::format("{:.2e}", row.max_absolute)));
    cells.push_back(number_cell(used, numeric::to_short_text(used)));
    cells.push_back({remark_on(row)});
    cells.push_back({row.worst ? base::shortened(row.worst->values, longest_value) : "-"});
    return cells;
}

PageTable device_table(const std::vector<CheckReport>& reports) {
    PageTable table{.columns = {{.title = "device"},
                                {.title = "interface"},
                                {.title = "checks", .numeric = true},
                                {.title = "failed", .numeric = true},
                                {.title = "not judged", .numeric = true},
                                {.title = "made by", .meaning = "versions of gloam and of the compilers"}},
                    .rows = {}};
    for (const CheckReport& report : reports) {
        const auto count = [&](check::Outcome outcome) {
            return number_cell(static_cast<double>(report.count(outcome)),
                               fmt::format("{}", report.count(outcome)));
        };
        PageCell failed = count(check::Outcome::failed);
        failed.tone = report.count(check::Outcome::failed) == 0 ? Tone::good : Tone::bad;
        table.rows.push_back(
            {{name_of(report.device)},
             {api_of(report.device)},
             number_cell(static_cast<double>(report.rows.size()), fmt::format("{}", report.rows.size())),
             failed,
             count(check::Outcome::not_judged),
             {report.versions}});
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

PageTable check_table(const std::vector<CheckReport>& reports) {
    const bool several = reports.size() > 1;
    PageTable table{.columns = columns(several), .rows = {}};
    for (const auto outcome : {check::Outcome::failed, check::Outcome::not_judged, check::Outcome::ok}) {
        for (const CheckReport& report : reports) {
            for (const check::Answer& row : report.rows) {
                if (row.outcome() != outcome) continue;
                table.rows.push_back(cells_of(row));
                std::vector<PageCell>& cells = table.rows.back();
                if (several) cells.insert(cells.begin() + device_column, {name_of(report.device)});
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
