// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds examples to the end of the help of the program and of its commands. To be called when all are added.
void add_help_examples(CLI::App& app);

}  // namespace gloam::cli
