// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "cli/framework/mutate/trials.hpp"
#include "record/mutation_report.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

int run_mutate(const MutateCommand& command) {
    if (command.command.empty())
        throw std::invalid_argument("mutate: expected -- COMMAND behind the files: what runs the tests");
    const record::OutputFile json(command.json);
    Trials trials(command);
    trials.run();
    fmt::print("{}", to_text(trials.report()));
    if (!command.json.empty()) json.write(to_mutation_json(trials.report()));
    return trials.report().missed() > 0 ? 1 : 0;
}

}  // namespace

std::vector<std::string> take_command(std::vector<std::string>& arguments) {
    const auto mark = std::ranges::find(arguments, "--");
    if (arguments.empty() || arguments.front() != "mutate" || mark == arguments.end()) return {};
    std::vector<std::string> command(mark + 1, arguments.end());
    arguments.erase(mark, arguments.end());
    return command;
}

void add_mutate(CLI::App& app, std::vector<std::string> words, int& status) {
    auto command = std::make_shared<MutateCommand>();
    command->command = std::move(words);
    CLI::App* mutate = app.add_subcommand(
        "mutate", "plant faults in shaders, and show which of them a test does not notice");
    mutate->add_option("file", command->paths, "GLSL files, and folders of them; -- COMMAND follows")
        ->required();
    mutate->add_option("--count", command->count, "so many faults, one at each place (without: all)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
    mutate->add_option("--seed", command->seed, "seed of the faults and the inputs")->capture_default_str();
    mutate
        ->add_option("--inputs", command->inputs, "inputs on which a survivor is compared with the original")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
        ->capture_default_str();
    mutate->add_option("--jobs", command->jobs, "commands at once (without: one for each processor)")
        ->check(CLI::Range(1U, 1024U));
    mutate->add_option("--minutes", command->minutes, "begin nothing after so many minutes")
        ->check(CLI::Range(0.0, 1e6));
    mutate
        ->add_option("--patience", command->patience,
                     "end a command after so many seconds (without: 5 s more than five times what it takes "
                     "without the fault)")
        ->check(CLI::Range(0.1, 1e6));
    add_include_option(*mutate, command->includes);
    mutate->add_option("--known", command->known,
                       "file of faults that no test can notice: FILE | LINE WITH THE FAULT | REASON");
    mutate->add_option("--json", command->json, "file for all results");
    mutate->callback([command, &status] { status = run_mutate(*command); });
}

}  // namespace gloam::cli
