// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/number.hpp"
#include "numeric/numbers.hpp"
#include "record/answer_json.hpp"
#include "record/check_report.hpp"

namespace gloam::record {
namespace {

struct Origin {
    judge::Answer row;
    std::string file;
};

// By equation, then variant; the row of a device that could not be opened comes last.
using Key = std::tuple<bool, std::string, std::string>;
using Rows = std::map<Key, Origin>;

Key key_of(const judge::Answer& row) {
    return {row.equation == "device", row.equation, row.variant};
}

auto severity(const judge::Answer& row) {
    const double share =
        row.inputs() == 0 ? 0.0 : static_cast<double>(row.outside()) / static_cast<double>(row.inputs());
    return std::tuple(row.failed(), !row.ran(), !row.fault.empty(), share, row.fraction_of_allowed());
}

bool tell_the_same(judge::Answer a, judge::Answer b) {
    a.seconds = b.seconds = 0.0;
    return line_of(a) == line_of(b);
}

std::string outcome(const judge::Answer& row) {
    if (!row.ran()) return std::string(name_of(row.reason));
    if (!row.fault.empty()) return "a fault";
    if (!row.failed() && !row.passed()) return "not judged";
    return fmt::format("{} of {} inputs outside, worst error {:.3g} of what is allowed", row.outside(),
                       row.inputs(), row.fraction_of_allowed());
}

void unite(Rows& rows, const judge::Answer& row, const ReportFile& from,
           std::vector<std::string>& conflicts) {
    const auto [at, is_new] = rows.try_emplace(key_of(row), Origin{row, from.file});
    Origin& known = at->second;
    if (is_new || tell_the_same(known.row, row)) return;
    conflicts.push_back(fmt::format("{} {} on {}: {} says {}; {} says {}; the worse is kept", row.equation,
                                    row.variant, name_of(from.report.device), known.file, outcome(known.row),
                                    from.file, outcome(row)));
    if (severity(row) > severity(known.row)) known = {row, from.file};
}

// Of a driver, the shards that no file has; empty: none.
std::string missing_shards(const CheckReport& report) {
    std::string missing;
    for (const std::string& shard : report.shards) {
        const std::string of = shard.substr(shard.find('/'));
        const auto count = base::number_from<std::size_t>(std::string_view(of).substr(1)).value_or(0);
        for (std::size_t i = 0; i < count && missing.empty(); ++i)
            if (!report.shards.contains(std::to_string(i) + of)) missing = std::to_string(i) + of;
    }
    return missing.empty() ? missing
                           : fmt::format("{}: no file has the shard {}", name_of(report.device), missing);
}

}  // namespace

MergedReports merge(const std::vector<ReportFile>& files) {
    MergedReports merged;
    std::map<std::string, std::size_t> places;  // of merged.reports, by what must be equal
    std::vector<Rows> rows;                     // of merged.reports
    for (const ReportFile& file : files) {
        const CheckReport& report = file.report;
        const auto [place, is_new] = places.try_emplace(
            fmt::format("{} {} {}", line_of(report.device), report.inputs, report.seed), rows.size());
        if (is_new) {
            merged.reports.push_back(
                {report.device, {}, report.versions, report.inputs, report.seed, report.shards});
            rows.emplace_back();
        }
        std::set<std::string>& shards = merged.reports[place->second].shards;
        if (shards.empty() || report.shards.empty())
            shards.clear();
        else
            shards.insert(report.shards.begin(), report.shards.end());
        for (const judge::Answer& row : report.rows) unite(rows[place->second], row, file, merged.conflicts);
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (auto& [key, origin] : rows[i]) merged.reports[i].rows.push_back(std::move(origin.row));
    for (const CheckReport& report : merged.reports)
        if (std::string line = missing_shards(report); !line.empty())
            merged.missing.push_back(std::move(line));
    return merged;
}

namespace {

// The run of the same device with the same inputs: of the same driver, otherwise of any.
const CheckReport* earlier_run(const std::vector<CheckReport>& before, const CheckReport& now) {
    const CheckReport* found = nullptr;
    for (const CheckReport& report : before) {
        if (report.device.name != now.device.name || report.device.type != now.device.type ||
            report.inputs != now.inputs || report.seed != now.seed)
            continue;
        if (report.device.driver == now.device.driver &&
            report.device.api_version == now.device.api_version &&
            report.device.manifest == now.device.manifest)
            return &report;
        found = &report;
    }
    return found;
}

bool exceeds(double larger, double smaller) {
    return larger > 1.1 * smaller && larger > smaller + 0.01;
}

// How a row differs from the earlier one, if it has one; empty: it does not.
std::string change_of(const judge::Answer* earlier, const judge::Answer& now) {
    if (now.failed() != (earlier != nullptr && earlier->failed()))
        return now.failed() ? "newly failed" : now.passed() ? "mended" : "no longer judged";
    if (earlier == nullptr) return "";
    const double error_before = earlier->fraction_of_allowed();
    const double error_now = now.fraction_of_allowed();
    const bool grew = exceeds(error_now, error_before);
    if (!grew && !exceeds(error_before, error_now)) return "";
    return fmt::format("the error {} from {} to {} of what is allowed", grew ? "grew" : "shrank",
                       numeric::to_short_text(error_before), numeric::to_short_text(error_now));
}

void compare(const CheckReport& before, const CheckReport& now, std::vector<std::string>& changes) {
    std::map<Key, const judge::Answer*> earlier;
    for (const judge::Answer& row : before.rows) earlier[key_of(row)] = &row;
    for (const judge::Answer& row : now.rows) {
        const auto known = earlier.extract(key_of(row));
        const std::string change = change_of(known ? known.mapped() : nullptr, row);
        if (!change.empty())
            changes.push_back(
                fmt::format("{} {} on {}: {}", row.equation, row.variant, name_of(now.device), change));
    }
    if (!earlier.empty())
        changes.push_back(
            fmt::format("{}: {} checks of the earlier run are missing", name_of(now.device), earlier.size()));
}

}  // namespace

std::vector<std::string> changes_since(const std::vector<CheckReport>& before,
                                       const std::vector<CheckReport>& now) {
    std::vector<std::string> changes;
    for (const CheckReport& report : now) {
        const CheckReport* earlier = earlier_run(before, report);
        const bool one_each = before.size() == 1 && now.size() == 1;
        if (earlier == nullptr && one_each && before[0].inputs == report.inputs &&
            before[0].seed == report.seed)
            earlier = before.data();  // another build may name its device otherwise
        if (earlier != nullptr)
            compare(*earlier, report, changes);
        else
            changes.push_back(fmt::format("{}: no earlier run has its {} inputs with seed {}",
                                          name_of(report.device), report.inputs, report.seed));
    }
    return changes;
}

}  // namespace gloam::record
