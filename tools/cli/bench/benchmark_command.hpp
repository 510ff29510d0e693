// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the options of `gloam bench` without a subcommand. `status` receives the exit status.
void add_benchmark(CLI::App& bench, int& status);

}  // namespace gloam::cli
