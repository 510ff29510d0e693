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
    if (!row.error.empty()) {
        return fmt::format(line, row.equation, row.result.function, row.variant, "-", "-", "-",
                           "could not run");
    }
    const check::Census& census = row.result.census;
    std::string verdict = row.passed() ? "ok" : fmt::format("{} outside", census.outside());
    if (row.result.fault) verdict += ", reads outside its image";
    return fmt::format(line, row.equation, row.result.function, row.variant, census.inputs(),
                       fmt::format("{:.3g}", census.max_ulp), fmt::format("{:.2e}", census.max_absolute),
                       verdict);
}

}  // namespace gloam::report
