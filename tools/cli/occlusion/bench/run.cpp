// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>

#include "base/files.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/bench/files.hpp"
#include "cli/occlusion/bench/options.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "effect/settings.hpp"
#include "experiment/comparison.hpp"
#include "experiment/experiment.hpp"
#include "experiment/runner.hpp"
#include "experiment/table.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
constexpr const char* own_experiment = "FILE.json";
using experiment::Experiment;

scene::Inputs inputs_named(const std::string& name) {
    if (name == "sampled") return scene::Inputs::sampled;
    if (name == "storage") return scene::Inputs::storage;
    return scene::Inputs::by_device;
}

experiment::Record record_in(const fs::path& file) {
    return experiment::read_record(file.string(), base::read_file(file));
}

int compare_files(const ExperimentOptions& options) {
    const experiment::Comparison found =
        experiment::compared(record_in(options.compare.at(0)), record_in(options.compare.at(1)));
    fmt::print("{}", found.text);
    return options.fail_if_worse && found.got_worse ? 1 : 0;
}

// Prints the tables and the answers, and writes the files.
int report_on(const Experiment& what, const experiment::Record& record, const ExperimentOptions& options,
              ExperimentFiles& files) {
    const experiment::Database database(record);
    const experiment::Text tables = to_text(what, database);
    const Measured measured{what, record, database, tables};
    const std::string heading = heading_of(measured);
    const experiment::Answers answers = answers_to(database, options.budget, options.error);
    fmt::print("{}{}{}", heading, tables.text, answers.text);
    files.write(measured, heading, versions());
    return !answers.all || (tables.missed && options.fail_if_missed) ? 1 : 0;
}

int report_stored(const Experiment& what, const ExperimentOptions& options) {
    std::vector<experiment::Record> parts;
    for (const fs::path& file : options.from) parts.push_back(record_in(file));
    const experiment::Record record = experiment::joined(parts);
    ExperimentFiles files(options.paths, what);
    return report_on(what, record, options, files);
}

int run_experiment(const ExperimentOptions& options) {
    if (options.only_single && options.only_temporal)
        throw std::invalid_argument("--temporal and --single: expected one of them, or none for both");
    if (options.resume && options.paths.out.empty())
        throw std::invalid_argument("--resume: expected --out, the folder whose journal is taken up again");
    if (!options.budget.empty()) (void)experiment::time_budget(options.budget);
    if (!options.compare.empty()) return compare_files(options);
    Experiment what = described(options);
    if (!options.from.empty()) return report_stored(what, options);
    const fs::path meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes;
    choose_candidates(what, options);
    choose_cases(what, options.cases, options.half, meshes);
    std::vector<gpu::Extent> sizes;
    for (const std::string& size : what.sizes) sizes.push_back(judged_size(size));
    gpu::Device device = open_device(options.device, options.validation);
    scene::PassLibrary passes(glsl_directory(), cache_directory());
    passes.inputs = inputs_named(options.inputs);
    experiment::Place place{.device = device,
                            .passes = passes,
                            .truth_cache = truth_cache_directory(),
                            .meshes = meshes,
                            .preset_of = preset_settings,
                            .progress = [](const std::string& what) { return progress_bar(what); }};
    require_possible(what, place);
    ExperimentFiles files(options.paths, what);
    experiment::Record record({.experiment = what.name,
                               .device = device.info().name,
                               .driver = device.info().driver,
                               .frames = what.frames,
                               .scored = what.scored,
                               .repeat = what.repeat,
                               .rays = what.rays});
    const record::Journal journal(files.journal(), line_of(record.conditions()), options.resume,
                                  [&](std::string_view line) { record.add_line(line); });
    place.keep = [&](const std::string& line) { journal.add(line); };
    if (files.shows_pictures()) place.show = [&](const experiment::Picture& picture) { files.show(picture); };
    run(what, sizes, place, record);
    const int status = report_on(what, record, options, files);
    const int messages = validation_status(device);
    return messages == 0 ? status : messages;
}

CLI::App& add_command(CLI::App& bench, const std::string& name, const std::string& about, bool has_query,
                      const std::shared_ptr<ExperimentOptions>& options, int& status) {
    CLI::App* command = bench.add_subcommand(name, about);
    add_options(*command, *options, has_query);
    command->callback([options, &status] { status = run_experiment(*options); });
    return *command;
}

// An empty one where it cannot be read.
Experiment description_in(const fs::path& file) {
    try {
        return experiment::read_experiment(file.string(), base::read_file(file));
    } catch (const std::exception&) {
        return {};
    }
}

// None where the program's files are missing: other commands need none of them.
std::set<fs::path> built_in_experiments() {
    std::set<fs::path> files;
    try {
        for (const fs::directory_entry& entry : fs::directory_iterator(experiments_directory()))
            if (entry.path().extension() == ".json") files.insert(entry.path());
    } catch (const std::runtime_error&) {
        files.clear();
    }
    return files;
}

// A subcommand for each description, and one for a user's own file. Without one the options of `gloam bench`
// alone run the description samples.json.
void add_experiments(CLI::App& bench, int& status) {
    auto unnamed = std::make_shared<ExperimentOptions>();
    add_options(bench, *unnamed, true);
    bench.callback([unnamed, &bench, &status] {
        if (bench.get_subcommands().empty()) status = run_experiment(*unnamed);
    });
    for (const fs::path& file : built_in_experiments()) {
        auto options = std::make_shared<ExperimentOptions>();
        options->file = file;
        const Experiment what = description_in(file);
        (void)add_command(bench, file.stem().string(), what.about, what.candidate_query.has_value(), options,
                          status);
    }
    auto options = std::make_shared<ExperimentOptions>();
    add_command(bench, own_experiment, "an experiment of your own: copy one of gloam's", false, options,
                status)
        .add_option("FILE", options->file, "its description in JSON")
        ->required();
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
    CLI::App* group =
        app.add_subcommand("bench", "time against error: which method with how many samples, on this device");
    group->require_subcommand(0, 1);
    add_experiments(*group, status);
}

std::vector<std::string> with_own_experiment(std::vector<std::string> arguments) {
    if (arguments.size() > 1 && arguments[0] == "bench" && arguments[1].ends_with(".json"))
        arguments.insert(arguments.begin() + 1, own_experiment);
    return arguments;
}

}  // namespace gloam::cli
