// SPDX-License-Identifier: MIT
#include "report/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace gloam::report {
namespace {

struct Origin {
    check::Answer row;
    std::string file;
};

// By equation, then variant; the row of a device that could not be opened comes last.
using Key = std::tuple<bool, std::string, std::string>;
using Rows = std::map<Key, Origin>;

Key key_of(const check::Answer& row) {
    return {row.equation == "device", row.equation, row.variant};
}

auto severity(const check::Answer& row) {
    const double share =
        row.inputs() == 0 ? 0.0 : static_cast<double>(row.outside()) / static_cast<double>(row.inputs());
    return std::tuple(row.failed(), !row.ran(), !row.fault.empty(), share, row.fraction_of_allowed());
}

bool tell_the_same(check::Answer a, check::Answer b) {
    a.seconds = b.seconds = 0.0;
    return to_json(a) == to_json(b);
}

std::string outcome(const check::Answer& row) {
    if (!row.ran()) return std::string(name_of(row.reason));
    if (!row.fault.empty()) return "a fault";
    if (!row.failed() && !row.passed()) return "not judged";
    return fmt::format("{} of {} inputs outside, worst error {:.3g} of what is allowed", row.outside(),
                       row.inputs(), row.fraction_of_allowed());
}

void unite(Rows& rows, const check::Answer& row, const ReportFile& from,
           std::vector<std::string>& conflicts) {
    const auto [at, is_new] = rows.try_emplace(key_of(row), Origin{row, from.file});
    Origin& known = at->second;
    if (is_new || tell_the_same(known.row, row)) return;
    conflicts.push_back(fmt::format("{} {} on {}: {} says {}; {} says {}; the worse is kept", row.equation,
                                    row.variant, name_of(from.report.device), known.file, outcome(known.row),
                                    from.file, outcome(row)));
    if (severity(row) > severity(known.row)) known = {row, from.file};
}

}  // namespace

MergedReports merge(const std::vector<ReportFile>& files) {
    MergedReports merged;
    std::vector<Rows> rows;  // of merged.reports
    for (const ReportFile& file : files) {
        const std::string device = to_json(file.report.device);
        const auto known = std::ranges::find(
            merged.reports, device, [](const CheckReport& report) { return to_json(report.device); });
        const auto index = static_cast<std::size_t>(known - merged.reports.begin());
        if (known == merged.reports.end()) {
            merged.reports.push_back(
                {.device = file.report.device, .rows = {}, .versions = file.report.versions});
            rows.emplace_back();
        }
        for (const check::Answer& row : file.report.rows) unite(rows[index], row, file, merged.conflicts);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (auto& [key, origin] : rows[i]) merged.reports[i].rows.push_back(std::move(origin.row));
    }
    return merged;
}

}  // namespace gloam::report
