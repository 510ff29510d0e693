// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "audit/mutant.hpp"

namespace gloam::record {

// What became of a fault.
enum class Fate {
    untried,
    invalid,   // it does not compile
    same,      // the optimised modules are those of the file as it is
    known,     // a list says why no test can notice it
    killed,    // the command failed
    too_long,  // the command took far longer than without it, which counts as killed
    survived
};
[[nodiscard]] std::string name_of(Fate fate);

struct MutantRow {
    std::size_t file = 0;  // of MutationReport::files
    source::Mutation mutation;
    Fate fate = Fate::untried;
    double seconds = 0.0;                     // that the command took
    std::string reason = {};                  // of a known one
    audit::MutantComparison comparison = {};  // of a survivor
};

// What a command noticed of the faults of some files.
struct MutationReport {
    std::string command;
    std::vector<std::string> files;  // as they were named
    std::vector<MutantRow> mutants;  // by file, in the order of its text

    // Survivors whose results differ where they are promised, or that could not be compared.
    [[nodiscard]] std::size_t missed() const;
    // Whether the command met a fault, or none is left that it could have met.
    [[nodiscard]] bool is_begun() const;
};

// A table of all files, then the survivors, the gravest first, for people.
[[nodiscard]] std::string to_text(const MutationReport& report);

// {"command", "mutants": [{"file", "line", "kind", "function", "before", "after", "fate", "seconds",
// "difference", "inputs", "input", "words", "result", "result_with_fault"}]}
[[nodiscard]] std::string to_mutation_json(const MutationReport& report);

}  // namespace gloam::record
