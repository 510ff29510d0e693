// SPDX-License-Identifier: MIT
#include "record/answer_json.hpp"

#include <fmt/format.h>

namespace gloam::record {

using check::Answer;
using check::InputClass;

namespace {

// The enumerators are counted from 0.
template <class Value>
Value named(const JsonReader& json, std::string_view name, std::size_t count, const char* expected) {
    for (std::size_t i = 0; i < count; ++i)
        if (name_of(static_cast<Value>(i)) == name) return static_cast<Value>(i);
    json.expected(expected);
}

InputClass class_named(const JsonReader& json, std::string_view name) {
    return named<InputClass>(json, name, check::input_class_count, "a class of inputs");
}

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

check::Reason value_from(const JsonReader& json, check::Reason) {
    return named<check::Reason>(
        json, json.text(), base::reason_names.size(),
        "\"\", crash, hang, device lost, out of memory, error, fault, race or divergent barrier");
}
check::Verdict value_from(const JsonReader& json, check::Verdict) {
    return named<check::Verdict>(json, json.text(), 2, "budget or rules");
}
check::NoResult value_from(const JsonReader& json, check::NoResult) {
    return named<check::NoResult>(json, json.text(), 2, "undefined or too long");
}
InputClass value_from(const JsonReader& json, InputClass) {
    return class_named(json, json.text());
}

Answer value_from(const JsonReader& json, const Answer&) {
    Answer answer;
    MemberReader<Form::whole> reader(json);
    members(reader, answer);
    require_agreement(json, answer);
    if (answer.verdict == check::Verdict::budget) answer.fraction = answer.budget_fraction;
    const std::string unbounded_at = json.member("unbounded_at").text();
    if (!unbounded_at.empty()) answer.first_unbounded = check::Sample{.values = unbounded_at};
    return answer;
}

}  // namespace gloam::record
