// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand `bench` with a subcommand for each measurement. `status` receives the exit status.
void add_bench(CLI::App& app, int& status);

}  // namespace gloam::cli
