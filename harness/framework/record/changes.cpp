// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "numeric/numbers.hpp"
#include "record/check_report.hpp"

namespace gloam::record {
namespace {

using Row = std::pair<std::string, std::string>;  // equation and variant

// The run of the same device with the same inputs: of the same driver, otherwise of any.
const CheckReport* earlier_run(const std::vector<CheckReport>& before, const CheckReport& now) {
    const CheckReport* found = nullptr;
    for (const CheckReport& report : before) {
        if (report.device.name != now.device.name || report.device.type != now.device.type ||
            report.inputs != now.inputs || report.seed != now.seed)
            continue;
        if (report.device.driver == now.device.driver && report.device.api_version == now.device.api_version)
            return &report;
        found = &report;
    }
    return found;
}

bool exceeds(double larger, double smaller) {
    return larger > 1.1 * smaller && larger > smaller + 0.01;
}

// How a row differs from the earlier one, if it has one; empty: it does not.
std::string change_of(const check::Answer* earlier, const check::Answer& now) {
    const bool failed_before = earlier != nullptr && earlier->failed();
    if (now.failed() != failed_before) {
        if (now.failed()) return "newly failed";
        return now.passed() ? "mended" : "no longer judged";
    }
    if (earlier == nullptr) return "";
    const double error_before = earlier->fraction_of_allowed();
    const double error_now = now.fraction_of_allowed();
    const bool grew = exceeds(error_now, error_before);
    if (!grew && !exceeds(error_before, error_now)) return "";
    return fmt::format("the error {} from {} to {} of what is allowed", grew ? "grew" : "shrank",
                       numeric::to_short_text(error_before), numeric::to_short_text(error_now));
}

void compare(const CheckReport& before, const CheckReport& now, std::vector<std::string>& changes) {
    std::map<Row, const check::Answer*> earlier;
    for (const check::Answer& row : before.rows) earlier[{row.equation, row.variant}] = &row;
    for (const check::Answer& row : now.rows) {
        const auto known = earlier.find({row.equation, row.variant});
        const std::string change = change_of(known == earlier.end() ? nullptr : known->second, row);
        if (known != earlier.end()) earlier.erase(known);
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
        if (earlier == nullptr) {
            changes.push_back(fmt::format("{}: no earlier run has its {} inputs with seed {}",
                                          name_of(report.device), report.inputs, report.seed));
        } else {
            compare(*earlier, report, changes);
        }
    }
    return changes;
}

}  // namespace gloam::record
