// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "record/check_report.hpp"
#include "record/members.hpp"

// The members of answers and devices, for files and between processes.
namespace gloam::record {

[[nodiscard]] check::Reason value_from(const JsonReader& json, check::Reason);
[[nodiscard]] check::Verdict value_from(const JsonReader& json, check::Verdict);
[[nodiscard]] check::InputClass value_from(const JsonReader& json, check::InputClass);
[[nodiscard]] check::NoResult value_from(const JsonReader& json, check::NoResult);
// With all that follows from an answer's members: the worst input without its fractions, the first unbounded
// input as text alone, and no first failures. Throws where members disagree.
[[nodiscard]] check::Answer value_from(const JsonReader& json, const check::Answer&);

template <class Io>
void members(Io& io, numeric::Bounds& bounds) {
    each(io, "low", bounds.low, "high", bounds.high, "nan", bounds.nan);
}

template <class Io>
void members(Io& io, check::ClassCount& c) {
    each(io, "inputs", c.inputs, "outside", c.outside, "recorded", c.recorded);
    io.member("open", c.open, Present::later);
    io.require(c.recorded <= c.inputs && c.open <= c.inputs - c.recorded && c.outside <= c.inputs,
               "counts within its inputs");
}

template <class Io>
void members(Io& io, check::PredicateCount& c) {
    each(io, "inputs", c.inputs, "judged", c.judged);
    io.require(c.judged <= c.inputs, "counts within its inputs");
}

// The classes that had inputs.
template <class Io>
void members(Io& io, std::array<check::ClassCount, check::input_class_count>& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i)
        io.member(name_of(static_cast<check::InputClass>(i)).data(), counts[i], Present::if_any);
}
template <class Io>
void members(Io& io, std::array<check::PredicateCount, 2>& counts) {
    io.member("false", counts[0], Present::if_any);
    io.member("true", counts[1], Present::if_any);
}

template <class Io>
void members(Io& io, check::Sample& sample) {
    each(io, "input", sample.index, "class", sample.input_class, "images", sample.scenario, "values",
         sample.values, "input_words", sample.inputs, "got_words", sample.got, "want", sample.want, "allowed",
         sample.permitted, "ulp", sample.ulp, "abs", sample.absolute);
    io.member("outcomes", sample.outcomes, Present::if_any);
}

template <class Io>
void members(Io& io, check::Guarantee& guarantee) {
    each(io, "ulp", guarantee.ulp, "abs", guarantee.absolute, "fraction", guarantee.fraction);
}

template <class Io>
void members(Io& io, check::Budget& budget) {
    each(io, "ulp", budget.ulp, "abs", budget.absolute, "backward_ulp", budget.backward_ulp,
         "of_largest_component", budget.of_largest_component);
    io.member("text", to_text(budget), Present::derived);
}

template <class Io>
void members(Io& io, check::Coverage::Point& point) {
    io.member("file", point.file, Present::name);
    each(io, "line", point.line, "text", point.text, "way", point.way, "reached", point.reached);
}
template <class Io>
void members(Io& io, check::Coverage& coverage) {
    each(io, "inputs", coverage.inputs, "points", coverage.points);
}

// What the rules permit is calculated only where the verdict is theirs.
template <class Io>
void members(Io& io, check::Answer& answer) {
    io.member("equation", answer.equation, Present::name);
    io.member("function", answer.function, Present::name);
    io.member("file", answer.file, Present::name);
    io.member("variant", answer.variant, Present::name);
    io.member("verdict", answer.verdict);
    const bool by_rules = answer.verdict == check::Verdict::rules;
    io.member("outcome", std::string(name_of(answer.outcome())), Present::derived);
    io.member("not_judged_because", answer.not_judged_because(), Present::derived);
    io.member("inputs", answer.inputs(), Present::derived);
    io.member("judged", answer.judged(), Present::derived);
    io.member("outside", answer.outside(), Present::derived);
    io.member("recorded", answer.recorded(), Present::derived);
    each(io, "by_rules", answer.by_rules, "forbidden", answer.forbidden, "bounded", answer.bounded,
         "unbounded", answer.unbounded, "undefined", answer.undefined, "undefined_at",
         answer.first_undefined);
    if (answer.undefined > 0) io.member("undefined_because", answer.no_result, Present::later);
    each(io, "differs", answer.differs, "max_ulp", answer.max_ulp, "max_abs", answer.max_absolute);
    io.member("width_fraction", answer.fraction, Present::if_given, by_rules);
    io.member("budget_fraction", answer.budget_fraction);
    io.member("guarantee", answer.guarantee, Present::if_given, by_rules);
    io.member("unbounded_at", answer.first_unbounded ? answer.first_unbounded->values : std::string{},
              Present::derived);
    each(io, "budget", answer.budget, "classes", answer.classes);
    io.member("predicate", answer.predicate, Present::later);
    for (const check::PredicateCount& c : answer.predicate)
        io.require(c.inputs <= answer.inputs(), "counts within its inputs");
    each(io, "worst", answer.worst, "coverage", answer.coverage, "fault", answer.fault, "error", answer.error,
         "reason", answer.reason, "seconds", answer.seconds, "story", answer.story);
}

struct FloatControls {
    DeviceSummary& of;
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
    io.member("driver", device.driver, Present::name);
    io.member("type", device.type, Present::name);
    io.member("api_version", device.api_version, Present::name);
    FloatControls controls{device};
    io.member("float_controls", controls);
}

}  // namespace gloam::record
