// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the options of `gloam bench` itself: what it does without a subcommand. `status` receives what it
// returns.
void add_benchmark(CLI::App& bench, int& status);

}  // namespace gloam::cli
