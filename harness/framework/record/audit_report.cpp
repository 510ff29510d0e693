// SPDX-License-Identifier: MIT
#include "record/audit_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/version.hpp"
#include "record/answer_json.hpp"
#include "record/page.hpp"

namespace gloam::record {

GLOAM_MEMBERS(audit::AuditLocation, file, line, function, operation)
GLOAM_MEMBERS(audit::AuditWitness, device, value)
GLOAM_MEMBERS(audit::AuditRewrite, file, line, before, after, helper, reason, gain)

template <class Io>
void members(Io& io, audit::AuditFinding& finding) {
    each(io, "concern", finding.concern, "share", finding.share, "input", finding.values, "words",
         finding.words, "output", finding.output, "value", finding.value, "exact", finding.exact, "permitted",
         finding.permitted, "digits_lost", finding.lost, "place", finding.place);
    io.member("message", finding.message, Present::if_any);
    io.member("reservation", finding.reservation, Present::if_any);
    io.member("devices", finding.witnesses, Present::if_any);
}

template <class Io>
void members(Io& io, audit::OrdinaryValues& values) {
    each(io, "parameter", values.parameter, "values", values.text, "reason", values.reason);
}

template <class Io>
void members(Io& io, audit::AuditLine& line) {
    each(io, "file", line.file, "line", line.line, "digits_lost", line.lost);
}

template <class Io>
void members(Io& io, audit::Audit& audit) {
    each(io, "function", audit.function, "declaration", audit.declaration, "inputs", audit.inputs, "random",
         audit.random, "audited", audit.was_run(), "broken", audit.is_broken(), "domain", audit.domain,
         "findings", audit.findings, "not_reached", audit::missed(audit.coverage), "lines", audit.lines,
         "rewrites", audit.rewrites);
}

std::string to_audit_json(const AuditReport& report) {
    return to_text(
        {{"gloam", base::version()}, {"file", report.file}, {"functions", json_of(report.audits)}});
}

namespace {

constexpr double visible_loss = 0.5;  // decimal digits

// The lines of the file itself, with the most that any function loses there: 1.5 digits a step of colour.
std::string source_html(const AuditReport& report) {
    constexpr unsigned hottest = 4;  // of the classes heat0 to heat4
    const std::filesystem::path file = std::filesystem::path(report.file).filename();
    std::map<unsigned, double> losses;
    std::map<unsigned, std::string> wrong;
    for (const audit::Audit& audit : report.audits) {
        for (const audit::AuditLine& line : audit.lines)
            if (std::filesystem::path(line.file).filename() == file)
                losses[line.line] = std::max(losses[line.line], line.lost);
        for (const audit::AuditFinding& finding : audit.findings)
            if (finding.concern < audit::Concern::unspecified &&
                std::filesystem::path(finding.place.file).filename() == file)
                wrong[finding.place.line] = name_of(finding.concern);
    }
    std::string html = "<pre class=\"source\">";
    std::istringstream text(report.source);
    unsigned number = 0;
    for (std::string row; std::getline(text, row);) {
        const double lost = losses[++number];
        std::vector<std::string> notes;
        if (wrong.contains(number)) notes.push_back(wrong[number]);
        if (lost >= visible_loss) notes.push_back(fmt::format("loses {:.1f} digits", lost));
        const auto steps = static_cast<unsigned>(lost / 1.5 + (lost >= visible_loss ? 1.0 : 0.0));
        html += fmt::format("<span class=\"heat{}\"><b>{:>4}</b> {}<i>{}{}</i></span>\n",
                            wrong.contains(number) ? hottest : std::min(steps, hottest), number,
                            escaped_html(row), notes.empty() ? "" : "  // ",
                            escaped_html(fmt::format("{}", fmt::join(notes, ", "))));
    }
    return html + "</pre>\n";
}

Table finding_table(const audit::Audit& audit) {
    Table table{{{"concern"}, {"how much"}, {"at"}, {"input"}, {"result"}}};
    for (const audit::AuditFinding& finding : audit.findings) {
        const Tone tone = finding.concern < audit::Concern::unspecified ? Tone::bad : Tone::plain;
        std::string result = result_text(finding);
        for (const std::string& remark : remarks_on(finding)) result += "; " + remark;
        table.rows.push_back({{name_of(finding.concern), {}, tone},
                              extent_text(finding),
                              to_text(finding.place),
                              finding.values,
                              result});
    }
    return table;
}

// Lines for a C++ test of the framework, and for the command line.
std::string ready_to_paste(const AuditReport& report, const audit::Audit& audit) {
    std::string text;
    for (const audit::AuditFinding& finding : audit.findings)
        text += fmt::format(
            "// {}: {}\ndomain = domain.and_words({{{:#010x}}});\n// gloam explain {} '{}' {:#010x}\n",
            name_of(finding.concern), finding.values, fmt::join(finding.words, ", "),
            std::filesystem::path(report.file).filename().string(), audit.function,
            fmt::join(finding.words, " "));
    return text;
}

void add_function(Page& page, const AuditReport& report, const audit::Audit& audit) {
    page.heading(audit.declaration);
    Table domain{{{"parameter"}, {"values"}, {"because of"}}};
    for (const audit::OrdinaryValues& values : audit.domain)
        domain.rows.push_back({values.parameter, values.text, values.reason});
    page.table(domain);
    if (!audit.was_run())
        page.paragraph("Not audited: no input came to its end.");
    else if (audit.findings.empty())
        page.paragraph(
            fmt::format("No input of {} gives NaN, infinity or an undefined result, and none loses digits.",
                        audit.inputs));
    else
        page.table(finding_table(audit));
    std::string lines;
    for (const std::string& way : audit::missed(audit.coverage))
        lines += fmt::format("not reached: {}\n", way);
    if (!lines.empty()) page.preformatted(lines);
    for (const audit::AuditRewrite& rewrite : audit.rewrites) {
        page.paragraph(fmt::format("Line {}: {}. Tried on the inputs above: {}.", rewrite.line,
                                   rewrite.reason, rewrite.gain));
        page.preformatted(fmt::format("{}- {}\n+ {}", rewrite.helper, rewrite.before, rewrite.after));
    }
    if (!audit.findings.empty()) page.preformatted(ready_to_paste(report, audit));
}

}  // namespace

std::string to_audit_page(const AuditReport& report) {
    Page page("Audit of " + std::filesystem::path(report.file).filename().string());
    page.paragraph(
        "Run by an interpreter, correctly rounded, in double and on intervals that hold all that Vulkan "
        "permits. A colour shows how many decimal digits the operations of a line lose at most; a float has "
        "7.2.");
    page.markup(source_html(report));
    for (const audit::Audit& audit : report.audits) add_function(page, report, audit);
    return page.html();
}

}  // namespace gloam::record
