// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "check/describe.hpp"
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
                out += c;
        }
    }
    return out;
}

std::string test_case(const CheckRow& row) {
    std::string xml =
        fmt::format("    <testcase classname=\"{}\" name=\"{} {}\" time=\"{:.3f}\"", escaped(row.result.file),
                    escaped(row.equation), escaped(row.variant), row.seconds);
    if (row.passed()) return xml + "/>\n";
    const bool ran = row.error.empty();
    return xml + fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", ran ? "failure" : "error",
                             escaped(ran ? check::describe(row.result) : row.error));
}

std::size_t errors(const CheckReport& report) {
    std::size_t count = 0;
    for (const CheckRow& row : report.rows) count += row.error.empty() ? 0 : 1;
    return count;
}

}  // namespace

std::string to_junit(const std::vector<CheckReport>& reports) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const CheckReport& report : reports) {
        xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                           escaped(report.device.name), report.rows.size(),
                           report.failures() - errors(report), errors(report));
        for (const CheckRow& row : report.rows) xml += test_case(row);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace gloam::report
