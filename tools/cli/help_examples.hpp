// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds examples to the end of the help of the program and of its commands. Call it after all commands were
// added.
void add_help_examples(CLI::App& app);

}  // namespace gloam::cli
