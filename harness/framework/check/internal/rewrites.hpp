// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/audit.hpp"
#include "check/internal/audit_runs.hpp"
#include "check/internal/audit_search.hpp"

namespace gloam::check::internal {

// A change of a text that may make a function more exact.
struct Candidate {
    std::size_t begin = 0;  // in the text
    std::size_t end = 0;
    std::string after;
    std::string helper;  // a function that stands before; may be empty
    std::string reason;
    std::size_t declared_at = 0;  // in the text, at or before `begin`: where this comes to stand
    std::string declaration;      // "float rest = 0.0; "; may be empty
    bool wide = false;            // its intervals grow without need: two of its numbers cancel
};

// The well-known changes that a GLSL text without comments allows: 1 - cos, acos of a dot product, the
// direction of a zero vector, a sum with what its roundings lost, and so on. None is tried.
[[nodiscard]] std::vector<Candidate> candidates_of(std::string_view text);

// Those of the function's own excerpt that help on the inputs of a search, and harm on none of them. Empty if
// the lab has no excerpt of the function.
[[nodiscard]] std::vector<AuditRewrite> rewrites(const Lab& lab, AuditRuns& runs, const AuditSearch& search,
                                                 const std::vector<AuditFinding>& findings);

}  // namespace gloam::check::internal
