// SPDX-License-Identifier: MIT
#include "cli/bench/experiments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include "cli/arguments.hpp"
#include "cli/bench/experiment_options.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/settings.hpp"
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
    return experiment::read_record(file.string(), read_text(file));
}

int compare_files(const ExperimentOptions& options) {
    const experiment::Comparison found =
        experiment::compared(record_in(options.compare.at(0)), record_in(options.compare.at(1)));
    fmt::print("{}", to_text(found));
    return options.fail_if_worse && found.got_worse() ? 1 : 0;
}

// Prints the tables and the answers, and writes the files.
int report_on(const Experiment& what, const std::vector<gpu::Extent>& sizes, const experiment::Record& record,
              const ExperimentOptions& options, ExperimentFiles& files) {
    const std::vector<experiment::SizeResult> results = results_of(what, sizes, record);
    const experiment::Text tables = to_text(what, results);
    const Measured measured{what, record, results, tables};
    const std::string heading = heading_of(measured);
    const experiment::Answers answers = answers_to(what, results, options.budget, options.error);
    fmt::print("{}{}{}", heading, tables.text, answers.text);
    files.write(measured, heading, versions());
    return !answers.all || (tables.missed && options.fail_if_missed) ? 1 : 0;
}

int report_stored(Experiment what, const ExperimentOptions& options) {
    std::vector<experiment::Record> parts;
    for (const fs::path& file : options.from) parts.push_back(record_in(file));
    const experiment::Record record = experiment::joined(parts);
    const std::vector<gpu::Extent> sizes = choose_recorded(what, record);
    require_consistent(what);
    ExperimentFiles files(options.paths, what);
    return report_on(what, sizes, record, options, files);
}

int run_experiment(const ExperimentOptions& options) {
    if (options.only_single && options.only_temporal)
        throw std::invalid_argument("--temporal and --single: expected one of them, or none for both");
    if (options.resume && options.paths.out.empty())
        throw std::invalid_argument("--resume: expected --out, the folder whose journal is taken up again");
    if (!options.budget.empty()) (void)experiment::time_budget(options.budget);
    if (!options.compare.empty()) return compare_files(options);
    Experiment what = described(options);
    if (!options.from.empty()) return report_stored(std::move(what), options);
    const fs::path meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes;
    choose_candidates(what, options);
    choose_cases(what, options.cases, options.half, meshes);
    std::vector<gpu::Extent> sizes;
    for (const std::string& size : what.sizes) sizes.push_back(image_size(size));
    gpu::Device device = open_device(options.device, options.validation);
    const scene::PassLibrary passes =
        scene::PassLibrary(glsl_directory(), cache_directory()).reading(inputs_named(options.inputs));
    experiment::Place place{.device = device,
                            .passes = passes,
                            .truth_cache = truth_cache_directory(),
                            .meshes = meshes,
                            .preset_of = preset_settings,
                            .progress = progress_bar};
    require_possible(what, place);
    ExperimentFiles files(options.paths, what);
    experiment::Record record({.experiment = what.name,
                               .device = device.info().name,
                               .driver = device.info().driver,
                               .frames = what.frames,
                               .scored = what.scored,
                               .repeat = what.repeat,
                               .rays = what.rays});
    files.open_journal(record, options.resume);
    place.keep = [&](const std::string& line) { files.keep(line); };
    if (files.shows_pictures()) place.show = [&](const experiment::Picture& picture) { files.show(picture); };
    run(what, sizes, place, record);
    const int status = report_on(what, sizes, record, options, files);
    const int messages = validation_status(device);
    return messages == 0 ? status : messages;
}

void add_what(CLI::App& command, ExperimentOptions& options) {
    command.add_option("--size", options.sizes, "WIDTHxHEIGHT of the images, one or more");
    command.add_option("--frames", options.frames, "of each case")->check(CLI::Range(1, 1000));
    command.add_option("--scored", options.scored, "the last ones of these")->check(CLI::Range(1, 1000));
    command.add_option("--rounds,--repeat", options.rounds, "that are timed, 0: only errors")
        ->check(CLI::Range(0, 1000));
    command.add_option("--rays", options.rays, "rays of the truth for each pixel, 0: no errors")
        ->check(CLI::Range(0, 65'536));
    command.add_option("--case,--view,--scene", options.cases, "only these cases");
    command.add_option("--half", options.half, "only the views of this half")
        ->check(CLI::IsMember({"tuning", "unseen"}));
    command.add_option("--meshes", options.meshes,
                       "folder of the views' meshes; without it that of glmark2-data");
}

void add_candidates(CLI::App& command, ExperimentOptions& options) {
    command.add_option("--method", options.methods,
                       "methods with the settings of the cases, instead of the candidates");
    command.add_option("--plain", options.plain,
                       "SLICESxSTEPS+BLURS of single frames of the plain loop, instead of the candidates");
    command.add_option("--single", options.single, "PRESET or PRESET,NAME=VALUE,..., each frame alone");
    command.add_option("--sequence", options.sequence, "the same, in sequence with their history");
    command.add_option("--set", options.set, "NAME=VALUE: any setting of all, lengths for a radius of 1")
        ->allow_extra_args(false);
    command
        .add_option("--depth-thickness", options.depth_thickness,
                    "thickness of the surface of (D), in radii; without it (D) is solid")
        ->check(CLI::PositiveNumber);
    command.add_flag("--no-depth-truth", options.no_depth_truth,
                     "do not trace the depth buffer's truth (D): half the time of a first run");
    command
        .add_option("--inputs", options.inputs,
                    "images that passes only read: sampled, storage, or device (storage on a CPU)")
        ->check(CLI::IsMember({"device", "sampled", "storage"}))
        ->capture_default_str();
}

// Of a description with a query of candidates.
void add_query(CLI::App& command, ExperimentOptions& options) {
    experiment::CandidateQuery& query = options.query.emplace();
    query.samples.clear();
    command.add_option("--method", query.methods,
                       "methods; `all` for all, which is what is measured unless presets are named");
    command.add_option("--preset", query.presets, "presets, measured as they are; `all` for all");
    command.add_option("--samples", query.samples, "samples for each pixel in each frame, of the methods")
        ->check(CLI::Range(1, static_cast<int>(effect::most_samples)));
    command.add_flag("--temporal", options.only_temporal, "only over the frames of a moving camera");
    command.add_flag("--single", options.only_single, "only single frames");
}

void add_answers(CLI::App& command, ExperimentOptions& options) {
    command.add_option("--budget", options.budget, "name the most exact within this time: 1ms, 40copies");
    command.add_option("--error", options.error, "name the fastest with at most this RMSE")
        ->check(CLI::PositiveNumber);
    std::vector<CLI::Option*> measured;
    for (CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (name != "--help" && name != "--budget" && name != "--error") measured.push_back(option);
    }
    CLI::Option* from =
        command.add_option("--from", options.from, "results of --json or --out as one, instead of measuring");
    CLI::Option* compare =
        command.add_option("--compare", options.compare, "two results: what changed from OLD to NEW")
            ->expected(2);
    command
        .add_flag("--fail-if-worse", options.fail_if_worse,
                  "with --compare: status 1 when something got worse beyond its spread")
        ->needs(compare);
    CLI::Option* resume =
        command.add_flag("--resume", options.resume, "measure only what the journal in --out lacks");
    measured.push_back(resume);
    compare->excludes(from);
    for (CLI::Option* option : measured) {  // they cannot be combined with results
        from->excludes(option);
        compare->excludes(option);
    }
}

void add_outputs(CLI::App& command, ExperimentOptions& options) {
    add_device_options(command, options.device, options.validation);
    ExperimentPaths& paths = options.paths;
    command.add_option("--json", paths.json, "write every number to this file");
    command.add_option("--csv", paths.csv, "a line for each candidate of each case");
    command.add_option("--page", paths.page,
                       "page whose blocks of the tables' names, or the experiment's, are written anew");
    command.add_option("--report", paths.report, "write a page with all tables; its plots lie beside it");
    command.add_option("--out", paths.out, "folder for results, plots, pictures and the journal");
    command.add_flag("--fail-if-missed", options.fail_if_missed, "status 1 where a target is missed");
}

void add_options(CLI::App& command, ExperimentOptions& options, bool has_query) {
    add_what(command, options);
    if (has_query)
        add_query(command, options);
    else
        add_candidates(command, options);
    add_answers(command, options);
    add_outputs(command, options);
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
        return experiment::read_experiment(file.string(), read_text(file));
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

}  // namespace

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

std::vector<std::string> with_own_experiment(std::vector<std::string> arguments) {
    if (arguments.size() > 1 && arguments[0] == "bench" && arguments[1].ends_with(".json"))
        arguments.insert(arguments.begin() + 1, own_experiment);
    return arguments;
}

}  // namespace gloam::cli
