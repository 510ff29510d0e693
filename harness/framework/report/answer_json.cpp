// SPDX-License-Identifier: MIT
#include "report/check_report.hpp"

#include <fmt/format.h>

#include "report/internal/answer_json.hpp"

namespace gloam::report {

using check::Answer;
using nlohmann::ordered_json;

namespace internal {
namespace {

check::Reason read_reason(const JsonReader& json) {
    const std::string text = json.text();
    for (const check::Reason reason : check::all_reasons) {
        if (name_of(reason) == text) return reason;
    }
    json.expected("\"\", crash, hang, device lost, out of memory, error, fault, race or divergent barrier");
}

check::Verdict read_verdict(const JsonReader& json) {
    const std::string text = json.text();
    for (const check::Verdict verdict : {check::Verdict::budget, check::Verdict::rules}) {
        if (name_of(verdict) == text) return verdict;
    }
    json.expected("budget or rules");
}

check::InputClass read_class(const std::string& name, const JsonReader& json) {
    for (std::size_t i = 0; i < check::input_class_count; ++i) {
        const auto input_class = static_cast<check::InputClass>(i);
        if (name_of(input_class) == name) return input_class;
    }
    json.expected("a class of inputs");
}

// The classes that had inputs.
ordered_json classes_json(const Answer& answer) {
    ordered_json json = ordered_json::object();
    for (std::size_t i = 0; i < check::input_class_count; ++i) {
        const check::ClassCount& c = answer.classes[i];
        if (c.inputs == 0) continue;
        json[std::string(name_of(static_cast<check::InputClass>(i)))] = {
            {"inputs", c.inputs}, {"outside", c.outside}, {"recorded", c.recorded}, {"open", c.open}};
    }
    return json;
}

void read_classes(const JsonReader& json, Answer& answer) {
    for (const auto& [name, value] : json.members()) {
        check::ClassCount& c = answer.classes.at(static_cast<std::size_t>(read_class(name, json)));
        c = {.inputs = value.member("inputs").count(),
             .outside = value.member("outside").count(),
             .recorded = value.member("recorded").count(),
             .open = value.has("open") ? value.member("open").count()
                                       : 0};  // results of earlier versions lack it
        if (c.recorded > c.inputs || c.open > c.inputs - c.recorded || c.outside > c.inputs)
            value.expected("counts within its inputs");
    }
}

constexpr std::array predicate_names{"false", "true"};

ordered_json predicate_json(const Answer& answer) {
    ordered_json json = ordered_json::object();
    for (std::size_t i = 0; i < predicate_names.size(); ++i) {
        const check::PredicateCount& c = answer.predicate.at(i);
        if (c.inputs > 0) json[predicate_names.at(i)] = {{"inputs", c.inputs}, {"judged", c.judged}};
    }
    return json;
}

void read_predicate(const JsonReader& json, Answer& answer) {
    for (std::size_t i = 0; i < predicate_names.size(); ++i) {
        if (!json.has(predicate_names.at(i))) continue;
        const JsonReader value = json.member(predicate_names.at(i));
        check::PredicateCount& c = answer.predicate.at(i);
        c = {.inputs = value.member("inputs").count(), .judged = value.member("judged").count()};
        if (c.judged > c.inputs || c.inputs > answer.inputs()) value.expected("counts within its inputs");
    }
}

// Throws where a total or the outcome is not what the counts of the classes give.
void require_agreement(const JsonReader& json, const Answer& answer) {
    for (const auto& [name, count] : {std::pair{"inputs", answer.inputs()},
                                      {"outside", answer.outside()},
                                      {"recorded", answer.recorded()}}) {
        if (json.member(name).count() != count) json.member(name).expected("the sum over the classes");
    }
    if (json.has("outcome") && json.member("outcome").text() != name_of(answer.outcome()))
        json.member("outcome").expected(fmt::format("{}, by its counts", name_of(answer.outcome())));
}

ordered_json outcome_json(const check::Sample::Outcome& outcome) {
    ordered_json json = ordered_json::array();
    for (const numeric::Bounds& a : outcome)
        json.push_back({{"low", number_json(a.low)}, {"high", number_json(a.high)}, {"nan", a.nan}});
    return json;
}

ordered_json sample_json(const std::optional<check::Sample>& sample) {
    if (!sample) return nullptr;
    ordered_json json{{"input", sample->index},
                      {"class", name_of(sample->input_class)},
                      {"images", sample->scenario},
                      {"values", sample->values},
                      {"input_words", sample->inputs},
                      {"got_words", sample->got},
                      {"want", numbers_json(sample->want)},
                      {"allowed", outcome_json(sample->permitted)},
                      {"ulp", number_json(sample->ulp)},
                      {"abs", number_json(sample->absolute)}};
    for (const check::Sample::Outcome& outcome : sample->outcomes)
        json["outcomes"].push_back(outcome_json(outcome));
    return json;
}

check::Sample::Outcome read_outcome(const JsonReader& json) {
    check::Sample::Outcome outcome;
    for (const JsonReader& allowed : json.elements()) {
        outcome.push_back({.low = allowed.member("low").number(),
                           .high = allowed.member("high").number(),
                           .nan = allowed.member("nan").flag()});
    }
    return outcome;
}

std::optional<check::Sample> read_sample(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    check::Sample sample{.index = json.member("input").count(),
                         .input_class = read_class(json.member("class").text(), json.member("class")),
                         .scenario = json.member("images").text(),
                         .values = json.member("values").text(),
                         .inputs = json.member("input_words").words(),
                         .got = json.member("got_words").words(),
                         .want = json.member("want").numbers(),
                         .ulp = json.member("ulp").number(),
                         .absolute = json.member("abs").number(),
                         .permitted = read_outcome(json.member("allowed"))};
    if (!json.has("outcomes")) return sample;
    for (const JsonReader& outcome : json.member("outcomes").elements()) {
        sample.outcomes.push_back(read_outcome(outcome));
        if (sample.outcomes.back().size() != sample.permitted.size())
            outcome.expected("a range for each of \"allowed\"");
    }
    return sample;
}

// Present only if the verdict is by the rules, because only then the permitted results are calculated.
ordered_json guarantee_json(const Answer& answer) {
    if (answer.verdict != check::Verdict::rules) return nullptr;
    return {{"ulp", number_json(answer.guarantee.ulp)},
            {"abs", number_json(answer.guarantee.absolute)},
            {"fraction", number_json(answer.guarantee.fraction)}};
}

check::Guarantee read_guarantee(const JsonReader& json) {
    if (json.is_null()) return {};
    return {.ulp = json.member("ulp").number(),
            .absolute = json.member("abs").number(),
            .fraction = json.member("fraction").number()};
}

ordered_json budget_json(const check::Budget& budget) {
    return {{"ulp", budget.ulp},
            {"abs", budget.absolute},
            {"backward_ulp", budget.backward_ulp},
            {"of_largest_component", budget.of_largest_component},
            {"text", to_text(budget)}};
}

check::Budget read_budget(const JsonReader& json) {
    return {.ulp = json.member("ulp").number(),
            .absolute = json.member("abs").number(),
            .backward_ulp = static_cast<int>(json.member("backward_ulp").count_up_to(1U << 24U)),
            .of_largest_component = json.member("of_largest_component").flag()};
}

ordered_json coverage_json(const std::optional<check::Coverage>& coverage) {
    if (!coverage) return nullptr;
    ordered_json points = ordered_json::array();
    for (const check::Coverage::Point& p : coverage->points)
        points.push_back(
            {{"file", p.file}, {"line", p.line}, {"text", p.text}, {"way", p.way}, {"reached", p.reached}});
    return {{"inputs", coverage->inputs}, {"points", points}};
}

std::optional<check::Coverage> read_coverage(const JsonReader& json) {
    if (json.is_null()) return std::nullopt;
    check::Coverage coverage{.inputs = json.member("inputs").count(), .points = {}};
    for (const JsonReader& point : json.member("points").elements()) {
        coverage.points.push_back({.file = point.member("file").name(),
                                   .line = static_cast<unsigned>(point.member("line").count_up_to(1U << 30U)),
                                   .text = point.member("text").text(),
                                   .way = point.member("way").text(),
                                   .reached = point.member("reached").flag()});
    }
    return coverage;
}

ordered_json width_json(const Answer& answer) {
    return answer.verdict == check::Verdict::rules ? number_json(answer.fraction) : ordered_json(nullptr);
}

}  // namespace

ordered_json answer_json(const Answer& answer) {
    return {{"equation", answer.equation},
            {"function", answer.function},
            {"file", answer.file},
            {"variant", answer.variant},
            {"verdict", name_of(answer.verdict)},
            {"outcome", name_of(answer.outcome())},
            {"not_judged_because", answer.not_judged_because()},
            {"inputs", answer.inputs()},
            {"judged", answer.judged()},
            {"outside", answer.outside()},
            {"recorded", answer.recorded()},
            {"by_rules", answer.by_rules},
            {"forbidden", answer.forbidden},
            {"bounded", answer.bounded},
            {"unbounded", answer.unbounded},
            {"undefined", answer.undefined},
            {"undefined_at", answer.first_undefined},
            {"differs", answer.differs},
            {"max_ulp", number_json(answer.max_ulp)},
            {"max_abs", number_json(answer.max_absolute)},
            {"width_fraction", width_json(answer)},
            {"budget_fraction", number_json(answer.budget_fraction)},
            {"guarantee", guarantee_json(answer)},
            {"unbounded_at", answer.first_unbounded ? answer.first_unbounded->values : std::string{}},
            {"budget", budget_json(answer.budget)},
            {"classes", classes_json(answer)},
            {"predicate", predicate_json(answer)},
            {"worst", sample_json(answer.worst)},
            {"coverage", coverage_json(answer.coverage)},
            {"fault", answer.fault},
            {"error", answer.error},
            {"reason", name_of(answer.reason)},
            {"seconds", answer.seconds},
            {"story", answer.story}};
}

Answer read_answer(const JsonReader& json) {
    Answer answer{.equation = json.member("equation").name(),
                  .function = json.member("function").name(),
                  .file = json.member("file").name(),
                  .variant = json.member("variant").name(),
                  .verdict = read_verdict(json.member("verdict")),
                  .budget = read_budget(json.member("budget")),
                  .max_ulp = json.member("max_ulp").number(),
                  .max_absolute = json.member("max_abs").number(),
                  .budget_fraction = json.member("budget_fraction").number(),
                  .by_rules = json.member("by_rules").count(),
                  .forbidden = json.member("forbidden").count(),
                  .bounded = json.member("bounded").count(),
                  .guarantee = read_guarantee(json.member("guarantee")),
                  .unbounded = json.member("unbounded").count(),
                  .undefined = json.member("undefined").count(),
                  .first_undefined = json.member("undefined_at").text(),
                  .worst = read_sample(json.member("worst")),
                  .differs = json.member("differs").count(),
                  .coverage = read_coverage(json.member("coverage")),
                  .fault = json.member("fault").text(),
                  .error = json.member("error").text(),
                  .reason = read_reason(json.member("reason")),
                  .seconds = json.member("seconds").number(),
                  .story = json.member("story").text()};
    read_classes(json.member("classes"), answer);
    if (json.has("predicate")) read_predicate(json.member("predicate"), answer);  // earlier versions lack it
    require_agreement(json, answer);
    const JsonReader width = json.member("width_fraction");
    const bool by_rules = answer.verdict == check::Verdict::rules;
    if (width.is_null() == by_rules) width.expected("a number where the verdict is rules, else null");
    answer.fraction = by_rules ? width.number() : answer.budget_fraction;
    const std::string unbounded_at = json.member("unbounded_at").text();
    if (!unbounded_at.empty()) answer.first_unbounded = check::Sample{.values = unbounded_at};
    return answer;
}

}  // namespace internal

std::string to_json(const Answer& answer) {
    return internal::answer_json(answer).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Answer answer_from_json(std::string_view text) {
    const ordered_json json = parse_json(text);
    return internal::read_answer(JsonReader(json, ""));
}

}  // namespace gloam::report
