// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "report/check_report.hpp"

namespace gloam::report {
namespace {

constexpr std::string_view line = "{:<28} {:<38} {:<9} {:>9} {:>10} {:>10}  {}";

}  // namespace

std::size_t CheckReport::failures() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const CheckRow& row) { return !row.passed(); }));
}

std::string table_header() {
    return fmt::format(line, "equation", "function", "variant", "inputs", "worst ulp", "worst abs",
                       "verdict");
}

std::string table_line(const CheckRow& row) {
    if (!row.ran()) {
        return fmt::format(line, row.equation, row.function, row.variant, "-", "-", "-",
                           row.reason == Reason::error ? "could not run" : name_of(row.reason));
    }
    std::string verdict = row.passed() ? "ok" : fmt::format("{} outside", row.outside);
    if (!row.fault.empty()) verdict += ", reads outside its image";
    return fmt::format(line, row.equation, row.function, row.variant, row.inputs,
                       fmt::format("{:.3g}", row.max_ulp), fmt::format("{:.2e}", row.max_abs), verdict);
}

}  // namespace gloam::report
