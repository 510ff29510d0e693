// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam demo`: renders three scenes, checks the default device, and makes a page of both. `status` receives
// 0, or 1 when a check failed.
void add_demo(CLI::App& app, int& status);

// `gloam devices`: the Vulkan devices here and what they report of their float arithmetic.
void add_devices(CLI::App& app);

// `gloam list [KIND]`: equations, methods, presets, scenes, variants.
void add_list(CLI::App& app);

// Adds `gloam explain FILE FUNCTION VALUE...`: the operations of a shader function on one input.
void add_explain(CLI::App& app);

// `gloam audit FILE [FUNCTION...]`: where a shader function itself goes wrong. `status` receives 0, or 1 if
// an input gives NaN, infinity or an undefined result.
void add_audit(CLI::App& app, int& status);

// `gloam cost FILE [FUNCTION]`: what a GPU's compiler makes of a shader. `status` receives 0, or 1 if it
// costs more than --below says.
void add_cost(CLI::App& app, int& status);

// Takes the words behind the first "--" of `gloam mutate` from its arguments: its COMMAND.
[[nodiscard]] std::vector<std::string> take_command(std::vector<std::string>& arguments);

// `gloam mutate FILE... -- COMMAND...`: the faults of shaders that a command does not notice. `status`
// receives 0, or 1 if one changes a result where it is promised.
void add_mutate(CLI::App& app, std::vector<std::string> words, int& status);

// Adds the subcommand that merges the JSON of `gloam check` from many machines. `status` receives 0, or 1 if
// there is a failure.
void add_report(CLI::App& app, int& status);

// Adds the subcommand `bench` with a subcommand for each description in experiments_directory(), and for a
// user's own file. `status` receives the exit status: 0; 1 if the validation layers reported
// messages, if no candidate is within --budget or --error, if a target is missed and --fail-if-missed is
// given, or if something got worse and --fail-if-worse is given.
void add_bench(CLI::App& app, int& status);

// The arguments of the program with the name of the subcommand of a user's own file before it: "bench
// mine.json".
[[nodiscard]] std::vector<std::string> with_own_experiment(std::vector<std::string> arguments);

// `gloam stress`: the searches of tools/stress, a line for each number. `status` receives 0, or 1 if a bound
// is broken.
void add_stress(CLI::App& app, int& status);

// `gloam pack FILE...`: one self-contained GLSL file on standard output.
void add_pack(CLI::App& app);

// Adds the subcommand that writes a static site with checks for the visitor's browser.
void add_site(CLI::App& app);

// Adds examples to the end of the help of the program and of its commands. Call it after all commands were
// added.
void add_help_examples(CLI::App& app);

// Lets every option of the command and its subcommands reject values that CLI11 accepts and that are never
// intended: an empty text, a number that is NaN, a count below zero. Call it after all options were added.
void refuse_meaningless_values(CLI::App& app);

}  // namespace gloam::cli
