// SPDX-License-Identifier: MIT
#include "report/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "numeric/numbers.hpp"
#include "report/page.hpp"

namespace gloam::report {
namespace {

constexpr std::size_t most_named = 10;
constexpr std::size_t most_listed = 40;  // drivers; of more, only those with failures are listed

std::string name_of(const CheckName& check) {
    return check.second.empty() ? check.first : check.first + " " + check.second;
}

std::string line_of(const CheckChange& each) {
    return fmt::format("{} on {}", name_of(each.check), name_of(each.now));
}

std::string line_of_error(const CheckChange& each) {
    return fmt::format("{}: {} -> {} of what is allowed", line_of(each),
                       numeric::to_short_text(each.worst_before), numeric::to_short_text(each.worst_now));
}

// At most ten of them, and how many more there are.
std::string some(const std::vector<std::string>& names) {
    const std::size_t shown = std::min(names.size(), most_named);
    std::string text =
        fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<long>(shown), ", "));
    return names.size() > shown ? text + fmt::format(" and {} more", names.size() - shown) : text;
}

std::vector<std::string> failing_names(const GroupSummary& group) {
    std::vector<std::string> names;
    for (const auto& [name, tally] : group.checks)
        if (tally.failed > 0) names.push_back(name_of(name));
    return names;
}

// The changes, each kind with its lines; empty kinds are left out.
std::vector<std::pair<std::string, std::vector<std::string>>> kinds_of(const News& news) {
    std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
    const auto add = [&kinds](const char* kind, const auto& items, const auto& line) {
        auto& lines = kinds.emplace_back(kind, std::vector<std::string>{}).second;
        std::ranges::transform(items, std::back_inserter(lines), line);
    };
    const auto name = [](const DriverGroup& group) { return name_of(group); };
    add("new drivers", news.new_groups, name);
    add("new builds", news.builds, [](const auto& each) {
        return fmt::format("{}, compared with {}", name_of(each.second), name_of(each.first));
    });
    add("newly failed", news.newly_failed, line_of);
    add("mended", news.mended, line_of);
    add("errors that grew", news.grew, line_of_error);
    add("errors that shrank", news.shrank, line_of_error);
    add("no longer reported", news.missing_groups, name);
    std::erase_if(kinds, [](const auto& kind) { return kind.second.empty(); });
    return kinds;
}

OutcomeCounts counts_of(const GroupSummary& group) {
    return {.checks = group.checks.size(), .failed = group.failing(), .not_judged = group.not_judged()};
}

std::string headline(const LaboratorySummary& summary) {
    OutcomeCounts all;
    for (const auto& [key, group] : summary) all.add(counts_of(group));
    return fmt::format("{} drivers, {}", summary.size(), to_text(all));
}

PageTable group_table(const LaboratorySummary& summary) {
    PageTable table{
        .columns = {{.title = "vendor", .filter = true},
                    {.title = "driver", .filter = true},
                    {.title = "version"},
                    {.title = "API", .filter = true},
                    {.title = "devices", .meaning = "different names of devices", .numeric = true},
                    {.title = "runs", .meaning = "of a device, versions, inputs and a seed", .numeric = true},
                    {.title = "checks", .meaning = "equations in variants", .numeric = true},
                    {.title = "failed",
                     .meaning = "checks that failed on one machine at least",
                     .numeric = true},
                    {.title = "not judged", .meaning = "checks that no machine judged", .numeric = true}},
        .rows = {}};
    for (const auto& [key, group] : summary) {
        const auto count = [](std::size_t n) {
            return number_cell(static_cast<double>(n), std::to_string(n));
        };
        PageCell failed = count(group.failing());
        failed.tone = group.failing() > 0 ? Tone::bad : Tone::good;
        table.rows.push_back({{.text = key.vendor},
                              {.text = key.driver},
                              {.text = key.version},
                              {.text = key.api},
                              count(group.devices.size()),
                              count(group.runs),
                              count(group.checks.size()),
                              failed,
                              count(group.not_judged())});
    }
    std::ranges::stable_sort(table.rows, std::ranges::greater{}, [](const std::vector<PageCell>& row) {
        return row.rbegin()[1].value.value_or(0.0);
    });
    return table;
}

PageTable failure_table(const LaboratorySummary& summary) {
    PageTable table{
        .columns = {{.title = "equation"},
                    {.title = "variant", .filter = true},
                    {.title = "vendor", .filter = true},
                    {.title = "driver"},
                    {.title = "runs failed", .meaning = "of all runs of this check with this driver"},
                    {.title = "inputs outside", .numeric = true},
                    {.title = "worst",
                     .meaning = "largest error as a fraction of what is allowed",
                     .numeric = true},
                    {.title = "why it did not run"}},
        .rows = {}};
    for (const auto& [key, group] : summary) {
        for (const auto& [name, tally] : group.checks) {
            if (tally.failed == 0) continue;
            table.rows.push_back(
                {{.text = name.first},
                 {.text = name.second},
                 {.text = key.vendor},
                 {.text = name_of(key)},
                 {.text = fmt::format("{} of {}", tally.failed, tally.runs), .tone = Tone::bad},
                 number_cell(static_cast<double>(tally.outside),
                             fmt::format("{} of {}", tally.outside, tally.inputs)),
                 number_cell(tally.worst, numeric::to_short_text(tally.worst)),
                 {.text = tally.reasons}});
        }
    }
    return table;
}

}  // namespace

std::string to_summary_text(const LaboratorySummary& summary, const std::optional<News>& news) {
    std::string text = headline(summary) + "\n\n";
    const bool all = summary.size() <= most_listed;
    std::size_t passed = 0;
    for (const auto& [key, group] : summary) {
        if (!all && group.failing() == 0) {
            ++passed;
            continue;
        }
        text += fmt::format("{}: {}: {} runs, {} devices, {}", key.vendor, name_of(key), group.runs,
                            group.devices.size(), to_text(counts_of(group)));
        text += group.failing() > 0 ? " (" + some(failing_names(group)) + ")\n" : "\n";
    }
    if (passed > 0) text += fmt::format("{} other drivers failed no check\n", passed);
    if (!news) return text;
    const auto kinds = kinds_of(*news);
    text += kinds.empty() ? "\nnothing is new\n" : "\n";
    for (const auto& [kind, lines] : kinds)
        text += fmt::format("{} {}: {}\n", lines.size(), kind, some(lines));
    return text;
}

std::string to_summary_page(const LaboratorySummary& summary, const std::optional<News>& news,
                            const std::vector<std::string>& rejected) {
    Page page("Checks of many machines");
    page.paragraph(headline(summary) + ".");
    for (const std::string& line : rejected) page.paragraph(line);
    if (news) {
        page.heading("What is new");
        if (kinds_of(*news).empty()) page.paragraph("Nothing.");
        for (const auto& [kind, lines] : kinds_of(*news))
            page.paragraph(fmt::format("{} {}: {}", lines.size(), kind, fmt::join(lines, "; ")));
    }
    page.heading("Drivers");
    page.table(group_table(summary));
    page.heading("Failed checks");
    page.table(failure_table(summary));
    return page.html();
}

}  // namespace gloam::report
