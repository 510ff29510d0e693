// SPDX-License-Identifier: MIT
#include "experiment/runner.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>

#include "base/number.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "experiment/internal/subject.hpp"
#include "experiment/table.hpp"
#include "scene/scene.hpp"

namespace gloam::experiment {
namespace {

constexpr std::uint32_t most_taps = 64;

// Views with moving objects are judged by class of pixel, so they have no part in the means over all others.
std::vector<Case> views_of(const CaseQuery& query) {
    std::vector<Case> cases;
    for (const scene::ViewInfo& info : scene::all_views())
        if (!info.half.empty() && (info.kind == "motion") == (query.all == "motion"))
            cases.push_back({.name = info.name, .kind = info.kind, .half = info.half, .scene = info.name});
    return cases;
}

// These, or with "all" among them the names of all items.
template <class Items>
std::vector<std::string> chosen(const std::vector<std::string>& names, const Items& items) {
    if (std::ranges::count(names, "all") == 0) return names;
    std::vector<std::string> all;
    for (const auto& item : items) all.push_back(item.name);
    return all;
}

// The method as it is, and its presets of a source whose names end with "quality".
void add_as_they_are(std::vector<Candidate>& candidates, const std::string& method) {
    candidates.push_back({.name = method, .group = "methods", .layer = {.method = method}});
    for (const effect::Preset& preset : effect::presets())
        if (preset.settings.method == method && preset.settings.passes == effect::Passes::study &&
            preset.name.ends_with("quality"))
            candidates.push_back({.name = preset.name, .group = "methods", .layer = {.preset = preset.name}});
}

const char* mode_of(bool sequence) {
    return sequence ? "temporal" : "single";
}

// Around the method is the preset `tssao-paper`, in sequences with a mean over at least two frames.
// Every pixel takes so many samples in every frame.
Candidate method_candidate(const std::string& method, int samples, bool sequence) {
    const char* preset = "tssao-paper";
    Candidate made{.name = fmt::format("{}/{}/{}", method, samples, mode_of(sequence)),
                   .group = fmt::format("{}{}", method, sequence ? ", temporal" : "")};
    made.layer = {.kind = Kind::effect, .preset = preset, .method = method, .sequence = sequence};
    const std::string count = std::to_string(samples);
    made.layer.set = {{"samples", count}, {"samples_converged", count}};
    const float weight = 2.0F * static_cast<float>(samples);
    if (sequence && weight > with_method(effect::preset_named(preset).settings, method).weight_max)
        made.layer.set.emplace_back("weight_max", std::to_string(2 * samples));
    return made;
}

Candidate preset_candidate(const std::string& name, bool sequence) {
    Candidate made{
        .name = fmt::format("{}/{}/{}", name, effect::preset_named(name).settings.samples, mode_of(sequence)),
        .group = "presets"};
    made.layer = {.kind = Kind::effect, .preset = name, .sequence = sequence};
    return made;
}

void require_names(const std::vector<Case>& cases, const std::vector<std::string>& names) {
    std::string known;
    for (const Case& one : cases)
        if (known.find(one.name) == std::string::npos) known += (known.empty() ? "" : ", ") + one.name;
    for (const std::string& name : names)
        if (std::ranges::find(cases, name, &Case::name) == cases.end())
            throw std::invalid_argument(fmt::format("case {}: expected {}", name, known));
}

// What the SELECT compares candidates with. One that is misspelt would be a column of nothing.
std::vector<std::string> candidates_in(const Table& table) {
    constexpr std::string_view before = "candidate = '";
    std::vector<std::string> names;
    for (const std::string& line : table.select) {
        for (std::size_t at = line.find(before); at != std::string::npos; at = line.find(before, at)) {
            at += before.size();
            std::string name = line.substr(at, line.find('\'', at) - at);
            if (name != "{}") names.push_back(std::move(name));
        }
    }
    return names;
}

// The columns, and tables, that need a quantity.
const std::pair<Quantity, std::vector<std::string>> columns[] = {
    {Quantity::depth, {"rmse_depth", "rmse_depth_raw", "converged_depth"}},
    {Quantity::converged,
     {"converged_rmse", "converged_bias", "converged_remapped", "converged_similarity", "converged_depth",
      "converged_own"}},
    {Quantity::remapped, {"rmse_remapped"}},
    {Quantity::fit, {"rmse_fit"}},
    {Quantity::own_radius, {"rmse_own_radius"}},
    {Quantity::by_class, {"class_errors", "class_frames"}}};

// A SELECT of a table finds the columns alone that it measures.
void require_measured(const Table& table) {
    std::set<std::string> without;
    for (const auto& [quantity, names] : columns)
        if (std::ranges::count(table.measures, quantity) == 0) without.insert(names.begin(), names.end());
    try {
        (void)Database(Record({}), nullptr, without).select(fmt::format("{}", fmt::join(table.select, "\n")));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("a table: {}, expected in its \"measures\" what it reads: {}",
                                             error.what(), fmt::join(quantities(), ", ")));
    }
}

// The text of a value, where "x2" means twice the number that the setting has.
std::string value_text(const effect::Settings& settings, const std::string& name, const std::string& text) {
    if (!text.starts_with('x')) return text;
    const auto value = effect::setting_named(name).get(settings);
    const auto factor = base::number_from<double>(std::string_view(text).substr(1));
    if (!std::holds_alternative<double>(value) || !factor) return text;
    return effect::text_of(*factor * std::get<double>(value));
}

Subject subject_of(const std::vector<const Layer*>& layers, const Place& place) {
    Subject subject;
    std::string preset;
    std::string method;
    for (const Layer* layer : layers) {
        if (!layer->preset.empty()) preset = layer->preset;
        if (!layer->method.empty()) method = layer->method;
        subject.sequence = layer->sequence.value_or(subject.sequence);
        subject.hoisted = layer->hoisted.value_or(subject.hoisted);
        subject.radius = layer->radius.value_or(subject.radius);
        subject.enough_samples |= layer->enough_samples;
        if (!layer->pictures.empty()) subject.pictures = layer->pictures;
        if (!layer->kind) continue;
        subject.kind = *layer->kind;
        subject.plain = layer->plain;
    }
    if (!preset.empty()) subject.settings = place.preset_of(preset);
    if (!method.empty() && method != subject.settings.method)
        subject.settings = with_method(subject.settings, method);
    for (const Layer* layer : layers) {
        for (const auto& [name, value] : layer->set) {
            if (name == "method" || name == "radius")
                throw std::invalid_argument(
                    fmt::format("set {}: expected a setting other than method and radius", name));
            effect::set(subject.settings, name, value_text(subject.settings, name, value));
        }
    }
    validate(subject.settings);
    return subject;
}

}  // namespace

void require_consistent(const Experiment& experiment) {
    std::set<std::string> names;
    for (const Candidate& candidate : experiment.candidates)
        if (!names.insert(candidate.name).second)
            throw std::invalid_argument(
                fmt::format("candidates: \"{}\" twice, expected once", candidate.name));
    const auto require = [&](const std::string& name, const char* where) {
        if (!names.contains(name))
            throw std::invalid_argument(
                fmt::format("{}: \"{}\", expected one of {}", where, name, fmt::join(names, ", ")));
    };
    std::set<std::tuple<std::string, std::string, std::string>> cases;
    for (const Case& one : experiment.cases)
        if (!cases.insert({one.name, one.kind, one.what}).second)
            throw std::invalid_argument(fmt::format("cases: \"{}\" twice, expected once", one.name));
    for (const Case& one : experiment.cases)
        for (const std::string& name : one.candidates) require(name, "a case's candidates");
    for (const Table& table : experiment.tables)
        for (const std::string& name : candidates_in(table)) require(name, "a table's candidate");
    try {
        (void)to_text(experiment, Database(Record({})));
        for (const Table& table : experiment.tables) require_measured(table);
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(error.what());
    }
}

void choose_candidates(Experiment& experiment) {
    if (!experiment.candidate_query) return;
    CandidateQuery query = *std::exchange(experiment.candidate_query, std::nullopt);
    if (query.methods.empty() && query.presets.empty()) query.methods = {"all"};
    const std::vector<std::string> methods = chosen(query.methods, effect::methods());
    if (query.samples.empty())
        for (const std::string& method : methods) add_as_they_are(experiment.candidates, method);
    for (const bool sequence : {false, true}) {
        if (!(sequence ? query.sequence : query.single)) continue;
        for (const std::string& method : methods)
            for (const int samples : query.samples)
                experiment.candidates.push_back(method_candidate(method, samples, sequence));
        for (const std::string& preset : chosen(query.presets, effect::presets()))
            experiment.candidates.push_back(preset_candidate(preset, sequence));
    }
    if (experiment.candidates.empty())
        throw std::invalid_argument("nothing to measure: expected a method or preset");
}

PlainLoop plain_loop(std::string_view text) {
    const auto number = [&](std::string_view part, std::uint32_t least, std::uint32_t most) {
        const auto value = base::number_from<std::uint32_t>(part);
        if (value && *value >= least && *value <= most) return *value;
        throw std::invalid_argument(fmt::format(
            "{}: expected SLICESxSTEPS+BLURS, at most {} slices and steps and 9 blurs, such as 3x3+2", text,
            most_taps));
    };
    const std::string_view taps = text.substr(0, text.find('+'));
    const std::size_t times = std::min(taps.find('x'), taps.size());
    const std::string_view steps = taps.substr(std::min(times + 1, taps.size()));
    const std::string_view blurs = taps == text ? "0" : text.substr(taps.size() + 1);
    return {{.slices = number(taps.substr(0, times), 1, most_taps), .steps = number(steps, 1, most_taps)},
            static_cast<int>(number(blurs, 0, 9))};
}

void choose_cases(Experiment& experiment, const std::vector<std::string>& names, const std::string& half,
                  const std::filesystem::path& meshes) {
    const CaseQuery query = experiment.query.value_or(CaseQuery{});
    if (!half.empty() && !experiment.query)
        throw std::invalid_argument(fmt::format("{} half: expected an experiment on all views", half));
    if (experiment.query) experiment.cases = views_of(query);
    require_names(experiment.cases, names);
    const std::string wanted = half.empty() ? query.half : half;
    std::erase_if(experiment.cases, [&](const Case& one) {
        if (!names.empty() && std::ranges::count(names, one.name) == 0) return true;
        if (!wanted.empty() && one.half != wanted) return true;
        return query.perspective &&
               scene::make_scene(one.scene, meshes).camera.projection == scene::Projection::orthographic;
    });
    experiment.query.reset();
    if (experiment.cases.empty())
        throw std::invalid_argument(query.perspective ? "no perspective view of this half"
                                                      : "no view of this half");
}

scene::ClosedFormView closed_form_of(const Case& one) {
    std::string known;
    for (scene::ClosedFormView& view : scene::closed_form_views(scene::Projection::perspective)) {
        if (view.scene.name == one.scene) return std::move(view);
        known += (known.empty() ? "" : ", ") + view.scene.name;
    }
    throw std::invalid_argument(fmt::format("closed_form {}: expected {}", one.scene, known));
}

BenchmarkFrames frames_of(const Experiment& experiment, const Case& one, backend::Extent extent) {
    BenchmarkFrames frames{.extent = extent,
                           .frames = experiment.frames,
                           .scored = one.scored.value_or(experiment.scored),
                           .every = one.every.value_or(experiment.every),
                           .rays = experiment.rays,
                           .depth_thickness = experiment.depth_thickness,
                           .repeat = experiment.repeat,
                           .motion = one.motion,
                           .still = one.still,
                           .shown = one.shown};
    if (!one.shown.empty()) frames.frames = std::accumulate(one.shown.begin(), one.shown.end(), 0);
    return frames;
}

bool takes_part(const Case& one, const Candidate& candidate) {
    return one.candidates.empty() || std::ranges::count(one.candidates, candidate.name) > 0;
}

Subject subject_of(const Experiment& experiment, const Case& one, const Candidate& candidate,
                   const Place& place) {
    try {
        return subject_of({&experiment.layer, &one.layer, &candidate.layer}, place);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}, {}: {}", one.name, candidate.name, error.what()));
    }
}

void require_possible(const Experiment& experiment, const Place& place) {
    if (experiment.candidates.empty()) throw std::invalid_argument("nothing to measure: no candidate");
    require_consistent(experiment);
    for (const Case& one : experiment.cases) {
        if (one.closed_form) {
            (void)closed_form_of(one);
            if (experiment.frames < 2)
                throw std::invalid_argument(
                    fmt::format("{}: {} frames, expected 2 or more", one.name, experiment.frames));
        } else if (std::ranges::count(scene::all_views(), one.scene, &scene::ViewInfo::name) == 0) {
            (void)scene::make_scene(one.scene);  // lists the names
        }
        const BenchmarkFrames frames = frames_of(experiment, one, {});
        if (frames.scored > frames.frames)
            throw std::invalid_argument(fmt::format("{}: {} scored frames, expected at most {}, the frames",
                                                    one.name, frames.scored, frames.frames));
        for (const Candidate& candidate : experiment.candidates) {
            if (!takes_part(one, candidate)) continue;
            const Subject subject = subject_of(experiment, one, candidate, place);
            if (subject.enough_samples && (frames.rays == 0 || subject.kind != Kind::effect))
                throw std::invalid_argument(fmt::format(
                    "{}, {}: enough_samples: expected rays and the effect", one.name, candidate.name));
        }
    }
}

}  // namespace gloam::experiment
