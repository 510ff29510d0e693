// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "check/run.hpp"

namespace gloam::check {

struct SearchOptions {
    std::size_t inputs = 65'536;  // evaluated in all
    std::uint64_t seed = 1;
    // The error is searched as a fraction of what this allows. Empty: what the lab's variant stands for.
    std::optional<Verdict> verdict{};
};

// What a search found of one function.
struct SearchResult {
    Answer answer;                // over every input that was evaluated
    double drawn_fraction = 0.0;  // the worst among those that were drawn at random, before the climb
};

// Looks for the inputs with the largest error: a quarter of the inputs is drawn at random, the others climb
// from the worst so far, by neighbouring floats, by powers of two up to whole exponents, by exchanging
// parameters. It stays inside the domain. Throws as run() does.
[[nodiscard]] SearchResult search(const Lab& lab, const Question& question,
                                  const SearchOptions& options = {});

}  // namespace gloam::check
