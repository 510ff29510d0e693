// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <span>

#include "record/answer_json.hpp"

namespace gloam::record {
namespace {

using check::Answer;
using check::InputClass;

template <class Value>
Value named(const JsonReader& json, std::string_view name, std::span<const Value> all, const char* expected) {
    for (const Value value : all)
        if (name_of(value) == name) return value;
    json.expected(expected);
}

InputClass class_named(const JsonReader& json, std::string_view name) {
    using enum InputClass;
    constexpr std::array all{ordinary, branch, zero, subnormal, huge, infinite, nan};
    return named<InputClass>(json, name, all, "a class of inputs");
}

}  // namespace

check::Reason value_from(const JsonReader& json, check::Reason) {
    return named<check::Reason>(
        json, json.text(), check::all_reasons,
        "\"\", crash, hang, device lost, out of memory, error, fault, race or divergent barrier");
}
check::Verdict value_from(const JsonReader& json, check::Verdict) {
    constexpr std::array all{check::Verdict::budget, check::Verdict::rules};
    return named<check::Verdict>(json, json.text(), all, "budget or rules");
}
InputClass value_from(const JsonReader& json, InputClass) {
    return class_named(json, json.text());
}

namespace {

// Throws where a total or the outcome is not what the counts of the classes give.
void require_agreement(const JsonReader& json, const Answer& answer) {
    for (const auto& [name, value] : json.member("classes").members())
        (void)class_named(json.member("classes"), name);
    for (const auto& [name, count] : {std::pair{"inputs", answer.inputs()},
                                      {"outside", answer.outside()},
                                      {"recorded", answer.recorded()}}) {
        if (json.member(name).count() != count) json.member(name).expected("the sum over the classes");
    }
    if (json.has("outcome") && json.member("outcome").text() != name_of(answer.outcome()))
        json.member("outcome").expected(fmt::format("{}, by its counts", name_of(answer.outcome())));
    const JsonReader width = json.member("width_fraction");
    if (width.is_null() == (answer.verdict == check::Verdict::rules))
        width.expected("a number where the verdict is rules, else null");
    for (std::size_t i = 0; answer.worst && i < answer.worst->outcomes.size(); ++i)
        if (answer.worst->outcomes[i].size() != answer.worst->permitted.size())
            json.member("worst").member("outcomes").elements()[i].expected("a range for each of \"allowed\"");
}

}  // namespace

Answer read_answer(const JsonReader& json) {
    Answer answer;
    MemberReader::read(json, answer);
    require_agreement(json, answer);
    if (answer.verdict == check::Verdict::budget) answer.fraction = answer.budget_fraction;
    const std::string unbounded_at = json.member("unbounded_at").text();
    if (!unbounded_at.empty()) answer.first_unbounded = check::Sample{.values = unbounded_at};
    return answer;
}

std::string to_json(const Answer& answer) {
    return line_of(answer);
}

Answer answer_from_json(std::string_view text) {
    const nlohmann::ordered_json json = parse_json(text);
    return read_answer(JsonReader(json, ""));
}

}  // namespace gloam::record
