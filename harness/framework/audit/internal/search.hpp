// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "audit/audit.hpp"
#include "audit/internal/moves.hpp"
#include "audit/internal/runs.hpp"

namespace gloam::audit::internal {

// Inputs that show a concern, and how many of the random ones do.
struct Examples {
    std::vector<std::vector<subject::Word>> random;
    std::vector<std::vector<subject::Word>> others;  // special values, and what the search met
    std::size_t shown = 0;                           // random ones, those that are not kept included
};

// What the search of an audit found.
struct AuditSearch {
    // Of every concern but digits and drivers; for unspecified results and partings of drawn inputs only.
    std::map<Concern, Examples> examples;
    std::map<Concern, Moves::Candidate> worst;  // of digits and drivers
    std::vector<std::vector<subject::Word>>
        traced;              // some drawn inputs; the audit adds those of its findings
    std::size_t random = 0;  // drawn without special values
    std::size_t inputs = 0;
    std::size_t too_long = 0;  // that did not come to their end
};

// Draws half of the inputs, some of them without special values, and climbs with the others: to where float32
// loses most digits, and to where drivers may differ most. No input that it runs leaves the domain.
[[nodiscard]] AuditSearch search(AuditRuns& runs, const AuditOptions& options);

// Inputs of the domain that random ones miss, at which a text is likely to divide by zero or to ask for a
// direction: middles and quarters of the ranges of several parameters together, zeros of linear expressions
// of the text's numbers, unit vectors along a diagonal. The rest is that of rows of `drawn`. At most so many.
[[nodiscard]] std::vector<std::vector<subject::Word>> places_of(const judge::Question& question,
                                                                std::span<const float> numbers,
                                                                const subject::Domain::Inputs& drawn,
                                                                std::size_t most);

// Decimal digits that a relative error of a float32 costs, of a correctly rounded one none.
[[nodiscard]] double digits_of(double relative, double unit = 0x1p-24);

// Whether a reading shows a concern; an unspecified result is an undefined one of a reading with open gaps.
[[nodiscard]] bool shows(Concern concern, const OutputReading& output);
[[nodiscard]] bool shows(Concern concern, const Reading& reading);

// The simplest input, as shrink() has it, for which `still` holds.
[[nodiscard]] std::vector<subject::Word> simplified(
    const AuditRuns& runs, const std::vector<subject::Word>& words,
    const std::function<bool(const std::vector<subject::Word>&)>& still);

// The well-known changes that a GLSL text without comments allows, each with its position in the text: 1 -
// cos, acos of a dot product, the direction of a zero vector, and so on. None is tried, and none has a line.
[[nodiscard]] std::vector<std::pair<std::size_t, AuditRewrite>> candidates_of(std::string_view text);

// Those of the function's own excerpt that help on the inputs of a search, and harm on none of them. Empty if
// the lab has no excerpt of the function.
[[nodiscard]] std::vector<AuditRewrite> rewrites(const subject::Lab& lab, AuditRuns& runs,
                                                 const AuditSearch& search);

}  // namespace gloam::audit::internal
