// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "report/check_report.hpp"

namespace gloam::report {
namespace {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\n':
                out += "&#10;";
                break;
            default:
                // XML 1.0 does not allow other control characters, not even escaped; a driver's message may
                // contain them.
                out += static_cast<unsigned char>(c) < 0x20 && c != '\t' ? '?' : c;
        }
    }
    return out;
}

std::string test_case(const check::Answer& row) {
    std::string xml =
        fmt::format("    <testcase classname=\"{}\" name=\"{} {}\" time=\"{:.3f}\"", escaped(row.file),
                    escaped(row.equation), escaped(row.variant), row.seconds);
    if (row.passed()) return xml + "/>\n";
    if (!row.failed())
        return xml + fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                                 escaped(row.not_judged_because()));
    return xml + fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\"/>\n    </testcase>\n",
                             row.ran() ? "failure" : "error",
                             row.reason == check::Reason::none ? "outside" : name_of(row.reason),
                             escaped(row.ran() ? row.story : row.error));
}

std::size_t errors(const CheckReport& report) {
    return static_cast<std::size_t>(std::ranges::count_if(
        report.rows, [](const check::Answer& row) { return row.failed() && !row.ran(); }));
}

}  // namespace

std::string to_junit(const std::vector<CheckReport>& reports) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const CheckReport& report : reports) {
        xml += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
            escaped(report.device.name), report.rows.size(),
            report.count(check::Outcome::failed) - errors(report), errors(report),
            report.count(check::Outcome::not_judged));
        if (!report.versions.empty())
            xml += fmt::format("    <properties><property name=\"versions\" value=\"{}\"/></properties>\n",
                               escaped(report.versions));
        for (const check::Answer& row : report.rows) xml += test_case(row);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace gloam::report
