// SPDX-License-Identifier: MIT
#pragma once

#include "judge/run.hpp"

namespace gloam::audit {

// The result of a search for one function.
struct SearchResult {
    judge::Answer answer;         // over all evaluated inputs
    double drawn_fraction = 0.0;  // the largest of the inputs drawn at random, before the climb
};

// Searches for the inputs with the largest error, as a fraction of what the criterion of the lab's variant
// allows. A quarter of the inputs is drawn at random. The others start from the worst inputs so far and move
// to neighbouring floats, by powers of two up to whole exponents, or exchange parameters. All stay inside the
// domain. Throws like run().
[[nodiscard]] SearchResult search(const subject::Lab& lab, const judge::Question& question,
                                  const judge::RunOptions& options = {});

}  // namespace gloam::audit
