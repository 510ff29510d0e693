// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the options of `gloam bench` alone, which runs the description samples.json, a subcommand for each
// description in experiments_directory(), and one for a user's own file. `status` receives the exit status:
// 0; 1 if the validation layers reported messages, if no candidate is within --budget or --error, if a target
// is missed and --fail-if-missed is given, or if something got worse and --fail-if-worse is given.
void add_experiments(CLI::App& bench, int& status);

// The arguments of the program with the name of that subcommand before a file: "bench mine.json".
[[nodiscard]] std::vector<std::string> with_own_experiment(std::vector<std::string> arguments);

}  // namespace gloam::cli
