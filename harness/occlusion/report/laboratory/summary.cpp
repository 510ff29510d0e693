// SPDX-License-Identifier: MIT
#include "report/laboratory/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gloam::report {
namespace {

constexpr std::size_t most_groups = 10'000;
constexpr std::size_t most_devices = 1'000;
constexpr std::size_t most_checks = 2'000'000;

void add(CheckTally& tally, const CheckTally& other) {
    tally.runs += other.runs;
    tally.failed += other.failed;
    tally.not_judged += other.not_judged;
    tally.inputs += other.inputs;
    tally.outside += other.outside;
    tally.worst = std::max(tally.worst, other.worst);
    tally.reasons.insert(other.reasons.begin(), other.reasons.end());
}

CheckTally tally_of(const ResultRow& row) {
    const bool failed = row.outcome == check::Outcome::failed;
    CheckTally tally{.runs = 1,
                     .failed = failed ? 1U : 0U,
                     .not_judged = row.outcome == check::Outcome::not_judged ? 1U : 0U,
                     .inputs = row.inputs,
                     .outside = row.outside,
                     .worst = row.fraction > 0.0 ? row.fraction : 0.0};
    if (failed && !row.reason.empty()) tally.reasons.insert(row.reason);
    return tally;
}

void require_at_most(std::size_t most, std::size_t found, const char* what) {
    if (found > most)
        throw std::runtime_error(fmt::format("more than {} {}: summarise fewer files at once", most, what));
}

}  // namespace

std::size_t GroupSummary::failing() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(checks, [](const auto& each) { return each.second.failed > 0; }));
}

std::size_t GroupSummary::not_judged() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        checks, [](const auto& each) { return each.second.not_judged == each.second.runs; }));
}

void LaboratorySummary::add_file(std::string_view text) {
    LaboratorySummary one;
    read_results(text, [&](const DeviceSummary& device, const ResultRow& row) {
        GroupSummary& group = one.groups_[group_of(device)];
        group.files = 1;
        group.devices.insert(device.name);
        add(group.checks[{row.equation, row.variant}], tally_of(row));
    });
    one.files_ = 1;
    merge(one);
}

void LaboratorySummary::merge(const LaboratorySummary& other) {
    for (const auto& [key, from] : other.groups_) {
        GroupSummary& group = groups_[key];
        group.files += from.files;
        group.devices.insert(from.devices.begin(), from.devices.end());
        for (const auto& [name, tally] : from.checks) add(group.checks[name], tally);
    }
    files_ += other.files_;
    require_bounds();
}

void LaboratorySummary::require_bounds() const {
    require_at_most(most_groups, groups_.size(), "groups of drivers");
    std::size_t checks = 0;
    for (const auto& [key, group] : groups_) {
        require_at_most(most_devices, group.devices.size(), "devices of one driver");
        checks += group.checks.size();
    }
    require_at_most(most_checks, checks, "checks");
}

}  // namespace gloam::report
