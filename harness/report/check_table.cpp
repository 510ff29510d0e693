// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "numeric/text.hpp"
#include "report/check_report.hpp"

namespace gloam::report {
namespace {

constexpr std::string_view line_format = "{:<28} {:<38} {:<14} {:>9} {:>10} {:>10} {:>8}  {:<7} {}";

}  // namespace

std::size_t CheckReport::failures() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const CheckRow& row) { return !row.passed(); }));
}

std::string table_header() {
    return fmt::format(line_format, "equation", "function", "variant", "inputs", "worst ulp", "worst abs",
                       "used", "by", "verdict");
}

std::string table_line(const CheckRow& row) {
    if (!row.ran()) {
        return fmt::format(line_format, row.equation, row.function, row.variant, "-", "-", "-", "-",
                           row.verdict, row.reason == Reason::error ? "could not run" : name_of(row.reason));
    }
    std::string verdict = row.passed() ? "ok" : fmt::format("{} outside", row.outside);
    if (!row.fault.empty()) verdict += ", reads outside its image";
    if (row.differs > 0) verdict += fmt::format(", {} differ from run time", row.differs);
    const double used = row.width_fraction.value_or(row.budget_fraction);
    return fmt::format(line_format, row.equation, row.function, row.variant, row.inputs,
                       fmt::format("{:.3g}", row.max_ulp), fmt::format("{:.2e}", row.max_abs),
                       numeric::to_short_text(used), row.verdict, verdict);
}

}  // namespace gloam::report
