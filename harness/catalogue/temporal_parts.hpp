// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"
#include "numeric/constants.hpp"

// The parts of append_temporal, one file each, and what they share.
namespace gloam::catalogue {

// Where an equation stands and where it comes from.
struct Origin {
    const char* file;    // as Description has it
    const char* source;  // likewise
};

// An equation of a history of which nothing is to be told but its domain: no error is allowed to it, and no
// result is below 0.
template <class Signature, class Reference>
void append_exact(Entries& entries, const Origin& origin, Description description, Reference reference,
                  check::Domain domain) {
    description.file = origin.file;
    description.source = origin.source;
    entries.push_back(equation<Signature>(std::move(description), std::move(reference),
                                          {.domain = std::move(domain), .codomain = {0, numeric::infinity}}));
}

void append_accumulation(Entries& entries);  // blending, convergence, what depends on it
void append_history(Entries& entries);       // the history buffer, its interpolation, the start index
void append_packed_history(Entries& entries);
void append_validity(Entries& entries);
void append_reprojection(Entries& entries);  // disocclusion, neighbourhood change, smooth invalidation

}  // namespace gloam::catalogue
