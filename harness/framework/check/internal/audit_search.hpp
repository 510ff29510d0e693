// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "check/audit.hpp"
#include "check/internal/audit_runs.hpp"

namespace gloam::check::internal {

// The worst input of a search so far.
struct WorstInput {
    double score = 0.0;  // 0: none
    std::vector<Word> words;
};

// Inputs that show a concern, and how many of the random ones do.
struct Examples {
    std::vector<std::vector<Word>> random;
    std::vector<std::vector<Word>> others;  // special values, and what the search met
    std::size_t shown = 0;                  // random ones, those that are not kept included
};

// What the search of an audit found.
struct AuditSearch {
    Examples faults;
    Examples not_finite;
    Examples undefined;
    Examples unspecified;  // of drawn inputs only
    Examples parted;       // likewise; see Parting
    WorstInput digits;
    WorstInput drivers;
    std::vector<std::vector<Word>> traced;  // some drawn inputs, for the lines of the source
    std::size_t random = 0;                 // drawn without special values
    std::size_t inputs = 0;
    std::size_t too_long = 0;  // that did not come to their end
};

// Draws half of the inputs, some of them without special values, and climbs with the others: to where float32
// loses most digits, and to where drivers may differ most. No input that it runs leaves the domain.
[[nodiscard]] AuditSearch search(AuditRuns& runs, const AuditOptions& options);

// Whether a reading shows a concern; an unspecified result is an undefined one of a reading with open gaps.
[[nodiscard]] bool shows(Concern concern, const Reading& reading);

// The same input with simpler numbers (0, 1, few digits) wherever `still` holds for them.
[[nodiscard]] std::vector<Word> simplified(const AuditRuns& runs, std::vector<Word> words,
                                           const std::function<bool(const std::vector<Word>&)>& still);

}  // namespace gloam::check::internal
