// SPDX-License-Identifier: MIT
#include "cli/bench/experiment_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "cli/arguments.hpp"
#include "cli/environment.hpp"

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

// Where candidates are a query, any scene may be a case. It is shown as the last case of the description is.
void add_scenes(Experiment& what, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::find(what.cases, name, &experiment::Case::name) != what.cases.end()) continue;
        experiment::Case scene = what.cases.back();
        scene.name = scene.scene = name;
        what.cases.push_back(std::move(scene));
    }
}

}  // namespace

Experiment described(const ExperimentOptions& options) {
    const std::filesystem::path file =
        options.file.empty() ? experiments_directory() / default_experiment : options.file;
    Experiment what = experiment::read_experiment(file.string(), read_text(file));
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
