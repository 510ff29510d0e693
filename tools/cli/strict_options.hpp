// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Every option of the command and of those below it, whoever added it, refuses what CLI11 takes for a value
// and nobody means: an empty text, a number that is NaN, a count below zero. To be called when all are added.
void refuse_meaningless_values(CLI::App& app);

}  // namespace gloam::cli
