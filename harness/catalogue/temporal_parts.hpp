// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"
#include "numeric/constants.hpp"

// The parts of append_temporal, one file each, and their common functions.
namespace gloam::catalogue {

// The file and the source of an equation.
struct Origin {
    const char* file;    // as in Description
    const char* source;  // as in Description
};

// An equation on a history that has nothing special except its domain: no error is allowed, and no result is
// below 0.
template <class Signature, class Reference>
void append_exact(Entries& entries, const Origin& origin, Description description, Reference reference,
                  check::Domain domain) {
    description.file = origin.file;
    description.source = origin.source;
    entries.push_back(equation<Signature>(std::move(description), std::move(reference),
                                          {.domain = std::move(domain), .codomain = {0, numeric::infinity}}));
}

void append_accumulation(Entries& entries);  // blending, convergence, and equations that depend on it
void append_history(Entries& entries);       // the history buffer, its interpolation, the start index
void append_packed_history(Entries& entries);
void append_displacement(Entries& entries);  // the motion that samples watch for, in 32 bits
void append_validity(Entries& entries);
void append_reprojection(Entries& entries);  // disocclusion, neighbourhood change, smooth invalidation

}  // namespace gloam::catalogue
