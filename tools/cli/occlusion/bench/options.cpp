// SPDX-License-Identifier: MIT
#include "cli/occlusion/bench/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/files.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"

namespace gloam::cli {
namespace {

constexpr const char* default_experiment = "samples.json";  // of `gloam bench` alone
using experiment::Candidate;
using experiment::Experiment;

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

experiment::Kind kind_of(const Candidate& candidate) {
    return candidate.layer.kind.value_or(experiment::Kind::effect);
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
    command.add_option("--budget", options.budget, "name the most exact within this time, such as 1ms");
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
    command.add_option("--report", paths.report, "write a page with all tables");
    command.add_option("--out", paths.out, "folder for results, pictures and the journal");
    command.add_flag("--fail-if-missed", options.fail_if_missed, "status 1 where a target is missed");
}

// Where candidates are a query, any scene may be a case. It is shown as the last case of the description is.
void add_scenes(Experiment& what, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (what.cases.empty() || std::ranges::count(what.cases, name, &experiment::Case::name) > 0) continue;
        experiment::Case scene = what.cases.back();
        scene.name = scene.scene = name;
        what.cases.push_back(std::move(scene));
    }
}

}  // namespace

void add_options(CLI::App& command, ExperimentOptions& options, bool has_query) {
    add_what(command, options);
    if (has_query)
        add_query(command, options);
    else
        add_candidates(command, options);
    add_answers(command, options);
    add_outputs(command, options);
}

Experiment described(const ExperimentOptions& options) {
    const std::filesystem::path file =
        options.file.empty() ? experiments_directory() / default_experiment : options.file;
    Experiment what = experiment::read_experiment(file.string(), base::read_file(file));
    what.name = file.stem().string();
    if (!options.sizes.empty()) what.sizes = options.sizes;
    if (options.query) add_scenes(what, options.cases);
    what.frames = options.frames.value_or(what.frames);
    what.rounds = options.rounds.value_or(what.rounds);
    what.rays = options.rays.value_or(what.rays);
    what.depth_thickness = options.depth_thickness.value_or(what.depth_thickness);
    // Without --scored half of the frames count, if the description's are too many.
    if (what.scored > what.frames) what.scored = std::max(1, what.frames / 2);
    what.scored = options.scored.value_or(what.scored);
    return what;
}

void choose_candidates(Experiment& what, const ExperimentOptions& options) {
    const auto is_depth_truth = [](const Candidate& one) {
        return kind_of(one) == experiment::Kind::depth_truth;
    };
    if (what.candidate_query && options.query) {
        experiment::CandidateQuery& query = *what.candidate_query;
        if (!options.query->methods.empty()) query.methods = options.query->methods;
        if (!options.query->presets.empty()) query.presets = options.query->presets;
        if (!options.query->samples.empty()) query.samples = options.query->samples;
        query.single &= !options.only_temporal;
        query.sequence &= !options.only_single;
    }
    experiment::choose_candidates(what);
    what.candidates = replaced(what.candidates, options);
    if (options.no_depth_truth) std::erase_if(what.candidates, is_depth_truth);
    if (std::ranges::all_of(what.candidates, is_depth_truth))
        throw std::invalid_argument("nothing to measure: give --single, --sequence or --plain");
    for (const std::string& text : options.set)
        for (Candidate& candidate : what.candidates) assign(candidate.layer, text);
}

}  // namespace gloam::cli
