// SPDX-License-Identifier: MIT
#include "cli/bench/experiments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/text.hpp"
#include "cli/arguments.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/settings.hpp"
#include "experiment/experiment.hpp"
#include "experiment/runner.hpp"
#include "experiment/table.hpp"
#include "experiment/values.hpp"
#include "numeric/numbers.hpp"
#include "report/output_file.hpp"
#include "report/output_folder.hpp"
#include "report/plot.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
constexpr const char* own_experiment = "FILE.json";
using experiment::Candidate;
using experiment::Experiment;

// What the options of a call change in a description.
struct ExperimentOptions {
    fs::path file;
    std::vector<std::string> sizes;
    std::optional<int> frames;
    std::optional<int> scored;
    std::optional<int> rounds;
    std::optional<int> rays;
    std::optional<double> depth_thickness;
    std::vector<std::string> cases;
    std::string half;
    std::vector<std::string> methods;
    std::vector<std::string> plain;     // SLICESxSTEPS+BLURS
    std::vector<std::string> single;    // PRESET[,NAME=VALUE...]
    std::vector<std::string> sequence;  // the same
    std::vector<std::string> set;       // NAME=VALUE, of all candidates
    bool no_depth_truth = false;
    std::string inputs = "device";
    fs::path meshes;
    bool fail_if_missed = false;
    std::string device;
    bool validation = false;
    fs::path json;
    fs::path page;
    fs::path out;
};

scene::Inputs inputs_named(const std::string& name) {
    if (name == "sampled") return scene::Inputs::sampled;
    if (name == "storage") return scene::Inputs::storage;
    return scene::Inputs::by_device;
}

// NAME=VALUE: the method, or a setting.
void assign(experiment::Layer& layer, const std::string& text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos)
        throw std::invalid_argument(fmt::format("--set {}: expected NAME=VALUE (gloam list settings)", text));
    const std::string name = text.substr(0, sign);
    const std::string value = text.substr(sign + 1);
    if (name == "method")
        layer.method = value;
    else
        layer.set.emplace_back(name, value);
}

// PRESET[,NAME=VALUE...].
Candidate preset_candidate(const std::string& text, bool sequence) {
    std::vector<std::string> parts = CLI::detail::split(text, ',');
    Candidate made{.name = text + (sequence ? ", sequence" : ", single")};
    made.layer.kind = experiment::Kind::effect;
    made.layer.preset = parts.front();
    made.layer.sequence = sequence;
    for (std::size_t i = 1; i < parts.size(); ++i) assign(made.layer, parts[i]);
    return made;
}

Candidate method_candidate(const std::string& method) {
    Candidate made{.name = method};
    made.layer.kind = experiment::Kind::effect;
    made.layer.method = method;
    return made;
}

// SLICESxSTEPS+BLURS.
Candidate plain_candidate(const std::string& text) {
    const experiment::PlainLoop loop = experiment::plain_loop(text);
    const std::string blurs = loop.blurs == 0   ? ""
                              : loop.blurs == 1 ? " and a blur"
                                                : fmt::format(" and {} blurs", loop.blurs);
    Candidate made{.name = fmt::format("plain loop, {} x {}{}", loop.taps.slices, loop.taps.steps, blurs)};
    made.layer.kind = experiment::Kind::plain;
    made.layer.plain = loop;
    return made;
}

// A candidate that says nothing is what the cases say: a plain loop.
experiment::Kind kind_of(const Candidate& candidate) {
    const experiment::Layer& layer = candidate.layer;
    const bool silent = layer.preset.empty() && layer.method.empty() && layer.set.empty();
    return layer.kind.value_or(silent ? experiment::Kind::plain : experiment::Kind::effect);
}

// Candidates of an option replace those of its sort in the description.
std::vector<Candidate> replaced(const std::vector<Candidate>& candidates, const ExperimentOptions& options) {
    std::vector<Candidate> chosen;
    std::ranges::transform(options.methods, std::back_inserter(chosen), method_candidate);
    if (!chosen.empty()) return chosen;
    if (options.plain.empty() && options.single.empty() && options.sequence.empty()) return candidates;
    const auto add = [&](const std::vector<std::string>& texts, const auto& made, const auto& of_its_sort) {
        for (const std::string& text : texts) chosen.push_back(made(text));
        if (texts.empty()) std::ranges::copy_if(candidates, std::back_inserter(chosen), of_its_sort);
    };
    const auto effects = [&](const std::vector<std::string>& texts, bool sequence) {
        add(
            texts, [&](const std::string& text) { return preset_candidate(text, sequence); },
            [&](const Candidate& one) {
                return kind_of(one) == experiment::Kind::effect &&
                       one.layer.sequence.value_or(true) == sequence;
            });
    };
    add(options.plain, plain_candidate,
        [](const Candidate& one) { return kind_of(one) == experiment::Kind::plain; });
    effects(options.single, false);
    effects(options.sequence, true);
    add({}, plain_candidate,
        [](const Candidate& one) { return kind_of(one) == experiment::Kind::depth_truth; });
    return chosen;
}

void choose_candidates(Experiment& what, const ExperimentOptions& options) {
    const auto is_depth_truth = [](const Candidate& one) {
        return kind_of(one) == experiment::Kind::depth_truth;
    };
    what.candidates = replaced(what.candidates, options);
    if (options.no_depth_truth) std::erase_if(what.candidates, is_depth_truth);
    if (std::ranges::all_of(what.candidates, is_depth_truth))
        throw std::invalid_argument("nothing to measure: give --single, --sequence or --plain");
    for (const std::string& text : options.set)
        for (Candidate& candidate : what.candidates) assign(candidate.layer, text);
}

// What the options say counts, instead of the description.
Experiment chosen_from(const ExperimentOptions& options, const fs::path& meshes) {
    Experiment what = experiment::read_experiment(options.file.string(), read_text(options.file));
    what.name = options.file.stem().string();
    if (!options.sizes.empty()) what.sizes = options.sizes;
    what.frames = options.frames.value_or(what.frames);
    what.scored = options.scored.value_or(what.scored);
    what.rounds = options.rounds.value_or(what.rounds);
    what.rays = options.rays.value_or(what.rays);
    what.depth_thickness = options.depth_thickness.value_or(what.depth_thickness);
    choose_candidates(what, options);
    choose_cases(what, options.cases, options.half, meshes);
    return what;
}

std::string heading(const Experiment& what, const std::vector<experiment::SizeResult>& results,
                    const gpu::DeviceInfo& device) {
    std::string text =
        fmt::format("{} cases on {} ({})", results.front().cases.size(), device.name, device.driver);
    for (const experiment::SizeResult& result : results) {
        text += fmt::format(",\n{} x {} pixels", result.extent.width, result.extent.height);
        if (what.rounds > 0) text += fmt::format(" (a copy takes {:.3f} ms)", copy_ms(result));
    }
    text += fmt::format(", {} rounds", what.rounds);
    if (what.rays > 0)
        text += fmt::format(",\nthe last {} of {} frames, the truth of {} rays a pixel", what.scored,
                            what.frames, what.rays);
    return text + ".\n";
}

// Blocks of a page: of the tables that have names, or one of all.
std::vector<PageBlock> blocks_of(const Experiment& what, const experiment::Text& tables) {
    std::vector<PageBlock> blocks;
    for (const experiment::Table& table : what.tables)
        if (!table.name.empty())
            blocks.push_back(
                {table.name, tables.named.contains(table.name) ? tables.named.at(table.name) : ""});
    if (blocks.empty()) blocks.push_back({what.name, tables.text});
    return blocks;
}

// A plot of time for each kind of case in which something grows.
void write_plots(report::OutputFolder& folder, const Experiment& what,
                 const std::vector<experiment::SizeResult>& results, const gpu::DeviceInfo& device) {
    for (const experiment::SizeResult& result : results) {
        std::map<std::string, report::Plot> plots;  // by kind
        for (experiment::Growth& growth : growths(what, result)) {
            report::Plot& plot = plots[growth.kind];
            plot.title = fmt::format("time against {}, {}", growth.kind, device.name);
            plot.x = growth.kind;
            plot.y = "all passes, ms";
            plot.logarithmic = true;
            plot.curves.push_back({.name = fmt::format("{}, exponent {:.2f}", growth.candidate,
                                                       numeric::exponent_of(growth.points)),
                                   .points = std::move(growth.points)});
        }
        for (const auto& [kind, plot] : plots) {
            const std::string size = results.size() == 1 ? "" : "-" + experiment::size_text(result.extent);
            std::string name = fmt::format("{}-{}{}", what.name, kind, size);
            std::erase(name, ',');
            std::ranges::replace(name, ' ', '-');
            name = base::file_name_of(name);
            folder.write(name + ".svg", report::to_svg(plot));
            folder.write(name + ".png", report::to_png(plot));
        }
    }
    folder.keep();
}

int run_experiment(const ExperimentOptions& options) {
    const fs::path meshes = options.meshes.empty() ? scene::installed_meshes() : options.meshes;
    const Experiment what = chosen_from(options, meshes);
    std::vector<gpu::Extent> sizes;
    for (const std::string& size : what.sizes) sizes.push_back(image_size(size));
    const std::string old_page = options.page.empty() ? "" : read_page(options.page);
    if (!options.page.empty()) (void)with_blocks(old_page, blocks_of(what, {}));
    const report::OutputFile page(options.page);
    std::optional<report::OutputFolder> out;
    if (!options.out.empty()) out.emplace(options.out);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const scene::PassLibrary passes =
        scene::PassLibrary(glsl_directory(), cache_directory()).reading(inputs_named(options.inputs));
    const experiment::Place place{.device = device,
                                  .passes = passes,
                                  .truth_cache = truth_cache_directory(),
                                  .meshes = meshes,
                                  .preset_of = preset_settings,
                                  .progress = progress_bar};
    const std::vector<experiment::SizeResult> results = run(what, sizes, place);
    experiment::Text tables = to_text(what, results);
    tables.text = heading(what, results, device.info()) + tables.text;
    fmt::print("{}", tables.text);
    json.write(to_json(what, results, device.info(), versions()));
    if (!options.page.empty()) page.write(with_blocks(old_page, blocks_of(what, tables)));
    if (out) write_plots(*out, what, results, device.info());
    const int messages = validation_status(device);
    return tables.missed && options.fail_if_missed ? 1 : messages;
}

void add_what(CLI::App& command, ExperimentOptions& options) {
    command.add_option("--size", options.sizes, "WIDTHxHEIGHT of the images, one or more");
    command.add_option("--frames", options.frames, "of each case")->check(CLI::Range(1, 1000));
    command.add_option("--scored", options.scored, "the last ones of these")->check(CLI::Range(1, 1000));
    command.add_option("--rounds", options.rounds, "that are timed, 0: only errors")
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

CLI::App& add_command(CLI::App& bench, const std::string& name, const std::string& about,
                      const std::shared_ptr<ExperimentOptions>& options, int& status) {
    CLI::App* command = bench.add_subcommand(name, about);
    add_what(*command, *options);
    add_candidates(*command, *options);
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page,
                        "page whose blocks of the tables' names, or the experiment's, are written anew");
    command->add_option("--out", options->out, "folder for plots of what grows");
    command->add_flag("--fail-if-missed", options->fail_if_missed, "status 1 where a target is missed");
    command->callback([options, &status] { status = run_experiment(*options); });
    return *command;
}

// The first line of help of a description; empty where it cannot be read.
std::string about_of(const fs::path& file) {
    try {
        return experiment::read_experiment(file.string(), read_text(file)).about;
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
    for (const fs::path& file : built_in_experiments()) {
        auto options = std::make_shared<ExperimentOptions>();
        options->file = file;
        (void)add_command(bench, file.stem().string(), about_of(file), options, status);
    }
    auto options = std::make_shared<ExperimentOptions>();
    add_command(bench, own_experiment, "an experiment of your own: copy one of gloam's", options, status)
        .add_option("FILE", options->file, "its description in JSON")
        ->required();
}

std::vector<std::string> with_own_experiment(std::vector<std::string> arguments) {
    if (arguments.size() > 1 && arguments[0] == "bench" && arguments[1].ends_with(".json"))
        arguments.insert(arguments.begin() + 1, own_experiment);
    return arguments;
}

}  // namespace gloam::cli
