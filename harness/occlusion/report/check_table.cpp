// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/numbers.hpp"
#include "report/check_report.hpp"

namespace gloam::report {
namespace {

// Widths of the longest ID, function and variant.
constexpr std::string_view line_format = "{:<21} {:<43} {:<14} {:>9} {:>10} {:>10} {:>10}  {:<9} {}";

// An error as text. Where the rules alone are the verdict, an infinite one may be right: for an overflow,
// say.
std::string error_text(const check::Answer& row, double error, int digits) {
    if (row.verdict == check::Verdict::rules && row.passed() && std::isinf(error)) return "permitted";
    return digits > 0 ? fmt::format("{:.{}e}", error, digits) : fmt::format("{:.3g}", error);
}

}  // namespace

std::size_t CheckReport::count(check::Outcome outcome) const {
    return static_cast<std::size_t>(std::ranges::count(rows, outcome, &check::Answer::outcome));
}

void OutcomeCounts::add(const OutcomeCounts& more) {
    checks += more.checks;
    failed += more.failed;
    not_judged += more.not_judged;
}

OutcomeCounts counts_of(const std::vector<CheckReport>& reports) {
    OutcomeCounts all;
    for (const CheckReport& report : reports)
        all.add({.checks = report.rows.size(),
                 .failed = report.count(check::Outcome::failed),
                 .not_judged = report.count(check::Outcome::not_judged)});
    return all;
}

int OutcomeCounts::exit_status() const {
    constexpr int could_not_run = 2;
    if (failed > 0) return 1;
    return checks > 0 && not_judged == checks ? could_not_run : 0;
}

std::string to_text(const OutcomeCounts& counts) {
    std::string text = fmt::format("{} checks, {} failed", counts.checks, counts.failed);
    return counts.not_judged == 0 ? text : text + fmt::format(", {} not judged", counts.not_judged);
}

std::string table_header() {
    return fmt::format(line_format, "equation", "function", "variant", "judged", "worst ulp", "worst abs",
                       "of allowed", "judged by", "verdict");
}

std::string table_legend() {
    return "judged: inputs for which some result would have failed\n"
           "worst ulp, worst abs: largest error, in units in the last place and absolute; permitted: it is "
           "infinite, and the rules permit that\n"
           "of allowed: the largest error as a fraction of what is allowed; more than 1 fails\n"
           "judged by: rules = what Vulkan's precision rules permit, budget = the accuracy that the function "
           "documents\n";
}

std::string verdict_of(const check::Answer& row) {
    if (!row.ran())
        return row.reason == check::Reason::error ? "could not run" : std::string(name_of(row.reason));
    std::string verdict =
        row.failed() ? fmt::format("{} outside", row.outside()) : std::string(name_of(row.outcome()));
    if (!row.fault.empty()) verdict += ", reads outside its image";
    if (row.differs > 0) verdict += fmt::format(", {} differ from run time", row.differs);
    return verdict;
}

std::string remark_on(const check::Answer& row) {
    const std::string why = row.not_judged_because();
    if (!why.empty() || !row.ran()) return why;
    std::string remark;
    if (row.open() > 0)
        remark = fmt::format("any result would pass for {} of {}", row.open(),
                             row.verdict == check::Verdict::rules ? row.bounded : row.inputs());
    std::string separator = remark.empty() ? "not promised: " : "; not promised: ";
    for (const check::InputClass input_class : row.not_promised()) {
        remark += separator + std::string(name_of(input_class));
        separator = ", ";
    }
    return remark;
}

std::string table_line(const check::Answer& row) {
    return table_line(row, verdict_of(row));
}

std::string table_line(const check::Answer& row, const std::string& verdict) {
    if (!row.ran()) {
        return fmt::format(line_format, row.equation, row.function, row.variant, "-", "-", "-", "-",
                           name_of(row.verdict), verdict);
    }
    const double used = row.fraction_of_allowed();
    const std::string remark = remark_on(row);
    return fmt::format(line_format, row.equation, row.function, row.variant, row.judged(),
                       error_text(row, row.max_ulp, 0), error_text(row, row.max_absolute, 2),
                       numeric::to_short_text(used), name_of(row.verdict), verdict) +
           (remark.empty() ? "" : "; " + remark);
}

}  // namespace gloam::report
