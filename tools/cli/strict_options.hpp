// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Lets every option of the command and its subcommands reject values that CLI11 accepts and that are never
// intended: an empty text, a number that is NaN, a count below zero. Call it after all options were added.
void refuse_meaningless_values(CLI::App& app);

}  // namespace gloam::cli
