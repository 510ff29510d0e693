// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::check {
struct Question;
}

namespace gloam::cli {

struct PresetFrame;

// What is about ambient occlusion, for the commands of the framework: the equations that names stand for, or
// all without names; the passes of a preset with NAME=VALUE set. Both throw std::invalid_argument.
using EquationsNamed = std::vector<check::Question>(const std::vector<std::string>& names);
// tiles: the share of tiles that are swept in full; otherwise the preset's own, that of unseen views.
using FrameOf = PresetFrame(const std::string& preset, const std::vector<std::string>& set,
                            std::optional<double> tiles);

// "gloam 0.3.0, glslang 11.13.0 (generator 10), SPIRV-Tools v2022.4, SPIRV-Cross ...": the versions on which
// a result depends, besides the device and its driver.
[[nodiscard]] std::string versions();

// Each adds a subcommand of that name, whose help says what it does. `status` receives its exit status: 0, or
// 1 where it ran and found something wrong.
void add_demo(CLI::App& app, int& status);
void add_devices(CLI::App& app);
void add_list(CLI::App& app);
void add_explain(CLI::App& app, EquationsNamed* equations);
void add_audit(CLI::App& app, EquationsNamed* equations, int& status);
void add_cost(CLI::App& app, EquationsNamed* equations, FrameOf* frame, int& status);
void add_render(CLI::App& app, int& status);
void add_report(CLI::App& app, int& status);
void add_stress(CLI::App& app, int& status);
void add_pack(CLI::App& app);
// With a subcommand for each description in experiments_directory(), and for a user's own file.
void add_bench(CLI::App& app, int& status);
// words: its COMMAND, see take_command().
void add_mutate(CLI::App& app, std::vector<std::string> words, int& status);

// Takes the words behind the first "--" of `gloam mutate` from its arguments.
[[nodiscard]] std::vector<std::string> take_command(std::vector<std::string>& arguments);

// The arguments of the program with the name of the subcommand of a user's own file before it: "bench
// mine.json".
[[nodiscard]] std::vector<std::string> with_own_experiment(std::vector<std::string> arguments);

// The arguments of the program with a blank before each value of `gloam explain` below zero, so that "-.5"
// and
// "-inf" are no options.
[[nodiscard]] std::vector<std::string> with_numbers_apart(std::vector<std::string> arguments);

// Adds examples to the end of the help of the program and of its commands. Call it after all commands were
// added.
void add_help_examples(CLI::App& app);

// Lets every option of the command and its subcommands reject values that CLI11 accepts and that are never
// intended: an empty text, a number that is NaN, a count below zero. Call it after all options were added.
void refuse_meaningless_values(CLI::App& app);

}  // namespace gloam::cli
