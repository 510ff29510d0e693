// SPDX-License-Identifier: MIT
#include "judge/answer.hpp"

#include <fmt/format.h>
#include <cmath>
#include <numeric>
#include <set>

#include "base/text.hpp"
#include "module/steps.hpp"

namespace gloam::judge {

std::string to_text(const Budget& budget) {
    std::string text;
    if (budget.ulp > 0.0)
        text = fmt::format("{:g} ulp{}", budget.ulp,
                           budget.of_largest_component ? " of the largest component" : "");
    if (budget.absolute > 0.0)
        text += fmt::format("{}{:g} absolute", text.empty() ? "" : " or ", budget.absolute);
    if (text.empty()) text = "exact";
    if (budget.backward_ulp > 0) text += fmt::format(" at inputs within {} ulp", budget.backward_ulp);
    return text;
}

namespace {

bool is_worse(const Sample& sample, const std::optional<Sample>& worst) {
    return !worst || sample.fraction > worst->fraction;
}

}  // namespace

std::string_view name_of(Outcome outcome) {
    if (outcome == Outcome::not_judged) return "not judged";
    return outcome == Outcome::ok ? "ok" : "failed";
}

std::size_t AnswerCounts::total(std::size_t ClassCount::* member) const {
    return std::accumulate(
        classes.begin(), classes.end(), std::size_t{0},
        [member](std::size_t sum, const ClassCount& count) { return sum + count.*member; });
}

std::size_t Answer::judged() const {
    const std::size_t promised = inputs() - recorded();
    if (!rules_alone() || bounded == 0) return promised - open();
    return promised * (bounded - std::min(open(), bounded)) / bounded;
}

std::string error_text(const Sample& sample) {
    if (sample.error.ulp == 0.0 && sample.error.absolute == 0.0)
        return "not measured: no accuracy is documented for this input";
    if (std::isinf(sample.error.ulp) && std::isinf(sample.error.absolute))
        return "infinite: an integer, a bool, an infinity or NaN differs, or it is outside the codomain";
    return fmt::format("{:.6g} ulp, {:.6g} absolute", sample.error.ulp, sample.error.absolute);
}

std::vector<InputClass> Answer::not_promised() const {
    std::vector<InputClass> found;
    for (std::size_t i = 0; i < input_class_count; ++i) {
        const ClassCount& c = classes[i];
        const std::size_t without = c.recorded + (rules_alone() ? c.open : 0);
        if (c.inputs > 0 && without == c.inputs) found.push_back(static_cast<InputClass>(i));
    }
    return found;
}

Outcome Answer::outcome() const {
    if (is_no_verdict(reason)) return Outcome::not_judged;
    if (!ran() || outside() > 0 || !fault.empty()) return Outcome::failed;
    return not_judged_because().empty() ? Outcome::ok : Outcome::not_judged;
}

std::string Answer::not_judged_because() const {
    if (is_no_verdict(reason)) return error;
    if (!ran() || outside() > 0 || !fault.empty()) return {};
    if (inputs() == 0) return "there are no inputs";
    const std::string why =
        undefined == 0
            ? ""
            : fmt::format("; {}: {}",
                          no_result == NoResult::too_long ? "it takes too long" : "its result is undefined",
                          first_undefined);
    if (recorded() == inputs() && undefined > 0) return "none of its inputs could be judged" + why;
    if (recorded() == inputs() && rules_alone())
        return "it documents no accuracy, and there are no precision rules for this device";
    if (recorded() == inputs()) return "the device promises nothing for any of its inputs";
    if (judged() == 0) return "every result would pass";
    if (static_cast<double>(judged()) < least_judged_share * static_cast<double>(inputs()))
        return fmt::format("{} of {} inputs could be judged, expected {:.0f} % at least{}", judged(),
                           inputs(), 100.0 * least_judged_share, why);
    for (std::size_t i = 0; i < input_class_count; ++i) {
        const ClassCount& c = classes[i];
        if (!rules_alone() && c.open > 0 && c.open + c.recorded == c.inputs)
            return fmt::format("every result would pass for its {} inputs",
                               name_of(static_cast<InputClass>(i)));
    }
    for (std::size_t i = 0; i < predicate.size(); ++i) {
        if (predicate[i].inputs > 0 && predicate[i].judged == 0)
            return fmt::format(
                "no input could be judged whose result is {}: a function that is always {} "
                "would pass",
                i == 1, i == 0);
    }
    return {};
}

void Answer::add(const Sample& sample, bool is_outside) {
    ++count(sample.input_class).inputs;
    largest.raise(sample.error);
    fraction = std::max(fraction, sample.fraction);
    if (sample.fraction > 0.0 && is_worse(sample, worst)) worst = sample;
    if (sample.forbidden) ++forbidden;
    if (!is_outside) return;
    ++count(sample.input_class).outside;
    auto& first = first_outside.at(static_cast<std::size_t>(sample.input_class));
    if (!first) first = sample;
}

void AnswerCounts::add_predicate(const std::vector<double>& want, bool was_judged) {
    for (std::size_t i = 0; i < predicate.size(); ++i) {
        if (std::ranges::find(want, static_cast<double>(i)) == want.end()) continue;
        ++predicate[i].inputs;
        if (was_judged) ++predicate[i].judged;
    }
}

std::string AnswerIdentity::variant_before_steps() const {
    return variant.substr(0, variant.find(module::step_separator));
}

std::string AnswerIdentity::steps() const {
    const std::size_t at = variant.find(module::step_separator);
    return at == std::string::npos ? "" : variant.substr(at + module::step_separator.size());
}

void Answer::add_undefined(InputClass input_class, NoResult kind, const std::string& why) {
    add_recorded(input_class);
    if (undefined++ > 0) return;
    no_result = kind;
    first_undefined = why;
}

void AnswerCounts::merge(const AnswerCounts& later) {
    for (std::size_t i = 0; i < input_class_count; ++i)
        for (const auto one :
             {&ClassCount::inputs, &ClassCount::outside, &ClassCount::recorded, &ClassCount::open})
            classes[i].*one += later.classes[i].*one;
    for (std::size_t i = 0; i < predicate.size(); ++i)
        for (const auto one : {&PredicateCount::inputs, &PredicateCount::judged})
            predicate[i].*one += later.predicate[i].*one;
    using All = AnswerCounts;
    for (const auto one : {&All::by_rules, &All::forbidden, &All::bounded, &All::unbounded, &All::undefined,
                           &All::distinct, &All::differs})
        this->*one += later.*one;
}

void WorstCases::merge(const WorstCases& later) {
    for (std::size_t i = 0; i < input_class_count; ++i)
        if (!first_outside[i]) first_outside[i] = later.first_outside[i];
    largest.raise(later.largest);
    fraction = std::max(fraction, later.fraction);
    if (first_undefined.empty()) no_result = later.no_result, first_undefined = later.first_undefined;
    if (!first_unbounded) first_unbounded = later.first_unbounded;
    if (later.worst && is_worse(*later.worst, worst)) worst = later.worst;
}

void Answer::merge(const Answer& later) {
    AnswerCounts::merge(later);
    WorstCases::merge(later);
    guarantee.raise(later.guarantee);
}

bool Coverage::is_complete() const {
    return std::ranges::all_of(points, &Point::reached);
}

std::string to_text(const Coverage& coverage) {
    std::array<std::size_t, 2> all{};  // lines, ways
    std::array<std::size_t, 2> reached{};
    std::string missed;
    std::set<std::pair<std::string, unsigned>> missed_lines;
    for (const Coverage::Point& point : coverage.points) {
        const std::size_t kind = point.way.empty() ? 0 : 1;
        ++all.at(kind);
        reached.at(kind) += point.reached ? 1 : 0;
        // If a branch was not reached, its missed line is reported and not its ways.
        if (point.reached || (kind == 1 && missed_lines.contains({point.file, point.line}))) continue;
        if (kind == 0) missed_lines.insert({point.file, point.line});
        missed += fmt::format("\n    {}:{} {}: {}", base::one_line(point.file), point.line,
                              kind == 0 ? "not reached" : "never " + point.way, point.text);
    }
    return fmt::format("lines {} of {}, ways of branches {} of {}, {} inputs{}", reached[0], all[0],
                       reached[1], all[1], coverage.inputs, missed);
}

}  // namespace gloam::judge
