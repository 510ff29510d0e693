// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "record/check_report.hpp"
#include "record/members.hpp"

// The members of answers and devices, for files and between processes.
namespace gloam::record {

template <>
inline constexpr Names names_of<judge::Reason>{
    base::reason_names.size(),
    "\"\", crash, hang, device lost, out of memory, error, fault, race or divergent barrier"};
template <>
inline constexpr Names names_of<judge::Criterion>{2, "budget or rules"};
template <>
inline constexpr Names names_of<judge::NoResult>{2, "undefined or too long"};
template <>
inline constexpr Names names_of<judge::InputClass>{judge::input_class_count, "a class of inputs"};

// All that follows from an answer's members: the worst input without its fractions, the first unbounded input
// as text alone, and no first failures. Throws where members disagree.
void complete(const JsonReader& json, judge::Answer& answer);

GLOAM_MEMBERS(numeric::Bounds, low, high, nan)

template <class Io>
void members(Io& io, judge::ClassCount& c) {
    each(io, "inputs", c.inputs, "outside", c.outside, "recorded", c.recorded);
    io.member("open", c.open, Present::later);
    io.require(c.recorded <= c.inputs && c.open <= c.inputs - c.recorded && c.outside <= c.inputs,
               "counts within its inputs");
}

template <class Io>
void members(Io& io, judge::PredicateCount& c) {
    each(io, "inputs", c.inputs, "judged", c.judged);
    io.require(c.judged <= c.inputs, "counts within its inputs");
}

// The classes that had inputs.
template <class Io>
void members(Io& io, std::array<judge::ClassCount, judge::input_class_count>& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i)
        io.member(name_of(static_cast<judge::InputClass>(i)).data(), counts[i], Present::if_any);
}

template <class Io>
void members(Io& io, std::array<judge::PredicateCount, 2>& counts) {
    each<Present::if_any>(io, "false", counts[0], "true", counts[1]);
}

template <class Io>
void members(Io& io, judge::Sample& sample) {
    each(io, "input", sample.index, "class", sample.input_class, "images", sample.scenario, "values",
         sample.values, "input_words", sample.inputs, "got_words", sample.got, "want", sample.want, "allowed",
         sample.permitted, "ulp", sample.error.ulp, "abs", sample.error.absolute);
    io.member("outcomes", sample.outcomes, Present::if_any);
}

template <class Io>
void members(Io& io, judge::ErrorSize& guarantee) {
    each(io, "ulp", guarantee.ulp, "abs", guarantee.absolute, "fraction", guarantee.fraction);
}

template <class Io>
void members(Io& io, judge::Budget& budget) {
    each(io, "ulp", budget.ulp, "abs", budget.absolute, "backward_ulp", budget.backward_ulp,
         "of_largest_component", budget.of_largest_component);
    io.member("text", to_text(budget), Present::derived);
}

template <class Io>
void members(Io& io, judge::Coverage::Point& point) {
    io.member("file", point.file, Present::name);
    each(io, "line", point.line, "text", point.text, "way", point.way, "reached", point.reached);
}
GLOAM_MEMBERS(judge::Coverage, inputs, points)

// What the rules permit is calculated only where they alone judge.
template <class Io>
void members(Io& io, judge::Answer& answer) {
    each<Present::name>(io, "equation", answer.equation, "function", answer.function, "file", answer.file,
                        "variant", answer.variant);
    io.member("verdict", answer.criterion);
    each<Present::derived>(io, "outcome", std::string(name_of(answer.outcome())), "not_judged_because",
                           answer.not_judged_because(), "inputs", answer.inputs(), "judged", answer.judged(),
                           "outside", answer.outside(), "recorded", answer.recorded());
    each(io, "by_rules", answer.by_rules, "forbidden", answer.forbidden, "bounded", answer.bounded,
         "unbounded", answer.unbounded, "undefined", answer.undefined, "undefined_at",
         answer.first_undefined);
    if (answer.undefined > 0) io.member("undefined_because", answer.no_result, Present::later);
    each(io, "differs", answer.differs, "max_ulp", answer.largest.ulp, "max_abs", answer.largest.absolute);
    const bool by_rules = answer.rules_alone();
    io.member("width_fraction", answer.fraction, Present::if_given, by_rules);
    io.member("budget_fraction", answer.largest.fraction);
    io.member("guarantee", answer.guarantee, Present::if_given, by_rules);
    io.member("unbounded_at", answer.first_unbounded ? answer.first_unbounded->values : std::string{},
              Present::derived);
    each(io, "budget", answer.budget, "classes", answer.classes);
    io.member("predicate", answer.predicate, Present::later);
    io.member("domain", answer.domain, Present::if_any);
    for (const judge::PredicateCount& c : answer.predicate)
        io.require(c.inputs <= answer.inputs(), "counts within its inputs");
    each(io, "worst", answer.worst, "coverage", answer.coverage, "fault", answer.fault, "error", answer.error,
         "reason", answer.reason, "seconds", answer.seconds, "story", answer.story);
}

// Those that a report names.
struct FloatControls {
    backend::FloatControls& of;
};

template <class Io>
void members(Io& io, FloatControls& controls) {
    each(io, "signed_zero_inf_nan_preserve", controls.of.preserves_signed_zero_inf_nan, "denorm_preserve",
         controls.of.preserves_denormals, "denorm_flush_to_zero", controls.of.flushes_denormals,
         "rounding_mode_rte", controls.of.rounds_to_even);
}

template <class Io>
void members(Io& io, DeviceSummary& device) {
    io.member("name", device.name, Present::name);
    io.member("manifest", device.manifest, Present::if_any);
    each<Present::name>(io, "driver", device.driver, "type", device.type, "api_version", device.api_version);
    FloatControls controls{device.float32};
    io.member("float_controls", controls);
}

}  // namespace gloam::record
