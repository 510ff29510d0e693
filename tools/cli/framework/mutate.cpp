// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>

#include "cli/commands.hpp"
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

Command mutate_command() {
    static MutateCommand command;
    return {
        .name = "mutate",
        .about = "plant faults in shaders, and show which of them a test does not notice",
        .options = {{"file", &command.paths, required, "GLSL files, and folders of them; -- COMMAND follows"},
                    {"--count", &command.count, between(1, 1e6),
                     "so many faults, one at each place (without: all)"},
                    {"--seed", &command.seed, "seed of the faults and the inputs"},
                    {"--inputs", &command.inputs, between(1, 1e6),
                     "inputs on which a survivor is compared with the original"},
                    {"--jobs", &command.jobs, between(1, 1024),
                     "commands at once (without: one for each processor)"},
                    {"--minutes", &command.minutes, between(0, 1e6), "begin nothing after so many minutes"},
                    {"--patience", &command.patience, between(0.1, 1e6),
                     "end a command after so many seconds (without: 5 s more than five times what it takes "
                     "without the fault)"},
                    include_option(command.includes),
                    {"--known", &command.known,
                     "file of faults that no test can notice: FILE | LINE WITH THE FAULT | REASON"},
                    {"--json", &command.json, "file for all results"}},
        .run = [] { return run_mutate(command); },
        .examples = R"(  gloam mutate shaders/tone.glsl -- ctest --test-dir build
  gloam mutate shaders --count 200 --seed 1 --json faults.json -- ./tests

COMMAND is run for each fault, without a shell. A status other than 0 means that it noticed the fault.
GLOAM_SHADERS names a copy of the folder of shaders (the first --include, otherwise that of the files) with
the fault, GLOAM_SHADERS_OF that folder, and GLOAM_SHADERS_CHANGED the changed file below it. gloam and tests
that use its framework read the copy by themselves.
)",
        .behind_dashes = &command.command};
}

}  // namespace gloam::cli
