// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/text.hpp"
#include "check/audit.hpp"
#include "numeric/numbers.hpp"

namespace gloam::check {
namespace {

constexpr double float_digits = 7.2;  // 24 bits
constexpr double half_digits = 3.3;   // 11 bits

std::string at(const std::string& file, unsigned line) {
    if (line == 0) return "in the kernel";
    return fmt::format("{}:{}", base::one_line(std::filesystem::path(file).filename().string()), line);
}

std::string at(const AuditPlace& place) {
    return fmt::format("{} ({})", at(place.file, place.line), place.operation);
}

std::string share_text(double share) {
    if (share == 0.0) return "for special values, or found by search";
    return fmt::format("{:.2g} % of random inputs", 100.0 * share);
}

std::string bounds_text(const numeric::Bounds& bounds) {
    if (bounds.is_anything()) return "anything";
    if (bounds.empty()) return "NaN";
    return fmt::format("{:.9g} to {:.9g}{}", bounds.low, bounds.high, bounds.nan ? ", or NaN" : "");
}

// "NaN", "infinity", "0.25 instead of 0.5".
std::string result_text(const AuditFinding& finding) {
    switch (finding.concern) {
        case Concern::fault:
            return base::one_line(finding.message);
        case Concern::not_finite:
            return fmt::format(
                "{:.9g}{}", finding.value,
                std::isfinite(finding.exact) ? fmt::format(", exactly {:.9g}", finding.exact) : "");
        case Concern::undefined:
        case Concern::unspecified:
            return fmt::format("{:.9g} here, Vulkan permits {}", finding.value,
                               bounds_text(finding.permitted));
        case Concern::digits:
            return fmt::format("{:.9g}, exactly {:.9g}", finding.value, finding.exact);
        default:
            return bounds_text(finding.permitted);
    }
}

std::string heading_of(const AuditFinding& finding) {
    if (finding.concern < Concern::digits) return share_text(finding.share);
    return fmt::format("{} {:.1f} of {} digits", finding.concern == Concern::digits ? "up to" : "by",
                       std::min(finding.lost, float_digits), float_digits);
}

std::string origin_text(const AuditFinding& finding) {
    if (finding.place.file.empty()) return {};
    const char* const how = finding.concern == Concern::digits && finding.cancels ? ", cancellation" : "";
    return fmt::format("\n      arises at {}{}", at(finding.place), how);
}

std::string finding_text(const AuditFinding& finding) {
    return fmt::format("  {:<15} {}\n      for {}: {}{}\n", name_of(finding.concern), heading_of(finding),
                       finding.values, result_text(finding), origin_text(finding));
}

std::string output_text(const Audit& audit, std::size_t output) {
    const bool several =
        std::ranges::any_of(audit.motions, [](const AuditMotion& m) { return m.output > 0; });
    return several ? fmt::format(" (result {})", output) : "";
}

std::string motion_text(const Audit& audit, const AuditMotion& motion) {
    std::string text = motion.parameter + output_text(audit, motion.output) + ": ";
    switch (motion.kind) {
        case AuditMotion::Kind::constant:
            return text + "no effect";
        case AuditMotion::Kind::rising:
        case AuditMotion::Kind::falling:
            text += motion.kind == AuditMotion::Kind::rising ? "rises" : "falls";
            if (motion.backward > 1.0)
                text += fmt::format(", but goes back by up to {:.3g} ULP from one float to the next",
                                    motion.backward);
            return text;
        case AuditMotion::Kind::turning:
            if (motion.words.empty()) return text + "rises or falls, as the other parameters are";
            return text +
                   fmt::format("turns at {:.6g}, where the result is {:.6g}", motion.at, motion.before);
        default:
            return text + fmt::format("jumps at {:.9g} from {:.6g} to {:.6g}{}", motion.at, motion.before,
                                      motion.behind,
                                      motion.line == 0 ? "" : ", at " + at(motion.file, motion.line));
    }
}

std::string half_text(const AuditFinding& half) {
    if (std::isinf(half.lost)) return fmt::format("overflows for {} at {}", half.values, at(half.place));
    if (half.lost < 0.5) return "loses little beyond its rounding";
    return fmt::format("{:.4g} instead of {:.4g} for {} ({:.1f} of {} digits lost, most at {})", half.value,
                       half.exact, half.values, std::min(half.lost, half_digits), half_digits,
                       at(half.place));
}

std::string missed_text(const Coverage& coverage) {
    std::string text;
    for (const Coverage::Point& point : coverage.points)
        if (!point.reached)
            text += fmt::format("  {:<15} {}: {}{}\n", "not reached", at(point.file, point.line),
                                point.way.empty() ? "" : "never " + point.way + ": ", point.text);
    return text;
}

}  // namespace

std::string to_text(const Audit& audit) {
    std::string text = fmt::format("{}: {}\n", audit.file, audit.declaration);
    for (const OrdinaryValues& values : audit.domain)
        text += fmt::format("  {:<15} {} ({})\n", values.parameter, values.text, values.reason);
    text += fmt::format("  {:<15} {}, of these {} random\n", "inputs", audit.inputs, audit.random);
    for (const AuditFinding& finding : audit.findings) text += finding_text(finding);
    for (const AuditMotion& motion : audit.motions)
        text += fmt::format("  {:<15} {}\n", "motion", motion_text(audit, motion));
    text += missed_text(audit.coverage);
    if (audit.half) text += fmt::format("  {:<15} {}\n", "half precision", half_text(*audit.half));
    for (const AuditRewrite& rewrite : audit.rewrites)
        text +=
            fmt::format("  {:<15} {}: {} -> {}\n      {}: {}\n", "rewrite", at(rewrite.file, rewrite.line),
                        rewrite.before, rewrite.after, rewrite.reason, rewrite.gain);
    if (audit.findings.empty())
        text += fmt::format(
            "  {:<15} no input gives NaN, infinity or an undefined result, and none loses digits\n", "well");
    return text;
}

}  // namespace gloam::check
