// SPDX-License-Identifier: MIT
#include "report/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
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

// A change. `before` and `now`: the versions of two builds, or worst errors; empty: there is nothing to say.
struct Change {
    const char* kind;
    std::string check;
    std::string driver;
    std::string before{};
    std::string now{};
};

// All changes, those of a kind beside each other, the worst kind first.
std::vector<Change> changes_of(const News& news) {
    std::vector<Change> all;
    const auto add_errors = [&all](const char* kind, const std::vector<CheckChange>& changes) {
        for (const CheckChange& each : changes)
            all.push_back({kind, name_of(each.check), name_of(each.now),
                           numeric::to_short_text(each.worst_before),
                           numeric::to_short_text(each.worst_now)});
    };
    for (const CheckChange& each : news.newly_failed)
        all.push_back({"newly failed", name_of(each.check), name_of(each.now)});
    add_errors("errors that grew", news.grew);
    for (const CheckChange& each : news.mended)
        all.push_back({"mended", name_of(each.check), name_of(each.now)});
    add_errors("errors that shrank", news.shrank);
    for (const auto& [before, now] : news.builds)
        all.push_back({"new builds", "", name_of(now), before.version, now.version});
    for (const DriverGroup& group : news.new_groups) all.push_back({"new drivers", "", name_of(group)});
    for (const DriverGroup& group : news.missing_groups)
        all.push_back({"no longer reported", "", name_of(group)});
    return all;
}

// "3 mended: EQ-1 strict on radv Mesa 23.1, Vulkan 1.3, ...": a line for each kind of change.
std::string text_of(const std::vector<Change>& changes) {
    if (changes.empty()) return "nothing is new\n";
    std::string text;
    for (auto first = changes.begin(); first != changes.end();) {
        std::vector<std::string> names;
        auto each = first;
        for (; each != changes.end() && std::string_view(each->kind) == first->kind; ++each) {
            names.push_back(each->check.empty() ? each->driver : each->check + " on " + each->driver);
            if (!each->now.empty()) names.back() += fmt::format(" ({} -> {})", each->before, each->now);
        }
        text += fmt::format("{} {}: {}\n", names.size(), first->kind, some(names));
        first = each;
    }
    return text;
}

PageTable change_table(const std::vector<Change>& changes) {
    PageTable table{.columns = {{.title = "change", .filter = true},
                                {.title = "check"},
                                {.title = "driver"},
                                {.title = "before", .meaning = "version, or worst error of what is allowed"},
                                {.title = "now"}},
                    .rows = {}};
    for (const Change& each : changes)
        table.rows.push_back({{.text = each.kind},
                              {.text = each.check},
                              {.text = each.driver},
                              {.text = each.before},
                              {.text = each.now}});
    return table;
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
    return text + "\n" + text_of(changes_of(*news));
}

std::string to_summary_page(const LaboratorySummary& summary, const std::optional<News>& news,
                            const std::vector<std::string>& rejected) {
    Page page("Checks of many machines");
    page.paragraph(headline(summary) + ".");
    for (const std::string& line : rejected) page.paragraph(line);
    if (news) {
        page.heading("What is new");
        if (const auto changes = changes_of(*news); changes.empty()) {
            page.paragraph("Nothing.");
        } else {
            page.table(change_table(changes));
        }
    }
    page.heading("Drivers");
    page.table(group_table(summary));
    page.heading("Failed checks");
    page.table(failure_table(summary));
    return page.html();
}

}  // namespace gloam::report
