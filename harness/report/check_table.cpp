// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "numeric/text.hpp"
#include "report/check_report.hpp"

namespace gloam::report {
namespace {

// Widths of the longest ID, function and variant.
constexpr std::string_view line_format = "{:<21} {:<43} {:<14} {:>9} {:>10} {:>10} {:>10}  {:<9} {}";

}  // namespace

std::size_t CheckReport::failures() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const check::Answer& row) { return !row.passed(); }));
}

std::string table_header() {
    return fmt::format(line_format, "equation", "function", "variant", "inputs", "worst ulp", "worst abs",
                       "of allowed", "judged by", "verdict");
}

std::string table_legend() {
    return "worst ulp, worst abs: largest error, in units in the last place and absolute\n"
           "of allowed: the largest error as a fraction of what is allowed; more than 1 fails\n"
           "judged by: rules = what Vulkan's precision rules permit, budget = the accuracy that the function "
           "documents\n";
}

std::string verdict_of(const check::Answer& row) {
    if (!row.ran())
        return row.reason == check::Reason::error ? "could not run" : std::string(name_of(row.reason));
    if (row.recorded_only() && row.passed()) return "not judged";
    std::string verdict = row.passed() ? "ok" : fmt::format("{} outside", row.outside());
    if (!row.fault.empty()) verdict += ", reads outside its image";
    if (row.differs > 0) verdict += fmt::format(", {} differ from run time", row.differs);
    return verdict;
}

std::string table_line(const check::Answer& row) {
    if (!row.ran()) {
        return fmt::format(line_format, row.equation, row.function, row.variant, "-", "-", "-", "-",
                           name_of(row.verdict), verdict_of(row));
    }
    const double used = row.fraction_of_allowed();
    return fmt::format(line_format, row.equation, row.function, row.variant, row.inputs(),
                       fmt::format("{:.3g}", row.max_ulp), fmt::format("{:.2e}", row.max_absolute),
                       numeric::to_short_text(used), name_of(row.verdict), verdict_of(row));
}

}  // namespace gloam::report
