// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace gloam::record {

// The audits of a file's functions.
struct AuditReport {
    std::string file;    // as it was named
    std::string source;  // its text
    std::vector<audit::Audit> audits;
};

// All that the audits found, as JSON: {"file", "functions": [{"function", "domain", "findings",
// "not_reached", "rewrites"}]}. The words of each worst input are numbers, as Domain::and_words() takes.
[[nodiscard]] std::string to_audit_json(const AuditReport& report);

// The same as an HTML page: the source with its lines coloured by what they lose, and for each function its
// domain, its worst inputs, ready for a test, and its rewrites.
[[nodiscard]] std::string to_audit_page(const AuditReport& report);

}  // namespace gloam::record
