// SPDX-License-Identifier: MIT
#include "cli/occlusion/bench/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/files.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/settings.hpp"

namespace gloam::cli {
namespace {

constexpr const char* default_experiment = "samples.json";  // of `gloam bench` alone
using experiment::Candidate;
using experiment::Experiment;
using experiment::Kind;

// NAME=VALUE: the method, or a setting.
void assign(experiment::Layer& layer, const std::string& text) {
    auto [name, value] = assignment_of(text);
    if (name == "method")
        layer.method = std::move(value);
    else
        layer.set.emplace_back(std::move(name), std::move(value));
}

// PRESET[,NAME=VALUE...].
Candidate preset_candidate(const std::string& text, bool sequence) {
    std::istringstream parts(text);
    Candidate made{.name = text + (sequence ? ", sequence" : ", single"),
                   .layer = {.kind = Kind::effect, .sequence = sequence}};
    std::getline(parts, made.layer.preset, ',');
    for (std::string part; std::getline(parts, part, ',');) assign(made.layer, part);
    return made;
}

// SLICESxSTEPS+BLURS.
Candidate plain_candidate(const std::string& text) {
    const experiment::PlainLoop loop = experiment::plain_loop(text);
    const std::string blurs = loop.blurs == 0   ? ""
                              : loop.blurs == 1 ? " and a blur"
                                                : fmt::format(" and {} blurs", loop.blurs);
    return {.name = fmt::format("plain loop, {} x {}{}", loop.taps.slices, loop.taps.steps, blurs),
            .layer = {.kind = Kind::plain, .plain = loop}};
}

// Candidates of one sort, which an option may replace: of a kind, and of the effect in sequence or not.
using Sort = std::pair<Kind, bool>;
Sort sort_of(const Candidate& one) {
    const Kind kind = one.layer.kind.value_or(Kind::effect);
    return {kind, kind == Kind::effect && one.layer.sequence.value_or(true)};
}

// Candidates of an option replace those of its sort in the description, or all that there are.
std::vector<Candidate> replaced(const std::vector<Candidate>& candidates, const ExperimentOptions& options) {
    std::vector<Candidate> chosen;
    for (const std::string& method : options.methods)
        chosen.push_back({.name = method, .layer = {.kind = Kind::effect, .method = method}});
    if (!chosen.empty()) return chosen;
    std::map<Sort, std::vector<Candidate>> given;
    for (const std::string& text : options.plain)
        given[{Kind::plain, false}].push_back(plain_candidate(text));
    for (const bool sequence : {false, true})
        for (const std::string& text : sequence ? options.sequence : options.single)
            given[{Kind::effect, sequence}].push_back(preset_candidate(text, sequence));
    if (given.empty()) return candidates;
    for (const Sort& sort : {Sort(Kind::plain, false), Sort(Kind::effect, false), Sort(Kind::effect, true),
                             Sort(Kind::depth_truth, false)})
        std::ranges::copy_if(given.contains(sort) ? given[sort] : candidates, std::back_inserter(chosen),
                             [&](const Candidate& one) { return sort_of(one) == sort; });
    return chosen;
}

// The cases, and how they are measured.
std::vector<Option> what_options(ExperimentOptions& options) {
    return {{"--size", &options.sizes, "WIDTHxHEIGHT of the images, one or more"},
            {"--frames", &options.frames, between(1, 1000), "of each case"},
            {"--scored", &options.scored, between(1, 1000), "the last ones of these"},
            {"--rounds,--repeat", &options.rounds, between(0, 1000), "that are timed, 0: only errors"},
            {"--rays", &options.rays, between(0, 65'536), "rays of the truth for each pixel, 0: no errors"},
            {"--case,--view,--scene", &options.cases, "only these cases"},
            {"--half", &options.half, one_of({"tuning", "unseen"}), "only the views of this half"},
            {"--meshes", &options.meshes, "folder of the views' meshes; without it that of glmark2-data"}};
}

std::vector<Option> candidate_options(ExperimentOptions& options) {
    return {
        {"--method", &options.methods, "methods with the settings of the cases, instead of the candidates"},
        {"--plain", &options.plain,
         "SLICESxSTEPS+BLURS of single frames of the plain loop, instead of the candidates"},
        {"--single", &options.single, "PRESET or PRESET,NAME=VALUE,..., each frame alone"},
        {"--sequence", &options.sequence, "the same, in sequence with their history"},
        {"--set", &options.set, repeated, "NAME=VALUE: any setting of all, lengths for a radius of 1"},
        {"--depth-thickness", &options.depth_thickness, positive,
         "thickness of the surface of (D), in radii; without it (D) is solid"},
        {"--no-depth-truth", &options.no_depth_truth,
         "do not trace the depth buffer's truth (D): half the time of a first run"},
        {"--inputs", &options.inputs, one_of({"device", "sampled", "storage"}),
         "images that passes only read: sampled, storage, or device (storage on a CPU)"}};
}

// Of a description with a query of candidates.
std::vector<Option> query_options(ExperimentOptions& options) {
    experiment::CandidateQuery& query = options.query.emplace();
    query.samples.clear();
    return {{"--method", &query.methods,
             "methods; `all` for all, which is what is measured unless presets are named"},
            {"--preset", &query.presets, "presets, measured as they are; `all` for all"},
            {"--samples", &query.samples, between(1, effect::most_samples),
             "samples for each pixel in each frame, of the methods"},
            {"--temporal", [&query] { query.single = false; }, "only over the frames of a moving camera"},
            {"--single", [&query] { query.sequence = false; }, "only single frames"}};
}

// What is answered, and files.
std::vector<Option> answer_options(ExperimentOptions& options) {
    return {{"--budget", &options.budget, "name the most exact within this time, such as 1ms"},
            {"--error", &options.error, positive, "name the fastest with at most this RMSE"},
            {"--from", &options.from, "results of --json or --out as one, instead of measuring"},
            {"--compare", &options.compare, excludes("--from", Rules{.words = 2}),
             "two results: what changed from OLD to NEW"},
            {"--fail-if-worse", &options.fail_if_worse, needs("--compare"),
             "with --compare: status 1 when something got worse beyond its spread"},
            {"--resume", &options.resume, excludes("--compare", excludes("--from")),
             "measure only what the journal in --out lacks"},
            device_option(options.device),
            validation_option(options.validation),
            driver_option(),
            {"--json", &options.json, "write every number to this file"},
            {"--csv", &options.csv, "a line for each candidate of each case"},
            {"--page", &options.page,
             "page whose blocks of the tables' names, or the experiment's, are written anew"},
            {"--report", &options.report, "write a page with all tables"},
            {"--out", &options.out, "folder for results, pictures and the journal"},
            {"--fail-if-missed", &options.fail_if_missed, "status 1 where a target is missed"}};
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

std::vector<Option> options_of(ExperimentOptions& options, bool has_query) {
    std::vector<Option> all = what_options(options);
    std::ranges::move(has_query ? query_options(options) : candidate_options(options),
                      std::back_inserter(all));
    for (Option& measured : all) measured.rules.excludes = {"--from", "--compare"};
    std::ranges::move(answer_options(options), std::back_inserter(all));
    return all;
}

Experiment described(const ExperimentOptions& options) {
    const std::filesystem::path file =
        options.file.empty() ? data_directory("experiments") / default_experiment : options.file;
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
    const auto is_depth_truth = [](const Candidate& one) { return one.layer.kind == Kind::depth_truth; };
    if (what.candidate_query && options.query) {
        experiment::CandidateQuery& query = *what.candidate_query;
        if (!options.query->methods.empty()) query.methods = options.query->methods;
        if (!options.query->presets.empty()) query.presets = options.query->presets;
        if (!options.query->samples.empty()) query.samples = options.query->samples;
        query.single &= options.query->single;
        query.sequence &= options.query->sequence;
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
