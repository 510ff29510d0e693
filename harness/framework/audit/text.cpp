// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string_view>

#include "audit/audit.hpp"
#include "base/text.hpp"
#include "numeric/numbers.hpp"

namespace gloam::audit {
namespace {

std::string at(const std::string& file, unsigned line) {
    if (line == 0) return "in the kernel";
    return fmt::format("{}:{}", base::one_line(std::filesystem::path(file).filename().string()), line);
}

std::string number(double x) {
    return std::isnan(x) ? "NaN" : fmt::format("{:.9g}", x);
}

// Names in SPIR-V, and what the source has where that is another one.
constexpr const char* operators =
    "OpFAdd + OpFSub - OpFMul * OpVectorTimesScalar * OpFDiv / OpFMod mod OpDot dot OpFOrdLessThan < "
    "OpFOrdGreaterThan > OpFOrdLessThanEqual <= OpFOrdGreaterThanEqual >= OpFOrdEqual == OpFOrdNotEqual != "
    "OpFUnordNotEqual != OpConvertFToS int OpConvertFToU uint Atan2 atan MatrixInverse inverse";

// "acos", "-": as the source has it, or the name in SPIR-V.
std::string operation_text(const std::string& operation) {
    constexpr std::string_view set = "GLSL.std.450 ";
    const bool extended = operation.starts_with(set);
    std::string name = extended ? operation.substr(set.size()) : operation;
    std::istringstream pairs(operators);
    for (std::string known, text; pairs >> known >> text;)
        if (known == name) return text;
    if (!extended) return operation;
    const auto is_upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
    if (name.size() > 1 && name[0] == 'F' && is_upper(name[1])) name.erase(0, 1);  // FMix
    return base::lower(name);
}

std::string bounds_text(const numeric::Bounds& bounds) {
    if (bounds.is_anything()) return "anything";
    if (bounds.empty()) return "NaN";
    return fmt::format("{} to {}{}", number(bounds.low), number(bounds.high), bounds.nan ? ", or NaN" : "");
}

// Why a result has fewer digits than its operands.
std::string loss_text(const AuditFinding& finding) {
    if (!finding.cancels) return {};
    const std::string& operation = finding.place.operation;
    return operation == "OpFSub" || operation == "OpFAdd" ? ", cancellation"
                                                          : ", which magnifies the error of its operands";
}

std::string finding_text(const AuditFinding& finding) {
    const std::string place = to_text(finding.place);
    std::string remarks;
    for (const std::string& remark : remarks_on(finding)) remarks += "\n      " + remark;
    return fmt::format("  {:<15} {}\n     {} {}{}{}\n", name_of(finding.concern), extent_text(finding),
                       finding.values.empty() ? "" : " for " + finding.values + ":", result_text(finding),
                       place.empty() ? "" : "\n      arises at " + place + loss_text(finding), remarks);
}

std::string rewrite_text(const AuditRewrite& rewrite) {
    std::string helper = rewrite.helper;
    if (!helper.empty()) {
        helper.pop_back();  // the end of its last line
        helper = "      with " + base::replaced(std::move(helper), "\n", "\n           ") + "\n";
    }
    return fmt::format("  {:<15} {}: {} -> {}\n{}      {}: {}\n", "rewrite", at(rewrite.file, rewrite.line),
                       rewrite.before, rewrite.after, helper, rewrite.reason, rewrite.gain);
}

}  // namespace

std::string to_text(const AuditLocation& place) {
    if (place.file.empty()) return {};
    return fmt::format("{} ({})", at(place.file, place.line), operation_text(place.operation));
}

std::vector<std::string> remarks_on(const AuditFinding& finding) {
    std::vector<std::string> remarks;
    if (!finding.reservation.empty()) remarks.push_back(finding.reservation);
    for (const AuditWitness& witness : finding.witnesses)
        remarks.push_back(fmt::format("{} on {}", number(witness.value), base::one_line(witness.device)));
    return remarks;
}

std::string result_text(const AuditFinding& finding) {
    switch (finding.concern) {
        case Concern::fault:
            return base::one_line(finding.message);
        case Concern::is_false:
            return "it must hold";
        case Concern::not_finite:
            return fmt::format("{}{}", number(finding.value),
                               std::isfinite(finding.exact) ? ", exactly " + number(finding.exact) : "");
        case Concern::undefined:
            if (finding.permitted.is_anything()) return "Vulkan permits any value";
            [[fallthrough]];
        case Concern::unspecified:
            return fmt::format("{} here, Vulkan permits {}", number(finding.value),
                               bounds_text(finding.permitted));
        case Concern::parting:
            return fmt::format("{}, {} {}", number(finding.value), finding.message,
                               std::isnan(finding.exact) ? "a fault" : number(finding.exact));
        case Concern::digits:
            return fmt::format("{}, exactly {}", number(finding.value), number(finding.exact));
        default:
            return bounds_text(finding.permitted);
    }
}

std::string extent_text(const AuditFinding& finding) {
    if (finding.concern < Concern::digits)
        return finding.share == 0.0 ? "for special values, or found by search"
                                    : fmt::format("{:.3g} % of random inputs", 100.0 * finding.share);
    return fmt::format("{} {:.1f} of {} digits", finding.concern == Concern::digits ? "up to" : "by",
                       std::min(finding.lost, float_digits), float_digits);
}

std::vector<std::string> missed(const judge::Coverage& coverage) {
    std::vector<std::string> all;
    for (const judge::Coverage::Point& point : coverage.points)
        if (!point.reached)
            all.push_back(fmt::format("{}: {}{}", at(point.file, point.line),
                                      point.way.empty() ? "" : "never " + point.way + ": ", point.text));
    return all;
}

std::string to_text(const Audit& audit) {
    std::string text = fmt::format("{}: {}\n", audit.file, audit.declaration);
    const auto line = [&text](const std::string& title, const std::string& rest) {
        text += fmt::format("  {:<15} {}\n", title, rest);
    };
    for (const OrdinaryValues& values : audit.domain)
        line(values.parameter, fmt::format("{} ({})", values.text, values.reason));
    line("inputs", fmt::format("{}: {} at random, the others with special values or by search", audit.inputs,
                               audit.random));
    for (const AuditFinding& finding : audit.findings) text += finding_text(finding);
    if (!audit.was_run())
        line("not audited",
             audit.inputs == 0
                 ? "no input could be run; --inputs N draws more"
                 : fmt::format("each of the {} inputs takes more than {} instructions; --range NAME=LOW:HIGH "
                               "limits them to those that the function is made for",
                               audit.inputs, most_audited_instructions));
    else if (audit.findings.empty())
        line("well", "no input gives NaN, infinity or an undefined result, and none loses digits");
    for (const std::string& way : missed(audit.coverage)) line("not reached", way);
    for (const AuditRewrite& rewrite : audit.rewrites) text += rewrite_text(rewrite);
    return text;
}

std::ostream& operator<<(std::ostream& stream, const Audit& audit) {
    return stream << to_text(audit);
}

}  // namespace gloam::audit
