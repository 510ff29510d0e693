// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand `bench` with a subcommand for each description in experiments_directory(), for a user's
// own file, and for the framework. `status` receives the exit status: 0; 1 if the validation layers reported
// messages, if no candidate is within --budget or --error, if a target is missed and --fail-if-missed is
// given, or if something got worse and --fail-if-worse is given.
void add_bench(CLI::App& app, int& status);

// The arguments of the program with the name of the subcommand of a user's own file before it: "bench
// mine.json".
[[nodiscard]] std::vector<std::string> with_own_experiment(std::vector<std::string> arguments);

}  // namespace gloam::cli
