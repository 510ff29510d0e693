// SPDX-License-Identifier: MIT
#include "experiment/internal/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "base/number.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::experiment {
namespace internal {
namespace {

// The text of a value, where "x2" means twice the number that the setting has.
std::string value_text(const effect::Settings& settings, const std::string& name, const std::string& text) {
    if (!text.starts_with('x')) return text;
    const auto value = effect::setting_named(name).get(settings);
    const auto factor = base::number_from<double>(std::string_view(text).substr(1));
    if (!std::holds_alternative<double>(value) || !factor) return text;
    return effect::text_of(*factor * std::get<double>(value));
}

void apply(effect::Settings& settings, const Layer& layer) {
    for (const auto& [name, value] : layer.set) {
        if (name == "method" || name == "radius")
            throw std::invalid_argument(
                fmt::format("set {}: expected a setting other than method and radius", name));
        effect::set(settings, name, value_text(settings, name, value));
    }
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
    for (const Layer* layer : layers) apply(subject.settings, *layer);
    validate(subject.settings);
    return subject;
}

}  // namespace

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

std::set<Quantity> measured_by(const Experiment& experiment) {
    std::set<Quantity> measured;
    for (const Table& table : experiment.tables)
        measured.insert(table.measures.begin(), table.measures.end());
    return measured;
}

}  // namespace internal

namespace {

using internal::Subject;
using internal::subject_of;
using internal::takes_part;

void require_possible(const Experiment& experiment, const Case& one, const Candidate& candidate,
                      const Place& place) {
    const Subject subject = subject_of(experiment, one, candidate, place);
    const bool judged = frames_of(experiment, one, {}).rays > 0 && subject.kind == Kind::effect;
    if (subject.enough_samples && !judged)
        throw std::invalid_argument(
            fmt::format("{}, {}: enough_samples: expected rays and the effect", one.name, candidate.name));
}

}  // namespace

void require_possible(const Experiment& experiment, const Place& place) {
    if (experiment.candidates.empty()) throw std::invalid_argument("nothing to measure: no candidate");
    require_consistent(experiment);
    for (const Case& one : experiment.cases) {
        if (one.closed_form) {
            (void)closed_form_of(one);
            if (experiment.frames < 2)
                throw std::invalid_argument(
                    fmt::format("{}: {} frames, expected 2 or more", one.name, experiment.frames));
        } else if (!one.view) {
            (void)scene::make_scene(one.scene, place.meshes);  // a view's meshes are read when it is measured
        }
        const BenchmarkFrames frames = frames_of(experiment, one, {});
        if (frames.scored > frames.frames)
            throw std::invalid_argument(fmt::format("{}: {} scored frames, expected at most {}, the frames",
                                                    one.name, frames.scored, frames.frames));
        for (const Candidate& candidate : experiment.candidates)
            if (takes_part(one, candidate)) require_possible(experiment, one, candidate, place);
    }
}

}  // namespace gloam::experiment
