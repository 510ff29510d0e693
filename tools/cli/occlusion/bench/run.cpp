// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

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
        for (const fs::directory_entry& entry : fs::directory_iterator(data_directory("experiments")))
            if (entry.path().extension() == ".json") files.insert(entry.path());
    } catch (const std::runtime_error&) {
        files.clear();
    }
    return files;
}

// A command that runs the description in the file, or in the file that `options` name.
Command experiment_command(const std::string& name, const std::string& about, const fs::path& file,
                           bool has_query) {
    const auto options = std::make_shared<ExperimentOptions>();  // lives as long as the command
    options->file = file;
    Command command{
        .name = name, .about = about, .options = options_of(*options, has_query), .run = [options] {
            return run_experiment(*options);
        }};
    if (name == own_experiment)
        command.options.push_back({"FILE", &options->file, required, "its description in JSON"});
    return command;
}

}  // namespace

Command bench_command() {
    // Without a further command, its options run the description samples.json.
    Command bench = experiment_command(
        "bench", "time against error: which method with how many samples, on this device", {}, true);
    for (const fs::path& file : built_in_experiments()) {
        const Experiment what = description_in(file);
        bench.commands.push_back(
            experiment_command(file.stem().string(), what.about, file, what.candidate_query.has_value()));
    }
    bench.commands.push_back(
        experiment_command(own_experiment, "an experiment of your own: copy one of gloam's", {}, false));
    bench.examples =
        "  gloam bench --method gtao hemisphere --samples 4 16 --scene columns\n"
        "  gloam bench --from results.json --error 0.05\n";
    return bench;
}

}  // namespace gloam::cli
