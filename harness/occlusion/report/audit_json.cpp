// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "report/audit_report.hpp"
#include "report/internal/json_fields.hpp"

namespace gloam::report {
namespace {

using nlohmann::ordered_json;

ordered_json place_json(const check::AuditPlace& place) {
    return {{"file", place.file},
            {"line", place.line},
            {"function", place.function},
            {"operation", place.operation}};
}

ordered_json finding_json(const check::AuditFinding& finding) {
    ordered_json json{{"concern", name_of(finding.concern)},
                      {"share", internal::number_json(finding.share)},
                      {"input", finding.values},
                      {"words", finding.words},
                      {"output", finding.output},
                      {"value", internal::number_json(finding.value)},
                      {"exact", internal::number_json(finding.exact)},
                      {"permitted",
                       {{"low", internal::number_json(finding.permitted.low)},
                        {"high", internal::number_json(finding.permitted.high)},
                        {"nan", finding.permitted.nan}}},
                      {"digits_lost", internal::number_json(finding.lost)},
                      {"place", place_json(finding.place)}};
    if (!finding.message.empty()) json["message"] = finding.message;
    for (const check::AuditWitness& witness : finding.witnesses)
        json["devices"].push_back(
            {{"device", witness.device}, {"value", internal::number_json(witness.value)}});
    return json;
}

ordered_json motion_json(const check::AuditMotion& motion) {
    return {{"parameter", motion.parameter},
            {"output", motion.output},
            {"motion", to_text(motion)},
            {"input", motion.values},
            {"words", motion.words}};
}

ordered_json audit_json(const check::Audit& audit) {
    ordered_json json{{"function", audit.function},
                      {"declaration", audit.declaration},
                      {"inputs", audit.inputs},
                      {"random", audit.random},
                      {"broken", audit.is_broken()}};
    for (const char* list : {"domain", "findings", "motions", "not_reached", "lines", "rewrites"})
        json[list] = ordered_json::array();
    for (const check::OrdinaryValues& values : audit.domain)
        json["domain"].push_back(
            {{"parameter", values.parameter}, {"values", values.text}, {"reason", values.reason}});
    for (const check::AuditFinding& finding : audit.findings)
        json["findings"].push_back(finding_json(finding));
    for (const check::AuditMotion& motion : audit.motions) json["motions"].push_back(motion_json(motion));
    json["not_reached"] = missed(audit.coverage);
    for (const check::AuditLine& line : audit.lines)
        json["lines"].push_back({{"file", line.file},
                                 {"line", line.line},
                                 {"digits_lost", internal::number_json(line.lost)},
                                 {"half_digits_lost", internal::number_json(line.lost_half)}});
    if (audit.half) json["half"] = finding_json(*audit.half);
    for (const check::AuditRewrite& rewrite : audit.rewrites)
        json["rewrites"].push_back({{"file", rewrite.file},
                                    {"line", rewrite.line},
                                    {"before", rewrite.before},
                                    {"after", rewrite.after},
                                    {"helper", rewrite.helper},
                                    {"reason", rewrite.reason},
                                    {"gain", rewrite.gain}});
    return json;
}

}  // namespace

std::string to_audit_json(const AuditReport& report) {
    ordered_json json{
        {"gloam", base::version()}, {"file", report.file}, {"functions", ordered_json::array()}};
    for (const check::Audit& audit : report.audits) json["functions"].push_back(audit_json(audit));
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gloam::report
